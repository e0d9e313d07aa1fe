//! A Stewart–Gough platform whose legs are one assembly.

use mbs_parts::spatial::Leg;
use mbs_runtime::{Mechanism, Settings, Simulation, mechanism};

mechanism!(Platform {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    plate: Body(
        mass = 10.0_kg,
        inertia = Cylinder(0.5_m, 0.05_m, Z),
        at = [0.0_m, 0.0, 1.0]
    ),
    low: Each(0..6, |i| Let(
        i * 60.0_deg + if i % 2 == 0 { 0.1 } else { -0.1 }
    )),
    high: Each(0..6, |i| Let(
        i * 60.0_deg + if i % 2 == 0 { 0.3 } else { -0.3 }
    )),
    leg: Each(0..6, |i| Assembly(
        Leg,
        base = ground,
        platform = plate,
        foot = [1.0_m * cos(low[i]), 1.0_m * sin(low[i]), 0.0_m],
        head = [0.5_m * cos(high[i]), 0.5_m * sin(high[i]), 1.0_m]
    )),
    pose: Output(plate.origin),
    tilt: Output(plate.z),
});

/// The same with driven legs: they follow the pose that is asked for.
mod driven {
    use super::*;

    mechanism!(Driven {
        world: Spatial(),
        plate: Body(
            mass = 10.0_kg,
            inertia = Cylinder(0.5_m, 0.05_m, Z),
            at = [0.0_m, 0.0, 1.0]
        ),
        low: Each(0..6, |i| Let(
            i * 60.0_deg + if i % 2 == 0 { 0.1 } else { -0.1 }
        )),
        high: Each(0..6, |i| Let(
            i * 60.0_deg + if i % 2 == 0 { 0.3 } else { -0.3 }
        )),
        foot: Each(0..6, |i| Let([
            1.0_m * cos(low[i]),
            1.0_m * sin(low[i]),
            0.0_m
        ])),
        head: Each(0..6, |i| Let([
            0.5_m * cos(high[i]),
            0.5_m * sin(high[i]),
            1.0_m
        ])),
        way: Let([
            0.1_m * sin(2.0_per_s * t),
            0.05_m * (1.0 - cos(2.0_per_s * t)),
            0.1_m * sin(1.0_per_s * t)
        ]),
        leg: Each(0..6, |i| Assembly(
            Leg,
            base = ground,
            platform = plate,
            foot = foot[i],
            head = head[i]
        )),
        drive: Each(0..6, |i| Drive(
            leg[i].slide.stroke,
            value = norm(head[i] + way - foot[i]) - norm(head[i] - foot[i])
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
                assert!(
                    (out.pose[axis] - wanted).abs() < 1e-9,
                    "{t}: {:?}",
                    out.pose
                );
            }
            assert!((out.tilt[2] - 1.0).abs() < 1e-9);
        }
    }
}

mod by_bodies {
    use super::*;

    mechanism!(ByBodies {
        world: Spatial(
            gravity = [0.0, 0.0, -9.81_m_per_s2],
            coordinates = Reference
        ),
        plate: Body(
            mass = 10.0_kg,
            inertia = Cylinder(0.5_m, 0.05_m, Z),
            at = [0.0_m, 0.0, 1.0]
        ),
        low: Each(0..6, |i| Let(
            i * 60.0_deg + if i % 2 == 0 { 0.1 } else { -0.1 }
        )),
        high: Each(0..6, |i| Let(
            i * 60.0_deg + if i % 2 == 0 { 0.3 } else { -0.3 }
        )),
        leg: Each(0..6, |i| Assembly(
            Leg,
            base = ground,
            platform = plate,
            foot = [1.0_m * cos(low[i]), 1.0_m * sin(low[i]), 0.0_m],
            head = [0.5_m * cos(high[i]), 0.5_m * sin(high[i]), 1.0_m]
        )),
        pose: Output(plate.origin),
        tilt: Output(plate.z),
    });

    #[test]
    fn the_motion_is_that_of_other_coordinates() {
        let settings = Settings {
            order: 8,
            step: 5e-3,
            ..Settings::default()
        };
        let forces = [40.0, 30.0, 55.0, 20.0, 45.0, 35.0];
        let mut one =
            Simulation::with_settings(Platform::default(), settings).expect("it assembles");
        let mut two =
            Simulation::with_settings(ByBodies::default(), settings).expect("it assembles");
        assert_ne!(one.positions().len(), two.positions().len());
        for (leg, force) in forces.into_iter().enumerate() {
            one.inputs_mut().leg[leg].force = force;
            two.inputs_mut().leg[leg].force = force;
        }
        one.run_until(0.2).expect("it runs");
        two.run_until(0.2).expect("it runs");
        let (one, two) = (one.outputs(), two.outputs());
        let apart = (one.pose - two.pose)
            .norm()
            .max((one.tilt - two.tilt).norm());
        assert!(apart < 1e-10, "{apart}");
        assert_eq!(Platform::MODEL.inputs[5].name, "leg[5].force");
    }
}
