//! Wheel suspensions, each written once and used twice.

use mbs_parts::spatial::{DoubleWishbone, McPhersonStrut};
use mbs_runtime::{Settings, Simulation, mechanism};

mechanism!(Car {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2], coordinates = Joint),
    chassis: Body(
        mass = 800.0_kg,
        inertia = Cuboid(3.0_m, 1.2_m, 0.8_m),
        at = [0.0_m, 0.0, 0.5]
    ),
    front: Each([1.0, -1.0], |side| Assembly(
        DoubleWishbone,
        chassis = chassis,
        at = [1.2_m, 0.75_m * side, 0.3_m],
        side = side,
        mount = chassis.point(1.2_m, 0.45_m * side, 0.25_m),
        rack = chassis.point(1.08_m, 0.35_m * side, -0.2_m)
    )),
    rear: Each([1.0, -1.0], |side| Assembly(
        McPhersonStrut,
        chassis = chassis,
        at = [-1.2_m, 0.75_m * side, 0.3_m],
        side = side,
        rack = chassis.point(-1.32_m, 0.35_m * side, -0.2_m)
    )),
    tyre: Let(2e5_N_per_m),
    front_tyre: Each(0..2, |i| Force(
        front[i].upright.origin,
        value = [0.0_N, 0.0, tyre * (0.3_m - front[i].upright.origin.z)]
    )),
    rear_tyre: Each(0..2, |i| Force(
        rear[i].upright.origin,
        value = [0.0_N, 0.0, tyre * (0.3_m - rear[i].upright.origin.z)]
    )),
    height: Output(chassis.origin.z),
});

#[test]
fn mirror_images_move_alike() {
    let settings = Settings {
        step: 2e-3,
        ..Settings::default()
    };
    let mut simulation = Simulation::with_settings(Car::default(), settings).expect("it assembles");
    simulation.run_until(0.5).expect("it runs");
    let out = simulation.outputs();
    let [left, right] = out.front.map(|corner| corner.wheel_center);
    assert!((left[0] - right[0]).abs() < 1e-7 && (left[2] - right[2]).abs() < 1e-7);
    assert!((left[1] + right[1]).abs() < 1e-7);
    let [left, right] = out.rear.map(|corner| corner.wheel_center);
    assert!((left[2] - right[2]).abs() < 1e-7 && (left[1] + right[1]).abs() < 1e-7);
    // The springs carry the chassis.
    assert!(out.height > 0.25 && out.height < 0.55, "{}", out.height);
}
