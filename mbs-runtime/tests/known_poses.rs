//! Singular poses of a mechanism of one degree of freedom, each of which is looked at once.

use mbs_runtime::{Method, Settings, Simulation, mechanism};

mechanism!(Folding {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    turning: Let(2.0_rad_per_s),
    crank: Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        angle = 45.0_deg,
        rate = turning
    ),
    rod: Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        angle = -45.0_deg,
        rate = -turning
    ),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),
});

/// Two poses, each passed twice.
const POSES: f64 = 7.0;
const END: f64 = 14.0;

fn settings(method: Method, tolerance: f64) -> Settings {
    Settings {
        method,
        order: 8,
        step: 1e-2,
        tolerance: Some(tolerance),
        ..Settings::default()
    }
}

/// The poses were no part of the state, and a copy had no room for any: both looked at each pose whenever they passed it, and
/// chose other steps than the run itself.
#[test]
fn copies_and_resumed_runs_know_them() {
    for (method, tolerance) in [
        (Method::Projected, 1e-2),
        (Method::Projected, 1e-5),
        (Method::TwoLevel, 1e-3),
    ] {
        let settings = settings(method, tolerance);
        let start = || Simulation::with_any_method(Folding::default(), settings).unwrap();
        let mut whole = start();
        whole.run_until(POSES).unwrap();
        assert!(whole.report().rank_losses >= 4, "{:?}", whole.report());
        let state = whole.state().clone();
        let mut resumed =
            Simulation::resume_with_any_method(Folding::default(), settings, state).unwrap();
        let mut copy = start().clone();
        copy.run_until(POSES).unwrap();
        assert_eq!(copy.report(), whole.report());
        for simulation in [&mut whole, &mut resumed, &mut copy] {
            simulation.run_until(END).unwrap();
        }
        assert_eq!(copy.report(), whole.report());
        assert!(
            copy.state() == whole.state(),
            "{method:?}, {tolerance:e}: copied"
        );
        assert!(
            resumed.state() == whole.state(),
            "{method:?}, {tolerance:e}: resumed"
        );
    }
}
