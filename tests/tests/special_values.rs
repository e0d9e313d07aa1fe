//! Laws that are smooth where a norm in them, or a divisor, vanishes.

use mbs_runtime::{Settings, Simulation, mechanism};

mechanism!(Falling {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    drag: Param(0.5_kg_per_m),
    stone: Particle(mass = 1.0_kg),
    resistance: Force(
        on = stone,
        value = -drag * norm(stone.velocity) * stone.velocity
    ),
    height: Output(stone.origin.y),
});

/// v = √(m g/k) tanh(√(g k/m) t), y = −(m/k) ln cosh(√(g k/m) t).
#[test]
fn quadratic_drag_acts_from_rest_on() {
    let (drag, gravity, time) = (0.5, 9.81_f64, 1.0);
    let exact = -((gravity * drag).sqrt() * time).cosh().ln() / drag;
    for (settings, allowed) in [
        (Settings::default(), 1e-5),
        (Settings::for_tolerance(1e-6), 1e-5),
        (Settings::accuracy(1e-6), 1e-5),
    ] {
        let mut simulation = Simulation::with_settings(Falling { drag }, settings).unwrap();
        simulation.run_until(time).unwrap();
        let height = simulation.output("height").unwrap();
        assert!(
            (height - exact).abs() < allowed,
            "{settings:?}: {height} for {exact}"
        );
    }
}

mechanism!(Damped {
    world: Planar(),
    block: Particle(mass = 1.0_kg, velocity = [0.3_m_per_s, 0.4]),
    resistance: Force(
        on = block,
        value = -0.5_kg_per_m * norm(block.velocity) * block.velocity
            - 100.0_N_s_per_m * block.velocity
    ),
});

/// Squares of the velocity underflow long before the velocity does.
#[test]
fn drag_brings_to_rest() {
    let mut simulation = Simulation::new(Damped::default()).unwrap();
    simulation.run_until(8.0).unwrap();
    assert!(simulation.velocities().amax() < 1e-150);
}

mechanism!(Jumper {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    jumper: Particle(mass = 80.0_kg, at = Exactly([0.0, 0.0, 0.0])),
    rope: Stop(
        norm(jumper.origin - ground.origin),
        upper = 2.0_m,
        stiffness = 1e5_N_per_m,
        onset = 1.0_mm,
        dissipation = 0.1_s_per_m
    ),
    height: Output(jumper.origin.z),
});

#[test]
fn a_rope_is_slack_at_its_hook() {
    for settings in [Settings::default(), Settings::accuracy(1e-6)] {
        let mut simulation = Simulation::with_settings(Jumper::default(), settings).unwrap();
        simulation.run_until(0.5).unwrap();
        let height = simulation.output("height").unwrap();
        assert!((height + 0.5 * 9.81 * 0.25).abs() < 1e-6, "{height}");
        simulation.run_until(1.0).unwrap();
        assert!(simulation.output("height").unwrap() > -2.2);
    }
}

mechanism!(Tied {
    world: Planar(),
    length: Param(0.0_m),
    ball: Particle(mass = 1.0_kg, velocity = [1.0_m_per_s, 0.0]),
    spring: SpringDamper(
        ground.origin,
        ball,
        stiffness = 100.0_N_per_m,
        length = length
    ),
    x: Output(ball.origin.x),
});

/// x = sin(10 t)/10.
#[test]
fn a_spring_without_length_is_relaxed_where_its_points_meet() {
    let mut simulation = Simulation::with_accuracy(Tied::default(), 1e-8).unwrap();
    simulation.run_until(1.0).unwrap();
    let x = simulation.output("x").unwrap();
    assert!((x - 0.1 * 10.0_f64.sin()).abs() < 1e-8, "{x}");
}

mechanism!(Hanging {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    plate: Body(mass = 1.0_kg, inertia = 1.0_kg_m2, at = [0.0_m, 0.0]),
    pin: Revolute(ground.origin, plate.point(0.0, -0.5_m)),
    height: Output(plate.origin.y),
});

/// The guess puts another point of the body where its joint is: the start ended with an error.
#[test]
fn a_body_may_be_guessed_at_its_pin() {
    let mut simulation = Simulation::new(Hanging::default()).unwrap();
    simulation.run_until(0.1).unwrap();
    let height = simulation.output("height").unwrap();
    assert!((-0.5 - 1e-9..=0.5 + 1e-9).contains(&height), "{height}");
    assert!(simulation.report().energy_error < 1e-2);
}
