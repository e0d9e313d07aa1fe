//! What was accepted, and then left out of the equations or evaluated elsewhere.

use crate::common::expansion::{accepted, refused};
use mbs_runtime::{Simulation, mechanism};

mechanism!(Coil {
    world: Planar(),
    arm: Bar(mass = 3.0_kg, length = 1.0_m, angle = 0.5_rad),
    pin: Revolute(ground.origin, arm.a),
    other: Let(arm),
    same: Let(other),
    coil: TorsionSpring(ground, same, stiffness = 10.0_Nm),
});

/// The part of a spring was known by its own name alone: by another one it had no angle, and the spring no stiffness.
#[test]
fn a_spring_acts_on_a_part_by_any_of_its_names() {
    let coil = Simulation::new(Coil::default()).expect("it assembles");
    let dynamics = coil.dynamics().expect("it has a mass");
    // m L²/3 = 1 kg m².
    let angular = dynamics.accelerations()[0];
    assert!((angular + 5.0).abs() < 1e-9, "{angular}");
}

mechanism!(Hung {
    world: Spatial(),
    x: Coordinate(0.3_m),
    bead: Particle(mass = 1.0_kg, position = [x, 0.0, 0.0]),
    bob: Particle(mass = 1.0_kg, at = [0.3_m, 0.0, -1.0_m]),
    free_length: Let(norm(bob.origin - bead.origin)),
    spring: SpringDamper(
        bead.origin,
        bob.origin,
        stiffness = 100.0_N_per_m,
        length = free_length
    ),
    rod: Bar(mass = 1.0_kg, from = bead.origin, to = [0.3_m, 2.0_m, 0.0]),
    hook: Spherical(bead.origin, rod.a),
});

/// The place of a particle that follows coordinates was the origin in the home pose.
#[test]
fn the_home_pose_has_followers_at_their_places() {
    let hung = Simulation::new(Hung::default()).expect("it assembles");
    let dynamics = hung.dynamics().expect("it has a mass");
    let accelerations = dynamics.accelerations();
    assert!(
        accelerations.iter().all(|x| x.abs() < 1e-9),
        "{accelerations}"
    );
    assert!(hung.energy().potential.abs() < 1e-12);
}

#[test]
fn particles_have_no_orientation() {
    refused(
        r#"mechanism!(Points {
    world: Planar(),
    bead: Particle(mass = 1.0_kg, at = [0.0, 0.0]),
    other: Particle(mass = 1.0_kg, at = [0.5_m, 1.0_m]),
    rod: Distance(bead.point(0.5_m, 0.0_m), other.origin, length = 1.0_m),
                       ~~~~~ `bead` is a particle, and has no point but itself: write `bead.origin`, or use a Body
    wire: PointOnLine(other, bead),
                             ~~~~ `bead` is a particle and has no orientation for a line; use a Body or a Bar
    turned: Output(bead.angle),
                        ~~~~~ `bead` has no `angle`; a particle has no orientation (it has: origin, velocity, acceleration)
});"#,
    );
    refused(
        r#"mechanism!(Space {
    world: Spatial(),
    bead: Particle(mass = 1.0_kg, at = [1.0_m, 0.0, 0.0]),
    arm: Body(mass = 1.0_kg, inertia = 0.1_kg_m2),
    ball: Spherical(arm, bead, at = [0.0, 0.0, 0.0]),
    ~~~~ in the home pose `arm at ball` is at [0.0, 0.0, 0.0] m and `bead at ball` at [1.0, 0.0, 0.0] m, 1.000 m apart, but this joint holds them together; move one of the parts by its `at`, `from` or `orientation`
});"#,
    );
    refused(
        r#"mechanism!(Frames {
    world: Spatial(),
    bead: Particle(mass = 1.0_kg, at = [1.0_m, 0.0, 0.0]),
    arm: Body(mass = 1.0_kg, inertia = 0.1_kg_m2),
    pin: Spherical(ground, bead.frame([0.0, 0.0, 0.0], Z)),
                                ~~~~~ `bead` is a particle and has no orientation: name it alone, or use a Body
    axis: Spherical(ground.origin, arm.frame([0.0, 0.0, 0.0], [0.0_kg, 0.0_kg, 1.0_kg])),
                                                              ~~~~~~~~~~~~~~~~~~~~~~~~ the axis of a frame is a direction without unit, but this is a mass (kg)
});"#,
    );
}

#[test]
fn a_torque_needs_an_inertia() {
    refused(
        r#"mechanism!(Twisted {
    world: Spatial(),
    hub: Body(mass = 1.0_kg, inertia = 0.1_kg_m2),
    rod: Bar(mass = 1.0_kg, from = [0.0, 0.0, 0.0], to = [1.0_m, 0.0, 0.0]),
    ball: Spherical(hub.origin, rod.a),
    twist: Torque(rod, value = [1.0_Nm, 0.0, 0.0], from = hub),
                  ~~~ `rod` is a slender bar and takes no torque: it has no inertia about itself, and the part along it would be lost; give it `radius =` or `inertia =`
    wrench: Wrench(rod.b, torque = [1.0_Nm, 0.0, 0.0]),
                   ~~~~~ `rod` is a slender bar and takes no torque: it has no inertia about itself, and the part along it would be lost; give it `radius =` or `inertia =`, or use `Force`
});"#,
    );
}

#[test]
fn values_that_jump_are_no_conditions() {
    refused(
        r#"mechanism!(Jumps {
    world: Planar(),
    size: Param(0.5_rad),
    crank: Bar(mass = 1.0_kg, length = 1.0_m),
    pin: Revolute(ground.origin, crank.a),
    motor: Drive(crank.angle, value = 1.0_rad_per_s * t + size * step(t - 1.0_s)),
                                      ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ this jumps, and positions or velocities would have to jump with it: use a value that changes steadily, an `Input` that the program sets, or a force
});"#,
    );
    accepted(
        r#"mechanism!(Ramp {
    world: Planar(),
    crank: Bar(mass = 1.0_kg, length = 1.0_m),
    pin: Revolute(ground.origin, crank.a),
    motor: Drive(crank.angle, value = (1.0_per_s * (t - 1.0_s)).powi(2) * step(t - 1.0_s)),
});"#,
    );
}

/// An input may jump, and a part without inertia may have mass away from its joint.
#[test]
fn legal_programs_are_accepted() {
    accepted(
        r#"mechanism!(Switched {
    world: Planar(),
    switch: Input(0.0),
    crank: Bar(mass = 1.0_kg, length = 1.0_m),
    pin: Revolute(ground.origin, crank.a),
    motor: Drive(crank.angle, value = 0.5_rad * step(switch - 0.5)),
});"#,
    );
    accepted(
        r#"mechanism!(Points {
    world: Planar(coordinates = Joint),
    a: Bar(mass = 1.0_kg, length = 1.0_m),
    b: Body(mass = 1.0_kg, inertia = 0.0_kg_m2, center_of_mass = [1.0_m, 0.0]),
    pin: Revolute(ground.origin, a.a),
    elbow: Revolute(a.b, b.origin),
});"#,
    );
}

#[test]
fn places_of_followers_are_those_of_what_they_follow() {
    refused(
        r#"mechanism!(Followers {
    world: Planar(),
    turn: Coordinate(0.3_rad),
    arm: Body(mass = 1.0_kg, inertia = 0.1_kg_m2, frame = Frame([0.0, 0.0], turn), angle = 0.5_rad),
                                                                                           ~~~~~~~ `arm` follows its `frame`, at the start, too: leave `angle =` out, and give the coordinates their values
    bead: Particle(mass = 1.0_kg, position = arm.point(1.0_m, 0.0_m), at = [1.0_m, 0.0]),
                                                                           ~~~~~~~~~~~~ `bead` follows its `position`, at the start, too: leave `at =` out, and give the coordinates their values
});"#,
    );
}

#[test]
fn units_and_rates_are_those_that_are_known() {
    refused(
        r#"mechanism!(Rates {
    world: Planar(),
    arm: Bar(mass = 1.0_kg, length = 1.0_m),
    rod: Bar(mass = 1.0_kg, length = 1.0_m),
    pin: Revolute(ground.origin, arm.a),
    other: Revolute(ground.origin, rod.a),
    link: Coupling(arm.angle, rod.angle, offset = 0.1_m),
                                                  ~~~~~ `offset` is a pure number or angle, but this is a length (m)
    lift: Let(law(cam, arm.angle)),
    jerk: Output(rate(rate(lift))),
                      ~~~~~~~~~~ a law gives value and first partials, and this rate needs second ones: write the expression out
    big: Output(arm.angle * (1e308 + 1e308)),
                             ~~~~~~~~~~~~~ the result of this is no finite number; check its arguments
});"#,
    );
}

/// Parts without mass were not seen where any joint had a coordinate.
#[test]
fn massless_motion_beside_joint_coordinates() {
    refused(
        r#"mechanism!(Strung {
    world: Planar(coordinates = Joint),
    arm: Bar(mass = 1.0_kg, length = 1.0_m),
    pin: Revolute(ground.origin, arm.a),
    bead: Particle(at = [1.0_m, 0.5_m]),
    ~~~~ `bead` moves without mass: give it `mass =`, or join it to a part that has mass
    string: SpringDamper(arm.b, bead.origin, stiffness = 10.0_N_per_m),
    puck: Body(mass = 1.0_kg, inertia = 0.0_kg_m2, free = true),
    ~~~~ `puck` turns without inertia: give it a positive `inertia =`, or use a `Particle`
});"#,
    );
}

#[test]
fn documentation_and_names() {
    refused(
        r#"mechanism!(r#type {
           ~~~~~~ names are written without `r#`; choose another name
    /// A crank.
    ~~~~~~~~~~~~ `world:` has no documentation of its own; that of the whole stands before its name, or in `doc:`
    world: Planar(),
});"#,
    );
}

#[test]
fn members_with_other_values_are_no_array() {
    refused(
        r#"assembly!(Row {
    world: Planar(),
    at: Port(Point),
    count: Port(Number, default = 2),
    bar: Each(0..count, |i| Bar(mass = 1.0_kg, length = 0.1_m)),
    pin: Each(0..count, |i| Revolute(at, bar[i].a)),
    tip: Each(0..count, |i| Output(bar[i].b.x)),
});
mechanism!(Rows {
    world: Planar(),
    row: Each(0..2, |i| Assembly(Row, at = ground.origin, count = i + 1)),
    ~~~ the members of `row` have different outputs, and an array has members of one type: give them the same, or declare them one by one
});"#,
    );
}

mechanism!(Limited {
    world: Planar(),
    large: Param(1e30_N),
    rate: Param(3.0_N_per_m),
    p: Particle(mass = 1.0_kg, at = [2.0_m, 0.0], free = true),
    ramp: Table([0.0_m, 4.0_m], [0.0_N, 8.0_N]),
    force: Output(min(rate * p.origin.x, large)),
    place: Output(max(p.origin.x, -1e18_m)),
    folded: Output(min(2.0, 1e30)),
    far: Output(max(1e-3_m, p.origin.x - 1e9_m)),
    change: Output(rate(max(p.origin.x, 1.0_m))),
    power: Output((p.origin.x / 2.0_km).powi(120)),
    push: Each([ramp, ramp], |table| Force(
        p.origin,
        value = [table(p.origin.x), 0.0_N]
    )),
});

/// max(a, b) was b + (a − b) step(a − b), which cancels where b is large.
#[test]
fn limits_that_are_far_away_change_nothing() {
    let limited = Simulation::new(Limited::default()).expect("it assembles");
    let found = limited.outputs();
    assert_eq!((found.force, found.place, found.folded), (6.0, 2.0, 2.0));
    assert_eq!(found.far, 1e-3);
    assert_eq!(found.change, 0.0);
    // (2 m / 2 km)^120 = 1e-360 is less than any number, but not because 1e-3^120 was computed first.
    assert_eq!(found.power, 0.0);
    let dynamics = limited.dynamics().expect("it has a mass");
    assert!((dynamics.accelerations()[0] - 8.0).abs() < 1e-12);
}

#[test]
fn signs_of_velocities_are_no_velocity_rows() {
    refused(
        r#"mechanism!(Wrong {
    world: Planar(),
    p: Particle(mass = 1.0_kg, free = true),
    q: Particle(mass = 1.0_kg, free = true),
    n: Nonholonomic(p.velocity.x - sign(q.velocity.x) * q.origin.y / 1.0_s),
                    ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ a nonholonomic condition must be affine in the velocities: N(q) v + n(q, t) = 0
});"#,
    );
}

#[test]
fn large_powers_and_conditions_are_read() {
    accepted(
        r#"mechanism!(Read {
    world: Planar(),
    p: Particle(mass = 1.0_kg, free = true),
    u: Let(p.origin.x / 1.0_m),
    large: Output(u.powi(-512).powi(512).powi(512).powi(16)),
    q: Each(0..3, |i| if i != 0 && 10 / i > 2 { Particle(mass = 1.0_kg, free = true) } else { Particle(mass = 2.0_kg, free = true) }),
    length: Output((p.origin.x / 1.0_mm).powi(120)),
});"#,
    );
    refused(
        r#"mechanism!(Wrong {
    world: Planar(),
    p: Each(0..2, |i| if 10 / i > 2 { Particle(mass = 1.0_kg) } else { Particle(mass = 2.0_kg) }),
                         ~~~~~~ in `p[0]`: this divides by zero
});"#,
    );
}

mechanism!(Braked {
    world: Planar(),
    rotor: Body(mass = 1.0_kg, inertia = 0.5_kg_m2, rate = 3.0_rad_per_s),
    hinge: Revolute(ground.origin, rotor.origin),
    brake: Torque(on = rotor, value = -2.0_Nm * sign(hinge.rate)),
    rate: Output(rotor.rate),
});

mechanism!(Switched {
    world: Planar(),
    charge: State(initial = 1.0, rate = -2.0_per_s),
    rotor: Body(mass = 1.0_kg, inertia = 0.5_kg_m2),
    hinge: Revolute(ground.origin, rotor.origin),
    motor: Torque(on = rotor, value = 2.0_Nm * step(charge)),
    rate: Output(rotor.rate),
});

/// Their derivative by the velocity is zero, and they were taken as forces of positions: the generated code named a velocity that it
/// did not have.
#[test]
fn forces_may_depend_on_velocities_by_their_sign_alone() {
    for model in [
        Simulation::new(Braked::default())
            .expect("it assembles")
            .model(),
        Simulation::new(Switched::default())
            .expect("it assembles")
            .model(),
    ] {
        assert!(model.structure.velocity_forces);
    }
    let mut braked = Simulation::with_accuracy(Braked::default(), 1e-6).expect("it assembles");
    braked.run_until(0.5).expect("it runs");
    assert!((braked.outputs().rate - 1.0).abs() < 1e-9);
    let mut switched = Simulation::with_accuracy(Switched::default(), 1e-6).expect("it assembles");
    switched.run_until(1.0).expect("it runs");
    let rate = switched.outputs().rate;
    assert!((rate - 2.0).abs() < 1e-5, "{rate}");
}
