//! A beam of bodies on bushings that turns in space: factors turn with its bodies.

use super::settings;
use mbs_runtime::{Simulation, mechanism};

mechanism!(Beam {
    world: Spatial(gravity = [0.0, 0.0, 0.0]),
    spin: Param(3.0_rad_per_s),
    block: Each(0..26, |i| Body(
        mass = 0.5_kg,
        inertia = diag(1.0e-3_kg_m2, 1.2e-3, 1.5e-3),
        at = [i * 0.2_m - 2.5_m, 0.0, 0.0],
        velocity = [0.0, spin * (i * 0.2_m - 2.5_m), 0.0],
        angular_velocity = [0.0, 0.0, spin]
    )),
    bushing: Each(1..26, |i| Bushing(
        block[i - 1],
        block[i],
        at = [i * 0.2_m - 2.6_m, 0.0, 0.0],
        stiffness = 5e4_N_per_m,
        damping = 5.0_N_s_per_m,
        torsion_stiffness = 2e3_Nm,
        torsion_damping = 5.0_N_m_s
    )),
});

/// Factors are made 25 times; 112 times if they stay as they were made.
#[test]
fn factors_turn_with_the_bodies() {
    let mut simulation =
        Simulation::with_settings(Beam::default(), settings(5e-3, None)).expect("it assembles");
    let mut made = vec![];
    for _ in 0..400 {
        simulation.step().expect("it runs");
        let factors = simulation.state().factors.as_ref();
        made.push(factors.expect("the step is sparse").time);
    }
    made.dedup();
    assert!(made.len() < 50, "{made:?}");
    let energy = simulation.energy();
    assert!(energy.error.abs() < 1e-3 * energy.kinetic, "{energy:?}");
}

/// What corrections leave of a step is a small part of its error, which stays that of the method: 253 corrections beyond the
/// first one in 250 steps of 2 ms, 495 down to round-off, where the distances differ by 8e-9 of themselves.
#[test]
fn corrections_end_below_the_error_of_a_step() {
    let [coarse, fine, finest] = [2e-3, 1e-3, 5e-4].map(|step| {
        let mut simulation =
            Simulation::with_settings(Beam::default(), settings(step, None)).expect("it assembles");
        simulation.run_until(0.5).expect("it runs");
        let report = simulation.report();
        assert!(report.iterations < 300 * report.steps / 250, "{report:?}");
        simulation.state().positions
    });
    let ratio = (coarse - fine).norm() / (fine - finest).norm();
    assert!((ratio - 4.0).abs() < 0.1, "{ratio}");
}
