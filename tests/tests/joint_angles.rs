//! Coordinates of joints have the names and signs of the declaration, and no full turns more than declared.

use mbs_runtime::{Simulation, mechanism};
use std::f64::consts::PI;

// All joints are declared from the carried part to the one that carries it.
mechanism!(Backwards {
    world: Spatial(coordinates = Joint),
    arm: Body(
        mass = 2.0_kg,
        inertia = diag(0.1, 0.2, 0.3),
        at = [0.5, 0.0, 0.2],
        angular_velocity = [0.0_rad_per_s, 0.0, 2.0]
    ),
    sleeve: Body(
        mass = 1.0_kg,
        inertia = diag(0.1, 0.1, 0.05),
        at = [1.0, 0.2, 0.0]
    ),
    nut: Body(
        mass = 1.0_kg,
        inertia = diag(0.1, 0.1, 0.05),
        at = [1.0, 0.2, 0.5]
    ),
    hinge: Revolute(arm, ground, at = [0.1, 0.0, 0.0], axis = Z),
    guide: Cylindrical(sleeve, arm, at = [0.7, 0.1, 0.0], axis = [0.2, 1.0, 0.0]),
    thread: Screw(
        nut,
        sleeve,
        at = [0.7, 0.1, 0.4],
        axis = [0.2, 1.0, 0.3],
        pitch = 0.4_m
    ),
    turned: Output(hinge.angle),
    turning: Output(hinge.rate),
    slid: Output(guide.stroke),
    twisted: Output(guide.angle),
    screwed: Output(thread.angle),
    lifted: Output(thread.stroke),
});

#[test]
fn coordinates_have_the_signs_of_their_joints() {
    let start = Simulation::start(Backwards::default())
        .hold("hinge.angle", 0.4)
        .hold("hinge.angle'", -1.5)
        .hold("guide.stroke", 0.2)
        .hold("guide.angle", -0.3)
        .hold("thread.angle", 0.5);
    let simulation = start.begin().expect("it assembles");
    let wanted = [0.4, -1.5, 0.2, -0.3, 0.5, 0.4 * 0.5 / (2.0 * PI)];
    let found = simulation.output_values();
    for (found, wanted) in found.iter().zip(wanted) {
        assert!((found - wanted).abs() < 1e-12, "{found}, {wanted}");
    }
}

mechanism!(Sledge {
    world: Planar(coordinates = Joint),
    sledge: Body(mass = 2.0_kg, inertia = 0.1_kg_m2),
    guide: Prismatic(sledge.origin, ground.origin, axis = X),
    slid: Output(guide.stroke),
});

#[test]
fn strokes_of_the_plane_do_too() {
    let start = Simulation::start(Sledge::default()).hold("guide.stroke", 0.3);
    let simulation = start.begin().expect("it assembles");
    assert!((simulation.outputs().slid - 0.3).abs() < 1e-12);
}

mechanism!(Cross {
    world: Spatial(coordinates = Joint),
    arm: Body(mass = 2.0_kg, inertia = diag(0.1, 0.2, 0.3)),
    cross: Universal(arm, ground, at = [0.0, 0.0, 0.0], axis = X, second_axis = Y),
    end: Output(arm.point(1.0, 1.0, 0.0)),
});

/// The first axis is that of the partner that was declared first.
#[test]
fn the_angles_of_a_universal_joint_have_its_order() {
    for (angle, second) in [(0.4_f64, 0.0_f64), (0.0, 0.4)] {
        let start = Simulation::start(Cross::default())
            .hold("cross.angle", angle)
            .hold("cross.second_angle", second);
        let simulation = start.begin().expect("it assembles");
        let end = simulation.outputs().end;
        let wanted = [second.cos(), angle.cos(), second.sin() - angle.sin()];
        for (found, wanted) in [end.x, end.y, end.z].iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-12, "{found}, {wanted}");
        }
    }
}

mechanism!(FourBar {
    world: Planar(coordinates = Joint),
    angles: Param([0.4, 0.3, 0.1]),
    crank: Bar(mass = 0.5_kg, length = 0.3_m, angle = angles[0]),
    rod: Bar(mass = 0.5_kg, length = 0.8_m, angle = angles[1]),
    rocker: Bar(mass = 0.5_kg, length = 0.6_m, angle = angles[2]),
    foot: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    elbow: Revolute(rod.b, rocker.a),
    heel: Revolute(rocker.b, ground.point(0.8_m, 0.0)),
    crank_angle: Output(crank.angle),
    rod_angle: Output(rod.angle),
    rocker_angle: Output(rocker.angle),
});

/// Newton's method turned bars by full turns on the way to a pose that has them near their declared angles.
#[test]
fn assembly_adds_no_full_turns() {
    let angle = |i: i32| f64::from(i) * PI / 3.0 - 3.1;
    let mut assembled = 0;
    for place in 0..216 {
        let angles = [place / 36, place / 6 % 6, place % 6].map(angle);
        let Ok(simulation) = Simulation::new(FourBar { angles }) else {
            continue;
        };
        assembled += 1;
        let found = simulation.output_values();
        let off = found.iter().zip(angles).map(|(a, b)| (a - b).abs());
        assert!(off.fold(0.0, f64::max) <= PI, "{angles:?}: {found:?}");
    }
    assert!(assembled > 200, "{assembled}");
}
