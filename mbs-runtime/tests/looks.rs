//! Looks at instants of the last step change nothing of the motion.

use mbs_runtime::{
    BaumgarteSettings, Mechanism, Method, Settings, Simulation, SimulationError, System, mechanism,
};

mechanism!(SliderCrank {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Natural),
    crank: Bar(
        mass = 1.0_kg,
        length = 0.15_m,
        angle = 60.0_deg,
        rate = 2.0_rad_per_s
    ),
    rod: Bar(mass = 0.5_kg, length = 0.4_m, angle = -20.0_deg),
    main_bearing: Revolute(ground.origin, crank.a),
    crank_pin: Revolute(crank.b, rod.a),
    liner: PointOnLine(rod.b, ground.origin, axis = X),
    brake: TorsionSpring(ground, crank, damping = 0.05_N_m_s),
});

/// Multistep methods began anew after each look, and Radau forgot its factors: 618 steps instead of 612.
#[test]
fn the_motion_of_every_method_is_the_same() {
    let named = Method::NAMES
        .iter()
        .filter_map(|name| Method::by_name(name));
    let mut runs: Vec<(Method, Option<f64>, u8)> = named
        .map(|method| match method {
            Method::TwoLevel | Method::Baumgarte(_) => (method, None, 4),
            Method::Projected => (method, Some(1e-6), 8),
            Method::Radau => (method, Some(1e-6), 2),
            _ => (method, None, 2),
        })
        .collect();
    let adaptive = BaumgarteSettings {
        adaptive: Some(1e-6),
        ..BaumgarteSettings::default()
    };
    runs.push((Method::TwoLevel, Some(1e-6), 8));
    runs.push((Method::Baumgarte(adaptive), None, 4));
    assert_eq!(runs.len(), Method::NAMES.len() + 2);
    for (method, tolerance, order) in runs {
        let name = method.name();
        let settings = Settings {
            method,
            tolerance,
            order,
            step: 5e-3,
            ..Settings::default()
        };
        let Ok(mut alone) = Simulation::with_any_method(SliderCrank::default(), settings) else {
            // RATTLE has no forces of velocity.
            assert_eq!(name, "rattle");
            continue;
        };
        let mut seen = alone.clone();
        for instant in 1..=200 {
            let time = 0.005 * f64::from(instant);
            alone.run_past(time, 1.0).unwrap();
            seen.run_past(time, 1.0).unwrap();
            seen.look_at(time, &mut |_| ()).unwrap();
            let between = time - 0.3 * 0.005;
            let _ = seen.look_at(between, &mut |_| ());
        }
        let steps = [&alone, &seen].map(|simulation| simulation.report().steps);
        assert_eq!(steps[0], steps[1], "{name}");
        let apart = (alone.positions() - seen.positions()).amax();
        println!("{name}: {apart:e}");
        assert_eq!(apart, 0.0, "{name}");
    }
}

mechanism!(Bob {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    bob: Particle(mass = 1.0_kg, at = [1.5_m, 0.0]),
    spring: SpringDamper(
        ground.origin,
        bob.origin,
        stiffness = 1e6_N_per_m,
        length = 1.0_m
    ),
    shake: Force(
        on = bob.origin,
        value = [3000.0_N * sin(10.0_per_s * t), 0.0]
    ),
});

/// Steps that are much too long for the spring are refused by their energy balance. The doubts about works of looks counted
/// as those of the motion: with enough looks no step was refused.
#[test]
fn the_energy_guard_sees_the_motion_alone() {
    let end = |looks: u32| -> Result<(), SimulationError> {
        let step = 1e-2;
        let settings = Settings {
            step,
            ..Settings::default()
        };
        let mut simulation = Simulation::with_settings(Bob::default(), settings)?;
        while simulation.time() < 1.0 {
            let before = simulation.time();
            simulation.run_past(before + step, before + step)?;
            let length = simulation.time() - before;
            for look in 0..looks {
                let part = (f64::from(look) + 0.5) / f64::from(looks);
                let _ = simulation.look_at(before + part * length, &mut |_| ());
            }
        }
        Ok(())
    };
    let alone = end(0);
    assert!(alone.is_err());
    assert_eq!(end(3000), alone);
}

/// Such an instant was computed again from an earlier one, over many steps: another motion than the one of the run.
#[test]
fn only_instants_of_the_last_step_are_shown() {
    let mut crank = Simulation::new(SliderCrank::default()).unwrap();
    crank.run_past(0.1, 1.0).unwrap();
    crank.look_at(crank.time() - 1e-4, &mut |_| {}).unwrap();
    crank.run_until(0.5).unwrap();
    for wanted in [0.2, 0.4999] {
        let refused = crank.look_at(wanted, &mut |_| {});
        assert!(
            matches!(refused, Err(SimulationError::Time { .. })),
            "{refused:?}"
        );
    }
    crank.run_past(0.6, 1.0).unwrap();
    let last = crank.time() - 1e-4;
    crank.step().unwrap();
    assert!(crank.look_at(last, &mut |_| {}).is_err());
}

mechanism!(Driven {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    lead: Input(0.1_rad),
    crank: Bar(mass = 1.0_kg, length = 0.3_m, angle = 60.0_deg),
    rod: Bar(mass = 0.5_kg, length = 0.7_m, angle = -20.0_deg),
    piston: Particle(mass = 2.0_kg),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    gudgeon: Revolute(rod.b, piston.origin),
    guide: PointOnLine(piston.origin, ground.origin, axis = X),
    drive: Drive(crank.angle, value = 1.0 + 5.0_rad_per_s * t + lead),
});

mechanism!(Shaken {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    rod: Bar(mass = 1.0_kg, length = 0.5_m, angle = 30.0_deg),
    pivot: Revolute(ground.origin, rod.a),
    shake: Force(on = rod.b, value = [5.0_N * sin(7.0_per_s * t), 0.0]),
});

/// A motion with looks, and one that is resumed at every step, against one alone.
fn goes_on_bit_for_bit<
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
    const Q: usize,
    const N: usize,
    const R: usize,
>(
    settings: Settings,
) {
    let begin = || Simulation::with_any_method(M::default(), settings).unwrap();
    let (mut alone, mut seen, mut resumed) = (begin(), begin(), begin());
    let what = format!("{} {}", settings.method.name(), settings.order);
    let end = 1.0;
    let mut instant = 0;
    while alone.time() < end {
        // Now and then a run ends between two steps.
        instant += 1;
        let until = (instant % 10 == 0).then(|| alone.time() + 0.7 * settings.step);
        for simulation in [&mut alone, &mut seen, &mut resumed] {
            match until {
                Some(time) => simulation.run_until(time).unwrap(),
                None => {
                    let next = simulation.time() + 0.1 * settings.step;
                    simulation.run_past(next, end).unwrap();
                }
            }
        }
        if until.is_none() {
            let between = seen.time() - 0.3 * settings.step;
            let _ = seen.look_at(between, &mut |_| ());
        }
        let state = resumed.state().clone();
        resumed = Simulation::resume_with_any_method(M::default(), settings, state).unwrap();
        let time = alone.time();
        assert_eq!(alone.state(), seen.state(), "{what}, a look before {time}");
        assert_eq!(
            alone.state(),
            resumed.state(),
            "{what}, resumed before {time}"
        );
    }
}

/// The end of a step was evaluated at another instant, by the rounding of the time, than the state that goes on from there.
#[test]
fn rows_and_forces_of_time_go_on_bit_for_bit() {
    let composed = [2, 4, 6, 8].map(|order| Settings {
        order,
        step: 4e-3,
        ..Settings::default()
    });
    let projected = Settings {
        method: Method::Projected,
        order: 8,
        step: 4e-3,
        ..Settings::default()
    };
    for settings in composed.into_iter().chain([projected]) {
        goes_on_bit_for_bit::<Driven, _, _, _, _>(settings);
        goes_on_bit_for_bit::<Shaken, _, _, _, _>(settings);
    }
}
