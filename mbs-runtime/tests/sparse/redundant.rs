//! Twenty equal cranks that carry one beam: eighteen rows follow from the others for ever, and each is damped.

use super::crank::Crank;
use super::{run, settings};
use mbs_runtime::{Simulation, mechanism};

/// Of all bars and the beam, N, and what holds them on their circle.
const WEIGHT: f64 = 3.0 * 22.0 * 9.81;

mechanism!(Swing {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Reference),
    crank: Each(0..20, |k| Bar(
        mass = 1.0_kg,
        length = 0.5_m,
        angle = -60.0_deg
    )),
    beam: Body(
        mass = 2.0_kg,
        inertia = 1.0_kg_m2,
        at = [0.25_m, -0.4330127018922193_m]
    ),
    foot: Each(0..20, |k| Revolute(
        ground.point(k * 0.1_m, 0.0),
        crank[k].a
    )),
    pin: Each(0..20, |k| Revolute(crank[k].b, beam.point(k * 0.1_m, 0.0))),
    damper: Each(0..20, |k| TorsionSpring(
        ground,
        crank[k],
        damping = 0.01_N_m_s
    )),
});

#[test]
fn redundant_rows_move_like_one_crank() {
    let crank = Crank {
        inertia: 20.0 * 0.25 / 3.0 + 2.0 * 0.25,
        moment: 9.81 * 0.5 * (20.0 / 2.0 + 2.0),
        damping: 0.2,
    };
    let angle = crank.angle([-60f64.to_radians(), 0.0], 0.4);
    let errors = [8e-3, 4e-3].map(|step| {
        let end = run(Swing {}, settings(step, None), 0.4);
        assert!(end.rows < 1e-10, "{}", end.rows);
        (end.positions[2] - angle).abs()
    });
    assert!(
        errors[0] < 5e-4 && errors[1] < 0.3 * errors[0],
        "{errors:?}"
    );
}

/// Multipliers along a combination of rows that has no force are round-off. What was extrapolated from step to step grew in
/// proportion to the time.
#[test]
fn combinations_without_force_carry_nothing() {
    let mut simulation = Simulation::with_settings(Swing {}, settings(4e-3, None)).unwrap();
    simulation.run_until(4.0).unwrap();
    let multipliers = simulation.state().multipliers;
    let largest = multipliers.amax();
    assert!(largest < WEIGHT, "{largest:.1e} N");
}
