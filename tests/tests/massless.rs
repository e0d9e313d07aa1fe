//! Parts without mass: the compiler takes coordinates in which everything moves a mass.

use crate::common::expansion::refused;
use mbs_runtime::{Mechanism, Simulation, mechanism};

// A body on a link without mass: by points the end of the link is not shared with the body.
mechanism!(Hung {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    link: Bar(length = 1.0_m, angle = 0.0_deg),
    bob: Body(mass = 1.0_kg, inertia = 0.1_kg_m2, at = [0.9_m, 0.0]),
    pivot: Revolute(ground.origin, link.a),
    pin: Revolute(link.b, bob.point(0.1_m, 0.0)),
    turn: Output(rate(link.rate)),
});

#[test]
fn joint_coordinates_are_tried_where_points_move_without_mass() {
    assert_eq!(Hung::MODEL.formulation, "Joint");
    let hung = Simulation::new(Hung::default()).expect("it assembles");
    // The link pulls along itself, through the centre of mass: the bob falls without turning, and the end of the link with it.
    let turn = hung.outputs().turn;
    assert!((turn + 9.81).abs() < 1e-9, "{turn}");
}

// The link is the last of its branch where the loop is cut at its end.
mechanism!(Stayed {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    arm: Bar(mass = 1.0_kg, length = 1.0_m, angle = 0.0_deg),
    slide: Bar(
        mass = 1.0_kg,
        length = 0.5_m,
        from = [0.5_m, 0.3_m],
        angle = 90.0_deg
    ),
    link: Bar(length = 1.0_m, from = [0.0_m, 0.0], angle = 60.0_deg),
    pivot: Revolute(ground.origin, arm.point(0.3_m, 0.2_m)),
    rail: Prismatic(arm.point(0.5_m, 0.0), slide.a, axis = Y, angle = 90.0_deg),
    j3: Revolute(arm.a, link.a),
    j4: Revolute(link.b, slide.b),
    damper: Torque(link, value = -1.0_N_m_s * link.rate),
    end: Output(arm.b),
});

#[test]
fn coordinates_without_inertia_are_passed_over() {
    assert_eq!(Stayed::MODEL.formulation, "Natural");
    let mut stayed = Simulation::new(Stayed::default()).expect("it assembles");
    stayed.run_until(0.5).expect("it runs");
    let energy = stayed.energy();
    assert!(
        energy.nonconservative_work < 0.0 && energy.error.abs() < 1e-3,
        "{energy:?}"
    );
}

#[test]
fn coordinates_without_inertia_are_refused_where_they_are_asked_for() {
    refused(
        r#"
mechanism!(Stayed {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Joint),
    arm: Bar(mass = 1.0_kg, length = 1.0_m, angle = 30.0_deg),
    link: Bar(length = 1.0_m),
    ~~~~ in joint coordinates nothing with mass follows `link.angle`: give the part `mass =`, or take other coordinates for it by `coordinates = Natural`
    pivot: Revolute(ground.origin, arm.a),
    pin: Revolute(arm.b, link.a),
});
"#,
    );
}

/// Also where they are asked for by the part alone, and points would move it without mass, too.
#[test]
fn a_link_that_nothing_follows_is_refused() {
    refused(
        r#"
mechanism!(Loose {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    bob: Particle(mass = 1.0_kg, at = [2.0_m, 0.0], free = true),
    link: Bar(length = 1.0_m, angle = 0.0_deg, coordinates = Joint),
    ~~~~ in joint coordinates nothing with mass follows `link.angle`: give the part `mass =`, or take other coordinates for it by `coordinates = Natural`
    pivot: Revolute(ground.origin, link.a),
    spring: SpringDamper(link.b, bob, stiffness = 1.0_N_per_m, length = 1.0_m),
});
"#,
    );
}
