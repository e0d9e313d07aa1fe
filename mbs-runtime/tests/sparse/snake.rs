//! A snake on wheels: a rheonomic row for each joint, and nonholonomic ones.

use super::{apart, run};
use mbs_runtime::{Flow, Settings, mechanism};

mechanism!(Snake {
    world: Planar(gravity = [0.0, 0.0], coordinates = Reference),
    link: Each(0..18, |k| Bar(
        mass = 0.1_kg,
        from = [k * 0.1_m, 0.0],
        to = [(k + 1) * 0.1_m, 0.0]
    )),
    joint: Each(1..18, |k| Revolute(link[k - 1].b, link[k].a)),
    bend: Each(1..18, |k| Holonomic(
        link[k].angle - link[k - 1].angle - 0.2 * sin(3.0_rad_per_s * t - 0.4 * k)
    )),
    slip: Each(0..2, |k| Nonholonomic(dot(
        link[k].center.velocity,
        link[k].y
    ))),
});

fn settings(step: f64, flow: Option<Flow>) -> Settings {
    Settings {
        step,
        flow,
        ..Settings::default()
    }
}

#[test]
fn sparse_and_dense_factors_have_the_same_limit() {
    let ends = [2e-2, 1e-2].map(|step| {
        let [sparse, dense] = [Some(Flow::Implicit), Some(Flow::Leapfrog)]
            .map(|flow| run(Snake {}, settings(step, flow), 0.4));
        assert!(sparse.rows < 1e-11, "{}", sparse.rows);
        apart(&sparse, &dense)
    });
    assert!(ends[0] < 1e-3 && ends[1] < 0.3 * ends[0], "{ends:?}");
}
