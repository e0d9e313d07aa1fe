//! Declared velocities of parts whose points are merged with those of slender bars, which have no declared velocities.

use mbs_runtime::{Simulation, mechanism};

mechanism!(Chain {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    upper: Bar(from = [0.0_m, 0.0, 0.0], to = [1.0, 0.0, 0.0]),
    lower: Bar(
        mass = 1.0_kg,
        from = [1.0_m, 0.0, 0.0],
        to = [2.0, 0.0, 0.0]
    ),
    middle: Particle(
        mass = 1.0_kg,
        at = [1.0, 0.0, 0.0],
        velocity = [0.0, 1.0_m_per_s, 0.0]
    ),
    bob: Particle(
        mass = 1.0_kg,
        at = [2.0, 0.0, 0.0],
        velocity = [0.0, 2.0_m_per_s, 0.5]
    ),
    pivot: Spherical(ground.origin, upper.a),
    elbow: Spherical(upper.b, lower.a),
    // connected with the first bar only through the second
    eye: Spherical(middle, lower.a),
    knot: Spherical(bob, lower.b),
    middle_velocity: Output(middle.velocity),
    bob_velocity: Output(bob.velocity),
});

#[test]
fn particles_at_slender_bars() {
    let simulation = Simulation::new(Chain::default()).expect("it assembles");
    assert_eq!(simulation.output_values(), [0.0, 1.0, 0.0, 0.0, 2.0, 0.5]);
}

mechanism!(Paddle {
    world: Spatial(),
    rod: Bar(from = [0.0_m, 0.0, 0.0], to = [1.0, 0.0, 0.0]),
    blade: Body(
        mass = 2.0_kg,
        inertia = diag(0.1, 0.2, 0.3),
        at = [1.0, 0.0, 0.5],
        velocity = [0.0, 1.0_m_per_s, 0.0],
        angular_velocity = [2.0_rad_per_s, 0.0, 0.0],
    ),
    weight: Particle(mass = 1.0_kg, at = [1.0, 0.0, 0.0]),
    pivot: Spherical(ground.origin, rod.a),
    tie: Spherical(rod.b, weight),
    ball: Spherical(weight, blade.point(0.0, 0.0, -0.5)),
    tip: Output(rod.b.velocity),
});

/// v + ω × arm of the body at the ball.
#[test]
fn a_turning_body_at_a_slender_bar() {
    let simulation = Simulation::new(Paddle::default()).expect("it assembles");
    let tip = simulation.output_values();
    let expected = [0.0, 2.0, 0.0];
    for (found, expected) in tip.iter().zip(expected) {
        assert!((found - expected).abs() <= 1e-14, "{tip:?}");
    }
}

mechanism!(Track {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    seed: Param(0.4),
    link: Each(0..40, |i| Bar(
        mass = 0.5_kg,
        length = 0.1_m,
        angle = i * 9.0_deg + 0.2 * sin(seed * i)
    )),
    pin: Each(0..40, |i| Revolute(link[i].b, link[(i + 1) % 40].a)),
    front: Revolute(ground.origin, link[0].a),
    rear: Revolute(ground.point(-1.0_m, 0.4_m), link[20].a),
});

/// Newton's method ties knots into long chains whose guess is far from closed.
#[test]
fn a_chain_is_closed_little_by_little() {
    for seed in [0.1, 0.4, 0.7, 0.9, 1.3, 2.2, 3.1, 5.7] {
        let simulation = Simulation::new(Track { seed });
        let simulation = simulation.unwrap_or_else(|error| panic!("{seed}: {error}"));
        assert!(simulation.assembly().residual < 1e-12);
    }
}
