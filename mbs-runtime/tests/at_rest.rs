//! A mechanism at rest allows steps of any length: they stay finite, and an input ends the rest.

use mbs_runtime::{Method, Settings, Simulation, mechanism};

mechanism!(Balance {
    world: Planar(),
    push: Input(unit = N),
    cart: Particle(mass = 1.0_kg, at = [1.0_m, 0.0_m]),
    spring: SpringDamper(
        ground.origin,
        cart.origin,
        stiffness = 1.0_kN_per_m,
        length = 1.0_m
    ),
    force: Force(on = cart.origin, value = [push, 0.0]),
});

mechanism!(Arm {
    world: Planar(),
    torque: Input(unit = Nm),
    crank: Bar(mass = 1.0_kg, length = 0.15_m, angle = 60.0_deg),
    rod: Bar(mass = 0.5_kg, length = 0.4_m, angle = -20.0_deg),
    main_bearing: Revolute(ground.origin, crank.a),
    crank_pin: Revolute(crank.b, rod.a),
    liner: PointOnLine(rod.b, ground.origin, axis = X),
    motor: Torque(on = crank, value = torque),
});

/// The constructor did not return: one candidate ran to where the steps of the other one had grown.
#[test]
fn an_accuracy_is_found() {
    for accuracy in [1e-3, 1e-6, 1e-9] {
        let mut balance = Simulation::with_accuracy(Balance::default(), accuracy).unwrap();
        balance.set_input("push", 1.0).unwrap();
        balance.run_until(1.0).unwrap();
        let frequency = 1000f64.sqrt();
        let moved = 1e-3 * (1.0 - frequency.cos());
        let error = (balance.positions()[0] - 1.0 - moved).abs();
        println!("{accuracy:e}: {error:e}, {:?}", balance.report());
        assert!(error < accuracy, "{accuracy:e}: {error:e}");

        let mut arm = Simulation::with_accuracy(Arm::default(), accuracy).unwrap();
        arm.run_until(5.0).unwrap();
        arm.set_input("torque", 0.1).unwrap();
        arm.run_until(6.0).unwrap();
        assert!(arm.report().energy_error < 1.0);
        assert!(arm.velocities().amax() > 0.1);
    }
}

/// Steps doubled until products of them overflowed; a later one then did not end.
#[test]
fn steps_without_an_end() {
    for (method, order) in [(Method::Projected, 8), (Method::TwoLevel, 8)] {
        let settings = Settings {
            method,
            order,
            ..Settings::for_tolerance(1e-6)
        };
        let mut balance = Simulation::with_any_method(Balance::default(), settings).unwrap();
        for _ in 0..3000 {
            balance.step().unwrap();
        }
        assert!(balance.time().is_finite());
        assert!(balance.time() > 1e18, "{}", balance.time());
    }
}

/// The steps with which a mechanism at rest is tried have any length; the first one of the run is that of the settings.
#[test]
fn a_first_step_at_rest_is_short() {
    let mut balance = Simulation::with_accuracy(Balance::default(), 1e-6).unwrap();
    balance.step().unwrap();
    assert!(balance.time() < 0.1, "{}", balance.time());
}

mechanism!(Kicked {
    world: Planar(),
    on: Param(1.0_s),
    x: Coordinate(0.0_m),
    block: Particle(mass = 1.0_kg, position = [x, 0.0_m]),
    all: Force(
        on = block.origin,
        value = [500.0_N * step(t - on) - 1000.0_N_per_m * x, 0.0_N]
    ),
    place: Output(x),
});

/// All of the way of a pair that begins at rest is due to the jump, and other steps differ from it by as much, however short they are.
#[test]
fn a_force_that_jumps_sets_a_body_in_motion() {
    for (k, scale) in [1.0, 1e3, 1e5].into_iter().enumerate() {
        for draw in 0..8 {
            let on = scale * (0.5 + (0.618 * f64::from(draw) + 0.1 * k as f64).fract());
            for accuracy in [1e-3, 1e-5, 1e-7] {
                let mut simulation = Simulation::with_accuracy(Kicked { on }, accuracy).unwrap();
                simulation.run_until(on + 2.0).unwrap();
                let since = simulation.time() - on;
                let exact = 0.5 * (1.0 - (1000.0_f64.sqrt() * since).cos());
                let error = (simulation.outputs().place - exact).abs();
                assert!(error < 10.0 * accuracy, "{on}, {accuracy:e}: {error:e}");
            }
        }
    }
}
