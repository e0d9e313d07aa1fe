//! Fifteen parallelograms in a row, damped: all their bars are in line twice in a turn, and all loops are singular there.

use super::crank::Crank;
use super::settings;
use mbs_runtime::{Simulation, mechanism};

mechanism!(Row {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    turning: Let(-1.0_rad_per_s),
    damping: Param(0.01_N_m_s),
    crank: Each(0..16, |i| Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        angle = 90.0_deg,
        rate = turning
    )),
    coupler: Each(1..16, |i| Bar(mass = 1.0_kg, length = 1.0_m)),
    foot: Each(0..16, |i| Revolute(
        ground.point(i * 1.0_m, 0.0),
        crank[i].a
    )),
    left: Each(1..16, |i| Revolute(crank[i - 1].b, coupler[i].a)),
    right: Each(1..16, |i| Revolute(coupler[i].b, crank[i].b)),
    damper: Each(0..16, |i| TorsionSpring(
        ground,
        crank[i],
        damping = damping
    )),
    tip: Output(crank[0].b),
});

#[test]
fn singular_poses_are_passed_on_the_branch() {
    let crank = Crank {
        inertia: 16.0 / 3.0 + 15.0,
        moment: 9.81 * (16.0 / 2.0 + 15.0),
        damping: 0.16,
    };
    let angle = crank.angle([90f64.to_radians(), -1.0], 4.0);
    // The steps end before the poses, in them, and behind them.
    for step in [2e-2, 1.7e-2, 1.3e-2, 1e-2] {
        let mut simulation =
            Simulation::with_settings(Row { damping: 0.01 }, settings(step, None)).unwrap();
        simulation.run_until(4.0).unwrap();
        let tip = simulation.outputs().tip;
        let error = f64::hypot(tip[0] - angle.cos(), tip[1] - angle.sin());
        assert!(error < 10.0 * step * step, "{step}: {error}");
        assert!(simulation.report().holonomic_error < 1e-10);
    }
}
