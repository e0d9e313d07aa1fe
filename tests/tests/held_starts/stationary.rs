//! Held values that are stationary at the declared guess: at dead centres, upright, and at rest.

use super::{is_consistent, near};
use mbs_runtime::{Mechanism, Simulation, System, mechanism};
use std::f64::consts::FRAC_PI_2;

macro_rules! upright {
    ($name:ident, $coordinates:ident) => {
        mechanism!($name {
            world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = $coordinates),
            rod: Bar(mass = 1.0_kg, length = 0.5_m, angle = 90.0_deg),
            pivot: Revolute(ground.origin, rod.a),
            y: Output(rod.b.y),
            speed: Output(norm(rod.b.velocity)),
            energy: Output(0.5_kg * dot(rod.b.velocity, rod.b.velocity)),
            length: Output(norm(rod.b - rod.a)),
        });
    };
}

upright!(NaturalUpright, Natural);
upright!(ReferenceUpright, Reference);
upright!(JointUpright, Joint);

fn leaves_the_top<
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
    const Q: usize,
    const N: usize,
    const R: usize,
>() {
    for height in [0.4, -0.2, 0.4999, 0.5] {
        let start = Simulation::start(M::default()).hold("y", height);
        let held = start.begin().unwrap();
        near(held.output("y").unwrap(), height);
        is_consistent(&held);
    }
    for speed in [1.0, 1e-3, 30.0] {
        let start = Simulation::start(M::default()).hold("speed", speed);
        let held = start.begin().unwrap();
        assert!((held.output("speed").unwrap() / speed - 1.0).abs() < 1e-11);
        is_consistent(&held);
    }
    let start = Simulation::start(M::default()).hold("energy", 2.0);
    near(start.begin().unwrap().output("energy").unwrap(), 2.0);
    let refusal = |name: &str, value: f64| {
        let start = Simulation::start(M::default()).hold(name, value);
        start.begin().expect_err("it is refused").to_string()
    };
    let too_high = refusal("y", 0.6);
    assert!(
        too_high.contains("`y` is off by -")
            && too_high.contains("; the joints do not allow these values"),
        "{too_high}"
    );
    let rigid = refusal("length", 0.6);
    assert!(
        rigid.ends_with(
            "`length` is off by -1.000e-1 m; `length` does not change near the guess: declare another guess, or this value as one"
        ),
        "{rigid}"
    );
}

/// The gradient of 1e-17 m/rad led to a random angle, and to the claim that the joints do not allow the value.
#[test]
fn a_pendulum_leaves_the_top() {
    leaves_the_top::<NaturalUpright, _, _, _, _>();
    leaves_the_top::<ReferenceUpright, _, _, _, _>();
    leaves_the_top::<JointUpright, _, _, _, _>();
}

mechanism!(NearlyUpright {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Joint),
    guess: Param(90.0_deg),
    rod: Bar(mass = 1.0_kg, length = 1.0_m, angle = guess),
    pivot: Revolute(ground.origin, rod.a),
    height: Output(rod.b.y),
    angle: Output(rod.angle),
});

/// The first Newton step was the gap divided by a slope of 1e-6 to 1e-3, up to 1600 turns, which the angle counts.
#[test]
fn a_height_is_held_within_half_a_turn_of_the_guess() {
    for offset in [0.0_f64, 1e-8, 1e-5, -1e-5, 1e-4, 1e-3, -1e-3] {
        let guess = FRAC_PI_2 + offset;
        for height in [0.9, 0.3, -0.25, -0.2625, -0.285, -0.9, -0.9975] {
            let start = Simulation::start(NearlyUpright { guess }).hold("height", height);
            let held = start.begin().unwrap();
            let from_top = (FRAC_PI_2 - height.asin()).copysign(offset);
            let angle = held.outputs().angle;
            let off = angle - FRAC_PI_2 - from_top;
            assert!(off.abs() < 1e-9, "{offset}, {height}: {angle} rad");
        }
    }
}

mechanism!(SliderCrank {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    crank: Bar(mass = 1.0_kg, length = 0.3_m),
    rod: Bar(mass = 0.5_kg, length = 0.7_m),
    piston: Particle(mass = 2.0_kg),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    gudgeon: Revolute(rod.b, piston.origin),
    guide: PointOnLine(piston.origin, ground.origin, axis = X),
    x: Output(piston.origin.x),
    y: Output(crank.b.y),
    angle: Output(crank.angle),
});

/// Both bars begin along X, where the piston is at its dead centre. It goes to the side of the positive velocities.
#[test]
fn a_piston_leaves_its_dead_centre() {
    for x in [0.9, 0.5, 0.99999] {
        let start = Simulation::start(SliderCrank::default()).hold("x", x);
        let held = start.begin().unwrap();
        near(held.outputs().x, x);
        is_consistent(&held);
        assert!(held.outputs().y > 0.0, "{}", held.outputs().y);
    }
    let start = Simulation::start(SliderCrank::default());
    let both = start.hold("x", 0.9).hold_rate("angle", 2.0).begin();
    near(both.unwrap().outputs().x, 0.9);
    let start = Simulation::start(SliderCrank::default());
    let error = start.hold("angle", 0.7).hold("x", 1.1).begin();
    let error = error.err().unwrap().to_string();
    assert!(!error.contains(" ;"), "{error}");
}

mechanism!(Loop {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    crank: Bar(
        mass = 1.0_kg,
        from = [0.0_m, 0.0, 0.0],
        to = [0.0_m, 0.0, 0.2_m],
        inertia = Cuboid(0.03_m, 0.03_m, 0.2_m)
    ),
    rod: Bar(
        mass = 0.6_kg,
        from = [0.0_m, 0.0, 0.2_m],
        to = [0.6_m, 0.4_m, 0.3_m]
    ),
    rocker: Bar(
        mass = 1.2_kg,
        from = [0.6_m, 0.4_m, 0.0],
        to = [0.6_m, 0.4_m, 0.3_m],
        inertia = Cuboid(0.03_m, 0.03_m, 0.3_m)
    ),
    j1: Revolute(ground, crank, at = crank.a, axis = X),
    s1: Spherical(crank.b, rod.a),
    s2: Spherical(rod.b, rocker.b),
    j2: Revolute(ground, rocker, at = rocker.a, axis = Y),
    tip: Output(rocker.b),
});

mechanism!(Disk {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    disk: Body(
        mass = 2.0_kg,
        inertia = Cylinder(0.3_m, 0.02_m, Y),
        at = [0.0, 0.0, 0.3_m]
    ),
    contact: Rolling(disk.origin, ground.origin, radius = 0.3_m, axis = Y),
    place: Output(disk.origin),
});

#[test]
fn mechanisms_in_space_leave_their_home_pose() {
    let start = Simulation::start(Loop::default()).hold("tip.z", 0.29);
    let held = start.begin().unwrap();
    near(held.output("tip.z").unwrap(), 0.29);
    is_consistent(&held);
    let start = Simulation::start(Disk::default()).hold("place.z", 0.25);
    let held = start.begin().unwrap();
    near(held.output("place.z").unwrap(), 0.25);
    near(held.output("place.x").unwrap(), 0.0);
    is_consistent(&held);
}

macro_rules! even {
    ($name:ident, $coordinates:ident) => {
        mechanism!($name {
            world: Planar(coordinates = $coordinates),
            a: Particle(mass = 1.0_kg, at = [0.0, 0.0]),
            b: Particle(mass = 1.0_kg, at = [0.0, 0.0]),
            rail: PointOnLine(a.origin, ground.origin, axis = X),
            other: PointOnLine(b.origin, ground.origin, axis = X),
            rod: Bar(mass = 1.0_kg, length = 1.0_m, angle = 90.0_deg),
            pivot: Revolute(ground.origin, rod.a),
            charge: State(initial = 0.0, rate = -1.0_per_s * charge),
            x: Output(a.origin.x),
            speed: Output(a.velocity.x),
            square: Output(a.velocity.x * a.velocity.x),
            quartic: Output(a.origin.x * a.origin.x * a.origin.x * a.origin.x),
            power: Output(charge * charge),
            places: Output(a.origin.x * a.origin.x + 0.01 * b.origin.x * b.origin.x),
            speeds: Output(a.velocity.x * a.velocity.x + 0.01 * b.velocity.x * b.velocity.x),
        });
    };
}

even!(NaturalEven, Natural);
even!(JointEven, Joint);

/// The start has each of these values.
fn has<
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
    const Q: usize,
    const N: usize,
    const R: usize,
>(
    values: &[(&str, f64)],
) {
    let start = Simulation::start(M::default());
    let start = (values.iter()).fold(start, |start, &(name, value)| start.hold(name, value));
    let held = start.begin().unwrap();
    for &(name, value) in values {
        let off = held.output(name).unwrap() - value;
        assert!(off.abs() <= 1e-11 * value.abs(), "`{name}` is off by {off}");
    }
    is_consistent(&held);
}

fn leaves_zero<
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
    const Q: usize,
    const N: usize,
    const R: usize,
>() {
    for square in [1e6, 1e-2, 1e-6] {
        has::<M, _, _, _, _>(&[("square", square)]);
    }
    for quartic in [16.0, 0.1, 1e-6] {
        has::<M, _, _, _, _>(&[("quartic", quartic)]);
    }
    for power in [9.0, 0.3, 1e-6] {
        has::<M, _, _, _, _>(&[("power", power)]);
    }
    has::<M, _, _, _, _>(&[("power", 0.3), ("square", 1e-6), ("quartic", 0.1)]);
}

/// Such values were called constant: of v² = 1e-6 a step aside by a thousandth of that changes 1e-18.
#[test]
fn small_squares_fourth_powers_and_those_of_states_are_held() {
    leaves_zero::<NaturalEven, _, _, _, _>();
    leaves_zero::<JointEven, _, _, _, _>();
}

fn leaves_beside<
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
    const Q: usize,
    const N: usize,
    const R: usize,
>() {
    for (x, places) in [(0.0, 1e-4), (0.0, 1e-2), (0.02, 1e-2)] {
        has::<M, _, _, _, _>(&[("places", places), ("x", x)]);
    }
    for (speed, speeds) in [(0.0, 1e-4), (1e-3, 1e-4)] {
        has::<M, _, _, _, _>(&[("speeds", speeds), ("speed", speed)]);
    }
}

/// The step aside was along x, which is held: the gradients were the same, and the values refused.
#[test]
fn a_stationary_value_beside_a_regular_one_leaves_by_another_way() {
    leaves_beside::<NaturalEven, _, _, _, _>();
    leaves_beside::<JointEven, _, _, _, _>();
}
