//! Steps of all methods under forces of the user: works, inputs that jump, uneven lengths, many turns.

use mbs_runtime::{
    FixedStepSimulation, GeneralizedAlphaSettings, Method, PaperSettings, Settings, Simulation,
    SimulationError, mechanism,
};

mechanism!(Rod {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Natural),
    torque: Input(unit = Nm),
    rod: Bar(mass = 1.0_kg, length = 1.0_m, angle = 0.0_deg),
    pivot: Revolute(ground.origin, rod.a),
    motor: Torque(on = rod, value = torque),
    angle: Output(rod.angle),
});

mechanism!(Rotor {
    world: Spatial(),
    spin: Param(100.0_rad_per_s),
    damping: Param(0.0_N_m_s),
    rotor: Body(
        mass = 1.0_kg,
        inertia = diag(0.02_kg_m2, 0.03_kg_m2, 0.05_kg_m2),
        angular_velocity = [0.0, 0.0, spin]
    ),
    brake: Torque(on = rotor, value = -damping * rotor.angular_velocity),
    cosine: Output(rotor.x.x),
    sine: Output(rotor.x.y),
});

mechanism!(FourBar {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Joint),
    start: Param(1.0_rad),
    crank: Bar(
        mass = 1.0_kg,
        length = 0.15_m,
        angle = start,
        rate = 30.0_rad_per_s
    ),
    rod: Bar(mass = 0.5_kg, length = 0.5_m, angle = 20.0_deg),
    rocker: Bar(mass = 0.5_kg, length = 0.4_m, angle = 70.0_deg),
    b0: Revolute(ground.origin, crank.a),
    b1: Revolute(crank.b, rod.a),
    b2: Revolute(ground.point(0.45_m, 0.0), rocker.a),
    b3: Revolute(rod.b, rocker.b),
});

mechanism!(Sled {
    world: Planar(),
    drag: Param(0.2_N_s_per_m),
    sled: Body(
        mass = 3.0_kg,
        inertia = 0.8_kg_m2,
        center_of_mass = [0.35_m, 0.0],
        at = [0.0_m, 0.0_m],
        velocity = [-1.2_m_per_s, 0.0],
        angle = 0.0,
        rate = 0.6_rad_per_s
    ),
    edge: Nonholonomic(dot(sled.velocity, sled.y)),
    brake: Force(on = sled.center, value = -drag * sled.center.velocity),
});

fn settings(method: Method, step: f64) -> Settings {
    Settings {
        method,
        step,
        ..Settings::default()
    }
}

/// RATTLE counted no work of inputs, and ended runs with `EnergyGain`.
#[test]
fn works_of_inputs_count_with_every_method() {
    for method in Method::NAMES {
        let method = Method::by_name(method).unwrap();
        let mut simulation =
            Simulation::with_any_method(Rod::default(), settings(method, 1e-3)).unwrap();
        simulation.set_input("torque", 8.0).unwrap();
        simulation.run_until(2.0).unwrap();
        let energy = simulation.energy();
        println!("{}: {energy:?}", method.name());
        assert!(energy.nonconservative_work > 10.0, "{}", method.name());
        let error = energy.error.abs();
        assert!(
            error < 0.02 * energy.nonconservative_work,
            "{}: {error}",
            method.name()
        );
    }
}

/// The columns of such steps end on both sides of half a turn.
#[test]
fn extrapolated_steps_turn_by_half_a_turn() {
    let spin = 100.0 * std::f64::consts::PI;
    for (order, turns) in [(4, 0.5), (6, 0.5), (8, 0.5), (8, 0.4999), (4, 0.45)] {
        let step = 2.0 * std::f64::consts::PI * turns / spin;
        let settings = Settings {
            order,
            step,
            placement: false,
            ..Settings::default()
        };
        let rotor = Rotor { spin, damping: 0.0 };
        let mut simulation = Simulation::with_settings(rotor, settings).unwrap();
        for number in 1..=20 {
            simulation.step().unwrap();
            let (sine, cosine) = (2.0 * std::f64::consts::PI * turns * f64::from(number)).sin_cos();
            let found = simulation.outputs();
            let error = (found.sine - sine).abs().max((found.cosine - cosine).abs());
            assert!(
                error < 1e-9,
                "order {order}, {turns} turns, step {number}: {error}"
            );
        }
    }
}

/// Where an input jumps, the last step does not tell how exact the first correction is.
#[test]
fn radau_keeps_its_order_with_inputs_that_jump() {
    let end = |step: f64| {
        let settings = Settings {
            placement: false,
            ..settings(Method::Radau, step)
        };
        let mut simulation = Simulation::with_any_method(Rod::default(), settings).unwrap();
        for number in 0..20 {
            let torque = if number % 2 == 0 { 20.0 } else { -20.0 };
            simulation.set_input("torque", torque).unwrap();
            simulation.run_until(0.1 * f64::from(number + 1)).unwrap();
        }
        (simulation.outputs().angle, simulation.energy().error.abs())
    };
    let right = end(1e-3).0;
    let [coarse, fine] = [0.02, 0.005].map(|step| {
        let (angle, energy) = end(step);
        ((angle - right).abs(), energy)
    });
    println!("{coarse:?} {fine:?}");
    // By 4⁵; measured 1/960 and 1/1000.
    assert!(fine.0 < coarse.0 / 500.0 && fine.1 < coarse.1 / 500.0);
}

/// Generalized alpha had order one where lengths alternate, or an input is set in each step.
#[test]
fn generalized_alpha_keeps_its_order() {
    let end = |spectral_radius: f64, step: f64, uneven: f64| {
        let method = Method::GeneralizedAlpha(GeneralizedAlphaSettings {
            spectral_radius,
            ..GeneralizedAlphaSettings::default()
        });
        let settings = Settings {
            placement: false,
            ..settings(method, step)
        };
        let mut simulation = Simulation::with_any_method(Rod::default(), settings).unwrap();
        let piece = uneven * step;
        let pieces = (0.6 / piece + 1e-9) as u32;
        for number in 1..=pieces {
            if uneven == 1.0 {
                let tiny = if number % 2 == 0 { 1e-13 } else { 0.0 };
                simulation.set_input("torque", tiny).unwrap();
            }
            simulation.run_until(f64::from(number) * piece).unwrap();
        }
        simulation.run_until(0.6).unwrap();
        simulation.outputs().angle
    };
    let right = end(0.8, 1e-4, 1.5);
    for radius in [0.0, 0.2, 0.5, 0.8, 1.0] {
        for uneven in [1.5, 1.25, 1.2, 1.1, 1.05, 1.0] {
            let errors = [0.01, 0.005, 0.0025].map(|h| (end(radius, h, uneven) - right).abs());
            assert!(
                errors[2] < errors[0] / 11.0,
                "{radius} {uneven}: {errors:?}"
            );
        }
    }
}

/// Round-off grows with the angle of a crank: after some hours, rows cannot be satisfied to more digits than the angle has.
#[test]
fn a_crank_turns_millions_of_times() -> Result<(), SimulationError> {
    for turns in [1e6, 1e8] {
        let start = 1.0 + 2.0 * std::f64::consts::PI * turns;
        let four_bar = FourBar { start };
        let mut simulation = Simulation::with_settings(four_bar, Settings::default())?;
        simulation.run_until(0.2)?;
        assert_eq!(simulation.report().rejected_steps, 0);
        let state = Simulation::with_settings(four_bar, Settings::default())?;
        let state = state.state().clone();
        let mut fixed = FixedStepSimulation::resume(four_bar, Settings::default(), state)?;
        for _ in 0..200 {
            fixed.step()?;
        }
    }
    Ok(())
}

/// The rows of an extrapolated step were corrected by half of what was missing.
#[test]
fn rows_of_extrapolated_steps_are_satisfied() {
    for order in [4, 6, 8] {
        for step in [0.5, 0.2, 0.05] {
            let settings = Settings {
                order,
                ..settings(Method::TwoLevel, step)
            };
            let mut simulation = Simulation::with_settings(Sled::default(), settings).unwrap();
            simulation.run_until(2.0).unwrap();
            let error = simulation.report().velocity_error;
            assert!(error < 1e-12, "order {order}, step {step}: {error:e} m/s");
        }
    }
}

#[test]
fn updates_at_least_are_not_more_than_at_most() {
    let paper = PaperSettings {
        min_updates: 40,
        ..PaperSettings::default()
    };
    let refused = Simulation::with_any_method(Rod::default(), settings(Method::Paper(paper), 1e-3));
    let message = refused.err().map(|error| error.to_string());
    assert_eq!(
        message.as_deref(),
        Some("setting `min_updates` is 40; give it at most `max_updates`")
    );
}

mechanism!(Door {
    world: Planar(),
    torque: Input(unit = Nm),
    bias: Input(unit = Nm),
    leaf: Body(
        mass = 20.0_kg,
        inertia = 2.0_kg_m2,
        center_of_mass = [0.4_m, 0.0_m],
        rate = 2.0_rad_per_s
    ),
    hinge: Revolute(ground.origin, leaf.origin),
    push: Torque(on = leaf, value = torque + bias),
    limits: Stop(
        leaf.angle,
        lower = 0.0_deg,
        upper = 90.0_deg,
        stiffness = 2.0_kNm,
        onset = 1.0_deg,
        dissipation = 0.2_s
    ),
    turned: Event(leaf.rate),
});

/// Steps of a method with a memory depend on the trials before: the state after the search could be that just before the change.
#[test]
fn an_event_is_found_once() {
    let settings = Settings {
        method: Method::Radau,
        tolerance: Some(1e-4),
        ..Settings::default()
    };
    for k in 0..60 {
        let mut door =
            Simulation::with_methods(Door::default(), settings, mbs_runtime::methods::Any)
                .expect("it assembles");
        door.inputs_mut().torque = -3.0 + 0.1173 * f64::from(k);
        let mut last = f64::NEG_INFINITY;
        while let Some(time) = door.run_to_event("turned", 4.0).expect("it runs") {
            assert!(time > last + 1e-9, "{k}: {last} and {time}");
            last = time;
        }
    }
}

/// What was given with a refused value waits for it to be set again; it does not come back later, and is not lost.
#[test]
fn inputs_beside_a_refused_one_are_kept() {
    let door = || Simulation::new(Door::default()).expect("it assembles");
    let mut simulation = door();
    simulation.inputs_mut().torque = f64::NAN;
    simulation.set_input("bias", 2.0).expect("it is finite");
    simulation.inputs_mut().torque = 1.0;
    assert_eq!(simulation.input_values(), [1.0, 2.0]);
    let mut simulation = door();
    {
        let mut inputs = simulation.inputs_mut();
        (inputs.torque, inputs.bias) = (f64::NAN, 3.0);
    }
    simulation.set_input("torque", 1.0).expect("it is finite");
    assert_eq!(simulation.input_values(), [1.0, 3.0]);
    let mut simulation = door();
    {
        let mut inputs = simulation.inputs_mut();
        (inputs.torque, inputs.bias) = (f64::NAN, f64::NAN);
    }
    simulation.set_input("torque", 1.0).expect("it is finite");
    assert_eq!(simulation.input_values(), [1.0, 0.0]);
    let error = simulation
        .step()
        .expect_err("the bias is no number")
        .to_string();
    assert!(error.contains("bias"), "{error}");
}
