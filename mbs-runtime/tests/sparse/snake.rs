//! A snake on wheels: a rheonomic row for each joint, and nonholonomic ones.

use super::{have_the_same_limit, run, settings};
use mbs_runtime::{Flow, mechanism};

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

#[test]
fn sparse_and_dense_factors_have_the_same_limit() {
    have_the_same_limit([2e-2, 1e-2], Flow::Leapfrog, |step, flow| {
        run(Snake {}, settings(step, flow), 0.4)
    });
}
