//! The motion of states.

use super::{ByJoints, Engine, apart, order, run, values};
use mbs_runtime::{Method, Settings, Simulation, mechanism};

mechanism!(Filter {
    world: Planar(),
    constant: Param(0.5_s),
    wanted: Param(2.0_V),
    bob: Particle(
        mass = 1.0_kg,
        velocity = [1.0_m_per_s, 0.0_m_per_s],
        free = true
    ),
    /// Behind the filter.
    voltage: State(initial = -1.0_V, rate = (wanted - voltage) / constant),
});

mechanism!(Servo {
    doc: "A motor with a proportional, a damping and an integral part.",
    world: Planar(),
    wanted: Param(1.0),
    mass_inertia: Param(0.5_kg_m2),
    proportional: Param(8.0_Nm),
    damping: Param(3.0_Nm_s),
    time_constant: Param(2.0_s),
    crank: Body(
        mass = 1.0_kg,
        inertia = mass_inertia,
        angle = 0.25,
        rate = 0.5_rad_per_s
    ),
    bearing: Revolute(ground.origin, crank.origin),
    charge: State(
        initial = 0.1,
        rate = (wanted - bearing.angle) / time_constant
    ),
    motor: Torque(
        bearing,
        value = proportional * (wanted - bearing.angle + charge) - damping * bearing.rate
    ),
});

/// The servo by a classical Runge–Kutta method with short steps: angle, rate, charge.
fn servo(time: f64) -> [f64; 3] {
    let rate = |[angle, speed, charge]: [f64; 3]| {
        let torque = 8.0 * (1.0 - angle + charge) - 3.0 * speed;
        [speed, torque / 0.5, (1.0 - angle) / 2.0]
    };
    let steps = 20_000;
    let h = time / f64::from(steps);
    let mut x = [0.25, 0.5, 0.1];
    let moved = |x: [f64; 3], k: [f64; 3], h: f64| std::array::from_fn(|i| x[i] + h * k[i]);
    for _ in 0..steps {
        let first = rate(x);
        let second = rate(moved(x, first, 0.5 * h));
        let third = rate(moved(x, second, 0.5 * h));
        let fourth = rate(moved(x, third, h));
        x = std::array::from_fn(|i| {
            x[i] + h / 6.0 * (first[i] + 2.0 * second[i] + 2.0 * third[i] + fourth[i])
        });
    }
    x
}

// Filters as fast as 10 µs: of a voltage, and one whose rate is not linear.
mechanism!(Stiff {
    world: Planar(),
    constant: Param(1e-5_s),
    bob: Particle(
        mass = 1.0_kg,
        velocity = [1.0_m_per_s, 0.0_m_per_s],
        free = true
    ),
    voltage: State(initial = -1.0_V, rate = (2.0_V - voltage) / constant),
    root: State(initial = 0.1, rate = (8.0 - root.powi(3)) / constant),
});

#[test]
fn a_filter_follows_its_exponential() {
    let mut filter = Simulation::new(Filter::default()).expect("a filter");
    assert_eq!(filter.outputs().voltage, -1.0);
    filter.run_until(0.7).expect("a run");
    let exact = 2.0 - 3.0 * f64::exp(-1.4);
    let error = (filter.state_value("voltage").expect("its name") - exact).abs();
    println!("{error:e}");
    assert!(error < 1e-6, "{error:e}");
    assert_eq!(filter.state_value("voltage"), filter.output("voltage"));
    // It takes no part in the energies, and the particle keeps its own.
    let energy = filter.energy();
    assert_eq!((energy.kinetic, energy.nonconservative_work), (0.5, 0.0));
    assert_eq!(energy.error, 0.0);
}

#[test]
fn a_servo_is_its_differential_equation() {
    let exact = servo(3.0);
    let settings = Settings {
        order: 8,
        ..Settings::default()
    };
    let servo = run(Servo::default(), settings, 3.0, 120);
    let found = [
        servo.coordinate("crank.angle").expect("an angle"),
        servo.velocity("crank.angle'").expect("a rate"),
        servo.state_value("charge").expect("a state"),
    ];
    for (found, exact) in found.into_iter().zip(exact) {
        println!("{found} {:e}", found - exact);
        assert!((found - exact).abs() < 1e-10, "{found} {exact}");
    }
}

#[test]
fn states_have_the_order_of_the_motion() {
    let time = 0.35;
    let exact = values(&run(Engine::default(), order(8), time, 48));
    for (of, steps) in [(2, 24), (4, 24), (6, 8), (8, 4)] {
        let error = |steps| {
            apart(
                values(&run(Engine::default(), order(of), time, steps)),
                exact,
            )
        };
        let (coarse, fine) = (error(steps), error(2 * steps));
        let slope = (coarse / fine).log2();
        println!("order {of}: {coarse:.1e} {fine:.1e} {slope:.2}");
        assert!(
            (slope - f64::from(of)).abs() < 0.1 * f64::from(of),
            "order {of}: {slope}"
        );
    }
}

#[test]
fn every_method_for_forces_of_velocities_has_states() {
    let time = 0.3;
    let exact = values(&run(Engine::default(), order(8), time, 48));
    for name in Method::NAMES {
        let settings = Settings {
            method: Method::by_name(name).expect("a method"),
            step: time / 200.0,
            placement: false,
            ..Settings::default()
        };
        match Simulation::with_any_method(Engine::default(), settings) {
            Ok(mut engine) => {
                engine.run_until(time).expect(name);
                let error = apart(values(&engine), exact);
                println!("{name}: {error:.1e}");
                // The most is 1.7e-3, of the crank's speed by the penalty method.
                assert!(error < 3e-3, "{name}: {error:e}");
                assert!(engine.energy().error.abs() < 1e-3, "{:?}", engine.energy());
            }
            Err(error) => {
                let text = error.to_string();
                println!("{text}");
                assert!(["bdf", "rattle"].contains(name), "{text}");
                assert!(text.contains(name), "{text}");
            }
        }
    }
}

#[test]
fn tolerances_hold_for_states() {
    let time = 0.3;
    let exact = values(&run(Engine::default(), order(8), time, 48));
    for tolerance in [1e-4, 1e-6] {
        let settings = Settings {
            tolerance: Some(tolerance),
            ..order(4)
        };
        let mut engine = Simulation::with_settings(Engine::default(), settings).expect("a start");
        engine.run_until(time).expect("a run");
        let error = apart(values(&engine), exact);
        println!(
            "{tolerance:e}: {error:.1e} in {} steps",
            engine.report().steps
        );
        assert!(error < tolerance, "{error:e}");
    }
    // A particle in straight motion has no error: only the states ask for short steps.
    let settings = Settings {
        tolerance: Some(1e-6),
        ..order(4)
    };
    let mut filter = Simulation::with_settings(Filter::default(), settings).expect("a start");
    filter.run_until(0.7).expect("a run");
    let error = filter.outputs().voltage - (2.0 - 3.0 * f64::exp(-1.4));
    println!("{error:.1e} in {} steps", filter.report().steps);
    assert!(error.abs() < 1e-6 && filter.report().steps > 10);
}

#[test]
fn joint_coordinates_have_the_same_states() {
    let one = run(Engine::default(), order(6), 0.3, 40);
    let other = run(ByJoints::default(), order(6), 0.3, 40);
    let outputs = other.outputs();
    let error = apart(values(&one), [outputs.speed, outputs.seen, outputs.charge]);
    println!("{error:e}");
    assert!(error < 1e-7, "{error:e}");
    let energies = [one.energy(), other.energy()];
    let apart = (energies[0].kinetic - energies[1].kinetic).abs();
    assert!(apart < 1e-7 && energies.iter().all(|energy| energy.error.abs() < 1e-5));
}

#[test]
fn stiff_states_stay_bounded_and_settle() {
    let settings = Settings {
        step: 1e-2,
        ..Settings::default()
    };
    let mut stiff = Simulation::with_settings(Stiff::default(), settings).expect("a start");
    let far = |stiff: &StiffSimulation| {
        let outputs = stiff.outputs();
        [outputs.voltage - 2.0, outputs.root - 2.0].map(f64::abs)
    };
    for _ in 0..3000 {
        stiff.step().expect("a step");
        assert!(
            far(&stiff).iter().all(|far| *far < 4.0),
            "{:?}",
            stiff.outputs()
        );
    }
    let end = far(&stiff);
    println!("{end:?}");
    // A step multiplies what is left by (1 − 500)/(1 + 500) or, of the root, by (1 − 6000)/(1 + 6000).
    assert!(end[0] < 1e-4 && end[1] < 0.3, "{end:?}");
}
