//! Platforms on legs that are one assembly.

use mbs_parts::spatial::{Hexapod, Leg};
use mbs_runtime::{Mechanism, Settings, Simulation, assembly, mechanism};

assembly!(Tripod {
    world: Spatial(),
    plate: Body(
        mass = 10.0_kg,
        inertia = Cylinder(0.5_m, 0.05_m, Z),
        at = [0.0_m, 0.0, 1.0]
    ),
    leg: Each(0..3, |i| Assembly(
        Leg,
        base = ground,
        platform = plate,
        foot = [
            1.0_m * cos(i * 120.0_deg),
            1.0_m * sin(i * 120.0_deg),
            0.0_m
        ],
        head = [
            0.5_m * cos(i * 120.0_deg + 0.2),
            0.5_m * sin(i * 120.0_deg + 0.2),
            1.0_m
        ]
    )),
    pose: Output(plate.origin),
    tilt: Output(plate.z),
});

mechanism!(ByJoints {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2], coordinates = Joint),
    tripod: Assembly(Tripod),
});

mechanism!(ByBodies {
    world: Spatial(
        gravity = [0.0, 0.0, -9.81_m_per_s2],
        coordinates = Reference
    ),
    tripod: Assembly(Tripod),
});

#[test]
fn the_motion_is_that_of_other_coordinates() {
    let settings = Settings {
        order: 8,
        step: 5e-3,
        ..Settings::default()
    };
    let forces = [60.0, 50.0, 75.0];
    let mut one = Simulation::with_settings(ByJoints::default(), settings).expect("it assembles");
    let mut two = Simulation::with_settings(ByBodies::default(), settings).expect("it assembles");
    assert_ne!(one.positions().len(), two.positions().len());
    for (leg, force) in forces.into_iter().enumerate() {
        one.inputs_mut().tripod.leg[leg].force = force;
        two.inputs_mut().tripod.leg[leg].force = force;
    }
    one.run_until(0.2).expect("it runs");
    two.run_until(0.2).expect("it runs");
    let (one, two) = (one.outputs().tripod, two.outputs().tripod);
    let apart = (one.pose - two.pose)
        .norm()
        .max((one.tilt - two.tilt).norm());
    assert!(apart < 1e-10, "{apart}");
    assert_eq!(ByJoints::MODEL.inputs[2].name, "tripod.leg[2].force");
}

// The legs follow the pose that is asked for.
mechanism!(Driven {
    world: Spatial(coordinates = Joint),
    plate: Body(
        mass = 10.0_kg,
        inertia = Cylinder(0.5_m, 0.05_m, Z),
        at = [0.0_m, 0.0, 1.0]
    ),
    legs: Assembly(Hexapod, base = ground, platform = plate),
    way: Let([
        0.1_m * sin(2.0_per_s * t),
        0.05_m * (1.0 - cos(2.0_per_s * t)),
        0.1_m * sin(1.0_per_s * t)
    ]),
    drive: Each(0..6, |i| Drive(
        legs.leg[i].slide.stroke,
        value = norm(legs.head[i] + way - legs.foot[i]) - norm(legs.head[i] - legs.foot[i])
    )),
    pose: Output(plate.origin),
    tilt: Output(plate.z),
});

#[test]
fn driven_legs_give_the_pose() {
    let settings = Settings {
        step: 2e-3,
        ..Settings::default()
    };
    let mut simulation =
        Simulation::with_settings(Driven::default(), settings).expect("it assembles");
    for instant in 1..=10 {
        let t = 0.05 * f64::from(instant);
        simulation.run_until(t).expect("it runs");
        let out = simulation.outputs();
        let wanted = [
            0.1 * (2.0 * t).sin(),
            0.05 * (1.0 - (2.0 * t).cos()),
            1.0 + 0.1 * t.sin(),
        ];
        for (axis, wanted) in wanted.into_iter().enumerate() {
            let found = out.pose[axis];
            assert!((found - wanted).abs() < 1e-9, "{t}: {found} not {wanted}");
        }
        assert!((out.tilt[2] - 1.0).abs() < 1e-9);
    }
}
