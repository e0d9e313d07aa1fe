//! Poses that are nearly singular: the motion turns away from another branch within a way that steps can leap over.

use mbs_runtime::nalgebra::SVector;
use mbs_runtime::{Settings, Simulation, mechanism};

mechanism!(NearParallelogram {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    shortfall: Param(1e-6_m),
    turning: Let(-1.0_rad_per_s),
    base: Point([1.0_m - shortfall, 0.0_m]),
    left: Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        angle = 90.0_deg,
        rate = turning
    ),
    right: Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        angle = 90.0_deg,
        rate = turning
    ),
    coupler: Bar(mass = 1.0_kg, length = 1.0_m),
    left_bearing: Revolute(ground.origin, left.a),
    right_bearing: Revolute(base, right.a),
    left_pin: Revolute(left.b, coupler.a),
    right_pin: Revolute(right.b, coupler.b),
});

/// Past two poses: at 0.708 s and 1.061 s for a shortfall of 1e-6 m.
const END: f64 = 1.2;

fn run(shortfall: f64, settings: Settings) -> (SVector<f64, 4>, u64) {
    let mechanism = NearParallelogram { shortfall };
    let mut simulation = Simulation::with_settings(mechanism, settings).unwrap();
    simulation.run_until(END).unwrap();
    (*simulation.positions(), simulation.report().stages)
}

/// Steps of 4e-5 s end within 5e-9 m of it.
fn right(shortfall: f64) -> SVector<f64, 4> {
    let fine = Settings {
        order: 8,
        step: 2e-3,
        ..Settings::default()
    };
    run(shortfall, fine).0
}

/// Without a look at the poses ahead a third of such runs ended on the other branch.
#[test]
fn fixed_steps_follow_the_branch() {
    for shortfall in [1e-4, 1e-6] {
        let right = right(shortfall);
        for (order, bound) in [(2, 0.05), (4, 1e-4), (6, 2e-6), (8, 2e-7)] {
            for step in [1e-3, 3e-3, 5e-3, 7e-3, 1e-2, 1.4e-2, 2e-2, 3e-2] {
                let settings = Settings {
                    order,
                    step,
                    ..Settings::default()
                };
                let (end, stages) = run(shortfall, settings);
                let apart = (end - right).amax();
                let what = format!("{shortfall} m, order {order}, step {step:e} s");
                println!("{what}: {apart:.1e} m, {stages} stages");
                assert!(apart < bound, "{what}: {apart} m");
            }
        }
    }
}

/// The energy is that of the motion on either branch. Without a look at what is between the ends of two steps 24 of these
/// runs ended on the other one.
#[test]
fn tolerances_follow_the_branch() {
    for shortfall in [1e-4, 1e-6] {
        let right = right(shortfall);
        for order in [4, 6, 8] {
            for number in 0..=14 {
                let tolerance = 10_f64.powf(-9.0 + 3.0 / 7.0 * f64::from(number));
                let settings = Settings {
                    order,
                    ..Settings::for_tolerance(tolerance)
                };
                let (end, stages) = run(shortfall, settings);
                let apart = (end - right).amax();
                let what = format!("{shortfall} m, order {order}, tolerance {tolerance:.1e}");
                println!("{what}: {apart:.1e} m, {stages} stages");
                // The poses multiply errors.
                assert!(apart < 1e-5 + 100.0 * tolerance, "{what}: {apart} m");
            }
        }
    }
}

/// Where the bars have the length of the base the branches meet: it is a singular pose, which steps pass.
#[test]
fn singular_poses_are_passed() {
    for number in 0..=12 {
        let tolerance = 10_f64.powf(-9.0 + 0.5 * f64::from(number));
        let (end, stages) = run(0.0, Settings::for_tolerance(tolerance));
        println!("tolerance {tolerance:.1e}: {stages} stages");
        // A parallelogram on the way.
        assert!((end[2] - end[0] - 1.0).abs() < 1e-9, "{tolerance:e}: {end}");
        assert!((end[3] - end[1]).abs() < 1e-9, "{tolerance:e}: {end}");
        assert!(stages < 6000, "{tolerance:e}: {stages} stages");
    }
}
