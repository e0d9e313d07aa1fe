//! Twenty equal cranks that carry one beam: eighteen rows follow from the others for ever, and each is damped.

use super::run;
use mbs_runtime::{Settings, mechanism};

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

/// The angle of one crank after `time` seconds, by the classical Runge–Kutta method on the minimal coordinate.
fn crank_angle(time: f64) -> f64 {
    let (length, cranks, mass, beam, damping) = (0.5, 20.0, 1.0, 2.0, 0.2);
    let inertia = cranks * mass * length * length / 3.0 + beam * length * length;
    let weight = 9.81 * length * (cranks * mass / 2.0 + beam);
    let rate = |[angle, speed]: [f64; 2]| {
        let moment = -weight * f64::cos(angle) - damping * speed;
        [speed, moment / inertia]
    };
    let h = 1e-4;
    let mut x = [-60f64.to_radians(), 0.0];
    for _ in 0..(time / h).round() as usize {
        let along = |k: [f64; 2], s: f64| [x[0] + s * k[0], x[1] + s * k[1]];
        let k1 = rate(x);
        let k2 = rate(along(k1, 0.5 * h));
        let k3 = rate(along(k2, 0.5 * h));
        let k4 = rate(along(k3, h));
        for i in 0..2 {
            x[i] += h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
        }
    }
    x[0]
}

#[test]
fn redundant_rows_move_like_one_crank() {
    let errors = [8e-3, 4e-3].map(|step| {
        let settings = Settings {
            step,
            ..Settings::default()
        };
        let end = run(Swing {}, settings, 0.4);
        assert!(end.rows < 1e-10, "{}", end.rows);
        (end.positions[2] - crank_angle(0.4)).abs()
    });
    assert!(
        errors[0] < 5e-4 && errors[1] < 0.3 * errors[0],
        "{errors:?}"
    );
}
