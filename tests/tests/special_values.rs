//! Laws that are smooth where a norm in them, or a divisor, vanishes.

use mbs_runtime::{Method, Settings, Simulation, mechanism};

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

mechanism!(Blasius {
    doc: "Drag with the exponent 1.75 of turbulent flow along smooth walls, written in three ways.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    a: Particle(mass = 1.0_kg),
    b: Particle(mass = 1.0_kg),
    c: Particle(mass = 1.0_kg),
    first: Force(
        on = a,
        value = [
            0.0_N,
            -3.0_N * abs(a.velocity.y / 1.0_m_per_s).powf(0.75) * (a.velocity.y / 1.0_m_per_s)
        ]
    ),
    second: Force(
        on = b,
        value = -3.0_N * norm(b.velocity / 1.0_m_per_s).powf(0.75) * (b.velocity / 1.0_m_per_s)
    ),
    third: Force(
        on = c,
        value = -3.0_N
            * dot(c.velocity / 1.0_m_per_s, c.velocity / 1.0_m_per_s).powf(0.375)
            * (c.velocity / 1.0_m_per_s)
    ),
    speed_a: Output(a.velocity.y),
    speed_b: Output(b.velocity.y),
    speed_c: Output(c.velocity.y),
});

fn methods() -> [Settings; 4] {
    ["two-level", "radau", "bdf", "projected"].map(with_method)
}

fn with_method(name: &str) -> Settings {
    Settings {
        method: Method::by_name(name).unwrap(),
        step: 1e-3,
        ..Settings::default()
    }
}

/// m g = 3 N |v|^1.75 in the end. At rest the slope of |v|^0.75 is infinite, that of the force zero.
#[test]
fn drag_with_a_fractional_exponent_acts_from_rest_on() {
    let exact = -(9.81_f64 / 3.0).powf(1.0 / 1.75);
    for settings in methods() {
        let mut simulation = Simulation::with_any_method(Blasius::default(), settings).unwrap();
        simulation.run_until(5.0).unwrap();
        for name in ["speed_a", "speed_b", "speed_c"] {
            let speed = simulation.output(name).unwrap();
            assert!((speed - exact).abs() < 1e-6, "{name}: {speed} for {exact}");
        }
    }
}

mechanism!(Progressive {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    weight: Particle(mass = 1.0_kg),
    spring: Force(
        on = weight,
        value = [
            0.0_N,
            -30.0_N * abs(weight.origin.y / 1.0_m).powf(0.6) * (weight.origin.y / 1.0_m)
        ]
    ),
    energy: Output(
        0.5_kg * weight.velocity.y.powi(2)
            + 9.81_N * weight.origin.y
            + 30.0_N_m / 2.6 * abs(weight.origin.y / 1.0_m).powf(2.6)
    ),
});

#[test]
fn a_spring_with_a_fractional_exponent_is_relaxed_where_its_slope_has_one() {
    for settings in methods() {
        let mut simulation = Simulation::with_any_method(Progressive::default(), settings).unwrap();
        simulation.run_until(1.0).unwrap();
        let energy = simulation.output("energy").unwrap();
        assert!(energy.abs() < 1e-4, "{energy} J");
    }
}

mechanism!(Rut {
    doc: "A bead on the curve y = |x|³ whose lowest place has third derivatives of a root.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    x: Coordinate(0.0_m, rate = 1.0_m_per_s),
    bead: Particle(
        mass = 1.0_kg,
        position = [x, sqrt(x * x / 1.0_m2) * x * x / 1.0_m]
    ),
    still: Coordinate(0.0_m),
    other: Particle(
        mass = 1.0_kg,
        position = [still, (still * still / 1.0_m2).powf(1.25) * still]
    ),
});

/// 1/s⁵ of a root s that vanishes.
#[test]
fn a_curve_with_a_root_passes_its_lowest_place() {
    for name in ["two-level", "rattle", "radau", "bdf"] {
        let settings = with_method(name);
        let mut simulation = Simulation::with_any_method(Rut::default(), settings).unwrap();
        simulation.run_until(1.0).unwrap();
        let error = simulation.report().energy_error;
        assert!(error < 1e-3, "{name}: {error} J");
    }
}
