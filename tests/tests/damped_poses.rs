//! Damped parallelograms through the poses in which all bars are level, with extrapolated steps.

use mbs_runtime::{Settings, Simulation, mechanism};

mechanism!(Parallelograms {
    doc: "Three cranks, two couplers; the brake needs steps that are extrapolated.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    phase: Param(-0.4),
    rate: Param(1.3_rad_per_s),
    damping: Param(0.01_N_m_s),
    left: Bar(mass = 1.0_kg, length = 1.0_m, angle = phase, rate = rate),
    middle: Bar(mass = 1.0_kg, length = 1.0_m, angle = phase, rate = rate),
    right: Bar(mass = 1.0_kg, length = 1.0_m, angle = phase, rate = rate),
    first: Bar(mass = 1.0_kg, length = 1.0_m),
    second: Bar(mass = 1.0_kg, length = 1.0_m),
    left_pivot: Revolute(ground.origin, left.a),
    middle_pivot: Revolute(ground.point(1.0, 0.0), middle.a),
    right_pivot: Revolute(ground.point(2.0, 0.0), right.a),
    left_pin: Revolute(left.b, first.a),
    middle_pin: Revolute(middle.b, first.b),
    middle_pin_too: Revolute(middle.b, second.a),
    right_pin: Revolute(right.b, second.b),
    brake: TorsionSpring(ground, left, damping = damping),
    // Zero where all cranks turn alike.
    astray: Output(abs(middle.b.y - left.b.y) + abs(right.b.y - left.b.y)),
});

/// The largest `astray` over five seconds, of steps or of pieces.
fn astray(mechanism: Parallelograms, settings: Settings, piece: Option<f64>) -> f64 {
    let mut simulation = Simulation::with_settings(mechanism, settings).expect("it assembles");
    let (mut most, mut count) = (0.0_f64, 0.0);
    while simulation.time() < 5.0 {
        count += 1.0;
        let moved = match piece {
            Some(piece) => simulation.run_until(count * piece),
            None => simulation.step(),
        };
        moved.expect("it goes on");
        most = most.max(simulation.outputs().astray);
    }
    most
}

/// In these runs a part of a step ended 1e-5 times the step beside a pose, and turned into another branch: in one column
/// alone, late in the step, so that its way differed little; or in the middle of the step, where parts of all columns end. The
/// rows of the mechanism that is declared beside a pose had been measured by their lengths there.
#[test]
fn no_part_of_an_extrapolated_step_ends_beside_a_pose() {
    for (phase, rate, step) in [
        (3.1338339199999994, 1.0287440000000174, 0.02592274635523667),
        (
            -0.006665160000000015,
            -2.925387999999998,
            0.029064910128174647,
        ),
        (
            -0.010682879999999386,
            2.4099840000000086,
            0.008239803413243254,
        ),
    ] {
        let mechanism = Parallelograms {
            phase,
            rate,
            ..Default::default()
        };
        let settings = Settings {
            order: 4,
            step,
            ..Settings::default()
        };
        let most = astray(mechanism, settings, None);
        assert!(most < 1e-9, "{step}: {most}");
    }
}

/// A pair of steps and what it was compared with had turned alike; a tenth of the kinetic energy was lost there.
#[test]
fn a_pair_that_loses_energy_is_not_kept() {
    let mechanism = Parallelograms {
        phase: 0.12515086047879934,
        rate: -1.0608139984902327,
        damping: 0.0013240401050585873,
    };
    let settings = Settings {
        order: 6,
        ..Settings::for_tolerance(7.28302519304363e-5)
    };
    let most = astray(mechanism, settings, Some(0.23579818325880367));
    assert!(most < 1e-9, "{most}");
}
