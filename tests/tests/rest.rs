//! Damped mechanisms come to rest. Then velocities are below the round-off of the rows, and a smaller step does not
//! help.

use mbs_runtime::{Flow, Mechanism, Settings, Simulation, System, mechanism};

mechanism!(Mass {
    doc: "A weight on a damped spring, without a row.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    y: Coordinate(-0.1_m),
    weight: Particle(mass = 1.3_kg, position = [0.0_m, y]),
    spring: SpringDamper(
        ground.origin,
        weight.origin,
        stiffness = 97.0_N_per_m,
        damping = 3.0_N_s_per_m,
        length = 0.05_m,
    ),
});

mechanism!(Pendulum {
    doc: "A bar with a damper in its pivot.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    rod: Bar(mass = 1.3_kg, length = 0.7_m, angle = 0.3_rad),
    pivot: Revolute(ground.origin, rod.a),
    damper: TorsionSpring(ground, rod, stiffness = 2.0_Nm, damping = 0.5_N_m_s),
});

mechanism!(BodyPendulum {
    doc: "A body with a damper in its pivot.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    rod: Body(
        mass = 1.3_kg,
        inertia = 0.1_kg_m2,
        center_of_mass = [0.3_m, 0.1_m],
        angle = 0.3_rad,
    ),
    pivot: Revolute(ground.origin, rod.point(-0.2_m, 0.1_m)),
    damper: TorsionSpring(ground, rod, stiffness = 2.0_Nm, damping = 0.5_N_m_s),
});

mechanism!(Cart {
    doc: "A cart on a damped spring, with a pendulum.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    wall: Point([-1.0_m, 0.0_m]),
    cart: Body(mass = 2.0_kg, inertia = 0.1_kg_m2, at = [0.3_m, 0.0_m]),
    rail: Prismatic(ground.origin, cart.origin),
    rod: Bar(mass = 0.5_kg, length = 0.4_m, angle = -90.0_deg),
    hinge: Revolute(cart.origin, rod.a),
    spring: SpringDamper(
        wall,
        cart.origin,
        stiffness = 100.0_N_per_m,
        damping = 10.0_N_s_per_m,
        length = 1.0_m,
    ),
});

fn comes_to_rest<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: M,
    step: f64,
    until: f64,
) where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let settings = Settings {
        step,
        ..Settings::default()
    };
    let mut simulation = Simulation::with_settings(mechanism, settings).expect("it assembles");
    assert_eq!(simulation.flow(), Flow::Implicit);
    simulation
        .run_until(until)
        .unwrap_or_else(|error| panic!("step {step}: {error}"));
    let speed = simulation
        .velocities()
        .iter()
        .fold(0.0, |most: f64, v| most.max(v.abs()));
    assert!(speed < 1e-4, "step {step}: still moving, {speed:.1e}");
    let report = simulation.report();
    assert_eq!(report.rejected_steps, 0, "step {step}");
    assert!(report.holonomic_error < 1e-12, "step {step}");
}

#[test]
fn mass_on_a_spring() {
    comes_to_rest(Mass::default(), 1e-2, 40.0);
    comes_to_rest(Mass::default(), 1e-3, 40.0);
}

#[test]
fn pendulum() {
    comes_to_rest(Pendulum::default(), 1e-2, 20.0);
    comes_to_rest(Pendulum::default(), 1e-3, 20.0);
    comes_to_rest(Pendulum::default(), 1e-4, 10.0);
}

#[test]
fn body_pendulum() {
    comes_to_rest(BodyPendulum::default(), 1e-2, 20.0);
    comes_to_rest(BodyPendulum::default(), 1e-3, 20.0);
    comes_to_rest(BodyPendulum::default(), 1e-4, 20.0);
}

#[test]
fn cart_with_pendulum() {
    comes_to_rest(Cart::default(), 1e-2, 60.0);
    comes_to_rest(Cart::default(), 1e-3, 60.0);
}
