//! Drives, and singular poses: the work of a drive, and steps for a tolerance where rows determine the whole motion.

use mbs_runtime::{Settings, Simulation, SimulationError, mechanism, methods};
use std::f64::consts::TAU;

mechanism!(Shaken {
    doc: "A parallelogram on a base that a drive shakes; the brake needs the implicit step.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    phase: Param(-0.4),
    base: Body(
        mass = 1.0_kg,
        inertia = 1.0_kg_m2,
        velocity = [0.5_m_per_s, 0.0]
    ),
    left: Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        angle = phase,
        rate = 1.3_rad_per_s
    ),
    right: Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        angle = phase,
        rate = 1.3_rad_per_s
    ),
    coupler: Bar(mass = 1.0_kg, length = 1.0_m),
    upright: Holonomic(base.angle),
    rail: PointOnLine(base.origin, ground.origin, axis = X),
    shaking: Drive(base.origin.x, value = 0.1_m * sin(5.0_rad_per_s * t)),
    left_pivot: Revolute(base.origin, left.a),
    right_pivot: Revolute(base.point(1.0, 0.0), right.a),
    left_pin: Revolute(left.b, coupler.a),
    right_pin: Revolute(right.b, coupler.b),
    brake: TorsionSpring(base, left, damping = 0.01_N_m_s),
});

mechanism!(Folding {
    doc: "A slider-crank with two equal rods, driven through the pose in which the slider is below its bearing.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    phase: Param(-1.1),
    rate: Param(-1.6_rad_per_s),
    damping: Param(0.001_N_m_s),
    crank: Bar(mass = 1.0_kg, length = 1.0_m, angle = phase, rate = rate),
    rod: Bar(mass = 1.0_kg, length = 1.0_m, angle = -phase, rate = -rate),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),
    drive: Drive(crank.angle, value = phase + rate * t),
    brake: TorsionSpring(crank, rod, damping = damping),
    // Zero where the rods fold; on the other branch the slider stays below the bearing.
    astray: Output(rod.b.x - 2.0 * crank.b.x),
});

fn energy_error(step: f64) -> Result<f64, SimulationError> {
    let settings = Settings {
        order: 2,
        step,
        ..Settings::default()
    };
    let mut simulation = Simulation::with_settings(Shaken::default(), settings)?;
    simulation.run_until(0.4)?;
    Ok(simulation.report().energy_error)
}

/// In the implicit step the multipliers act on both ends of a step alike.
#[test]
fn the_work_of_a_drive_has_the_order_of_the_step() {
    let errors = [0.02, 0.01, 0.005].map(|step| energy_error(step).expect("it runs"));
    for pair in errors.windows(2) {
        let ratio = pair[0] / pair[1];
        assert!((3.7..4.3).contains(&ratio), "{errors:?}");
    }
    assert!(errors[2] < 1e-4, "{errors:?}");
}

/// Every step satisfies the rows, so that steps of any length agree about the motion.
#[test]
fn a_tolerance_has_short_steps_where_rows_determine_the_motion() {
    for number in 0..24 {
        let part = f64::from(number) / 24.0;
        let folding = Folding {
            phase: TAU * (part - 0.5),
            rate: [1.0, -1.0][number as usize % 2] * (1.2 + 2.0 * part),
            ..Folding::default()
        };
        let tolerance = 10_f64.powf(-3.0 - 2.0 * part);
        for settings in [
            Settings::for_tolerance(tolerance),
            Settings::accuracy(tolerance),
        ] {
            let mut simulation = Simulation::with_methods(folding, settings, methods::Projected)
                .expect("it assembles");
            let mut kinetic: f64 = 0.0;
            while simulation.time() < 10.0 {
                simulation.step().expect("it goes on");
                kinetic = kinetic.max(simulation.energy().kinetic);
                let astray = simulation.outputs().astray;
                assert!(
                    astray.abs() < 1e-6,
                    "{number}: {astray} at {}",
                    simulation.time()
                );
            }
            let error = simulation.report().energy_error;
            assert!(
                error < 0.1 * kinetic,
                "{number}, {settings:?}: {error} of {kinetic}"
            );
        }
    }
}

/// A drive gives the energy for another branch, of order 8 even in one long pair; and in short pieces each pair moved too little
/// to be judged by its energy.
#[test]
fn pairs_of_a_driven_mechanism_are_judged_by_their_turning_and_in_short_pieces() {
    let long = Folding {
        phase: -0.027783456014549537,
        rate: -2.0893033028648986,
        damping: 0.022380342450652006,
    };
    let settings = Settings {
        order: 8,
        ..Settings::for_tolerance(3.246596887841254e-8)
    };
    let mut simulation = Simulation::with_settings(long, settings).expect("it assembles");
    while simulation.time() < 5.0 {
        simulation.step().expect("it goes on");
        assert!(simulation.outputs().astray.abs() < 1e-6);
    }

    let short = Folding {
        phase: 0.8339864306261487,
        rate: 1.158553550071618,
        damping: 0.15106081330047738,
    };
    let settings = Settings::accuracy(0.00039854480355386735);
    let mut simulation =
        Simulation::with_methods(short, settings, methods::Projected).expect("it assembles");
    let mut kinetic: f64 = 0.0;
    for piece in 1..=780 {
        let end = f64::from(piece) * 0.006424514057264457;
        simulation.run_until(end).expect("it goes on");
        kinetic = kinetic.max(simulation.energy().kinetic);
    }
    // Before 0.11.
    assert!(simulation.report().energy_error < 0.02 * kinetic);
}
