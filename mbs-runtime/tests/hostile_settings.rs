//! Settings beyond the range of numbers are refused by name; none leads to a panic or to a loop without end.

use mbs_runtime::{
    BaselineStepper, BaumgarteSettings, Flow, Foreseen, Mechanism, Method, PaperStepper, Settings,
    Simulation, SimulationError, TwoLevelStepper, mechanism,
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
});

/// Some steps, one by one: the end of a run that takes them all is refused.
fn steps(settings: Settings) -> Result<(), SimulationError> {
    let mut simulation = Simulation::with_any_method(SliderCrank::default(), settings)?;
    (0..30).try_for_each(|_| simulation.step())
}

fn setting(settings: Settings) -> &'static str {
    match steps(settings) {
        Err(SimulationError::Setting { name, .. }) => name,
        other => panic!("{settings:?}: {other:?}"),
    }
}

fn methods() -> impl Iterator<Item = Method> {
    let adaptive = Method::Baumgarte(BaumgarteSettings {
        adaptive: Some(1e-6),
        ..BaumgarteSettings::default()
    });
    let named = Method::NAMES
        .iter()
        .filter_map(|name| Method::by_name(name));
    named.chain([adaptive])
}

#[test]
fn steps_out_of_range() {
    for method in methods() {
        for step in [1e-308, f64::MIN_POSITIVE, 5e-324, 1e-101, 1e101, 1e308] {
            let settings = Settings {
                method,
                step,
                ..Settings::default()
            };
            assert_eq!(setting(settings), "step", "{}: {step:e}", method.name());
        }
    }
}

#[test]
fn tolerances_of_rows_out_of_range() {
    for method in methods() {
        for constraint_tolerance in [1e-31, 1e-160, 1e-300, 5e-324, 0.0] {
            let settings = Settings {
                method,
                constraint_tolerance,
                ..Settings::default()
            };
            assert_eq!(setting(settings), "constraint_tolerance");
        }
    }
}

/// What is within the range ends, well or with an error.
#[test]
fn the_bounds_themselves_end() {
    for method in methods() {
        for step in [1e-100, 1e-60, 1e-38, 1e-20, 1e10, 1e38, 1e100] {
            // Algorithm 1 divides a long step, and runs for hundreds of seconds.
            if step > 1.0 && matches!(method, Method::Paper(_) | Method::MAlf(_)) {
                continue;
            }
            let settings = Settings {
                method,
                step,
                ..Settings::default()
            };
            let _ = steps(settings);
        }
        for constraint_tolerance in [1e-30, 1e-18, 1e-2, 1e3, 1e300] {
            let settings = Settings {
                method,
                constraint_tolerance,
                ..Settings::default()
            };
            let _ = steps(settings);
        }
    }
}

#[test]
fn tiny_first_steps_with_a_tolerance() {
    for order in [2, 4, 6, 8] {
        for step in [1e-100, 1e-60, 1e-38, 1e-20, 1e-12] {
            let settings = Settings {
                order,
                step,
                tolerance: Some(1e-6),
                ..Settings::default()
            };
            steps(settings).unwrap_or_else(|error| panic!("{order} {step:e}: {error}"));
        }
    }
}

#[test]
fn tiny_first_steps_of_the_projected_method() {
    for step in [1e-100, 1e-60, 1e-42, 1e-38, 1e-20] {
        let settings = Settings {
            method: Method::Projected,
            order: 8,
            step,
            ..Settings::for_tolerance(1e-6)
        };
        steps(settings).unwrap_or_else(|error| panic!("{step:e}: {error}"));
    }
}

/// The first step is only the first that is tried.
#[test]
fn any_first_step_with_a_tolerance_reaches_the_end() {
    for step in [1e-30, 1e-10, 1e4, 1e12, 1e50] {
        let settings = Settings {
            step,
            ..Settings::for_tolerance(1e-6)
        };
        let mut simulation = Simulation::with_settings(SliderCrank::default(), settings).unwrap();
        simulation
            .run_until(1.0)
            .unwrap_or_else(|error| panic!("{step:e}: {error}"));
        let error = simulation.report().energy_error;
        assert!(error < 1e-5, "{step:e}: {error:e} J");
    }
    let settings = Settings {
        step: 1e-10,
        ..Settings::for_tolerance(1e-3)
    };
    let mut simulation = Simulation::with_settings(SliderCrank::default(), settings).unwrap();
    simulation.run_until(2000.0).unwrap();
}

/// A run from a state with a clock that is not a number did not end.
#[test]
fn states_that_are_not_finite_are_refused() {
    let settings = Settings::for_tolerance(1e-6);
    let mut simulation = Simulation::with_settings(SliderCrank::default(), settings).unwrap();
    simulation.run_until(0.01).unwrap();
    let state = simulation.state();
    let changed: [fn(&mut mbs_runtime::State<_, _, _>); 14] = [
        |state| state.clock = f64::NAN,
        |state| state.ledger.nonconservative_work = f64::NAN,
        |state| state.ledger.initial = Some(f64::INFINITY),
        |state| state.step_controller.step = -1e-3,
        |state| state.step_controller.estimate_factor = f64::NAN,
        |state| state.step_controller.difficulty = Some(f64::NAN),
        |state| state.step_controller.caution = -1.0,
        |state| state.step_controller.usual = f64::NAN,
        |state| state.fields.momentum[0] = f64::NAN,
        |state| state.multipliers[0] = f64::NAN,
        |state| state.inputs = vec![1.0],
        |state| {
            // Every step would have been taken in 100,000 parts.
            state.poses_ahead.foreseen = Some(Foreseen::Turn {
                least: 0.0,
                rate: -1.0,
            });
        },
        |state| {
            state.poses_ahead.foreseen = Some(Foreseen::Turn {
                least: 0.0,
                rate: 0.0,
            });
        },
        |state| state.poses_ahead.foreseen = Some(Foreseen::Singular(f64::NAN)),
    ];
    for (index, change) in changed.into_iter().enumerate() {
        let mut state = state.clone();
        change(&mut state);
        let resumed = Simulation::resume(SliderCrank::default(), settings, state);
        let refused = matches!(resumed, Err(SimulationError::State { .. }));
        assert!(refused, "change {index}");
    }
    // Counters at their end overflowed.
    let mut state = state.clone();
    state.step_controller.quiet = u32::MAX;
    state.step_controller.patience = u32::MAX;
    state.step_controller.pairs_since_comparison = u32::MAX;
    state.step_controller.raised = true;
    let mut resumed = Simulation::resume(SliderCrank::default(), settings, state).unwrap();
    resumed.run_until(0.5).unwrap();
}

/// A step without an end of its iterations did not end.
#[test]
fn counts_out_of_range() {
    for count in [0, 10_001, usize::MAX] {
        let most = Settings {
            max_iterations: count,
            ..Settings::default()
        };
        assert_eq!(setting(most), "max_iterations");
        let fixed = Settings {
            fixed_iterations: Some(count),
            ..Settings::default()
        };
        assert_eq!(setting(fixed), "fixed_iterations");
    }
    assert_eq!(SliderCrank::MODEL.step_flops(usize::MAX), None);
    assert_eq!(SliderCrank::MODEL.step_flops(usize::MAX - 1), None);
}

/// Settings that others overrule were ignored.
#[test]
fn settings_that_contradict_each_other() {
    for (method, order, flow) in [
        (Method::Projected, 2, None),
        (Method::TwoLevel, 4, None),
        (Method::TwoLevel, 2, Some(Flow::Midpoint)),
    ] {
        let settings = Settings {
            method,
            order,
            flow,
            ..Settings::accuracy(1e-6)
        };
        assert_eq!(setting(settings), "accuracy");
    }
    let flow = Settings {
        method: Method::Projected,
        flow: Some(Flow::Midpoint),
        ..Settings::default()
    };
    let error = steps(flow).unwrap_err();
    assert!(
        matches!(error, SimulationError::OtherMethod { .. }),
        "{error}"
    );
    let adaptive = Settings {
        method: Method::Baumgarte(BaumgarteSettings {
            adaptive: Some(1e-6),
            ..BaumgarteSettings::default()
        }),
        order: 8,
        ..Settings::default()
    };
    let error = steps(adaptive).unwrap_err();
    assert!(
        matches!(error, SimulationError::Order { order: 8, .. }),
        "{error}"
    );
}

/// Such a list has more entries than a memory.
#[test]
fn intervals_that_the_clock_cannot_count() {
    let crank = || Simulation::new(SliderCrank::default()).unwrap();
    for interval in [1e-300, 1e-20, 0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = crank().record(1.0).every(interval).run().unwrap_err().error;
        assert!(
            matches!(error, SimulationError::Setting { .. }),
            "{interval}: {error}"
        );
        let first = crank().samples(1.0, interval).next();
        assert!(
            matches!(first, Some(Err(SimulationError::Setting { .. }))),
            "{interval}"
        );
    }
    // The end is the beginning.
    assert!(crank().record(0.0).every(f64::NAN).run().is_err());
    // An end that cannot be run to is told first.
    let first = crank().samples(f64::INFINITY, 0.1).next();
    assert!(matches!(first, Some(Err(SimulationError::Time { .. }))));
}

/// Each remainder was left out: the clock went on, and the mechanism stood still.
#[test]
fn many_short_runs_go_as_far_as_a_long_one() {
    let mut long = Simulation::new(SliderCrank::default()).unwrap();
    let mut short = long.clone();
    let end = 1e-5;
    long.run_until(end).unwrap();
    for part in 1..=20_000 {
        let time = end * f64::from(part) / 20_000.0;
        short.run_until(time).unwrap();
        assert_eq!(short.time(), time);
    }
    let start = Simulation::new(SliderCrank::default()).unwrap();
    let way = long.positions() - start.positions();
    let off = long.positions() - short.positions();
    assert!(off.norm() < 2e-4 * way.norm(), "{off} {way}");
}

/// Zero is a number: the message said that the step had become infinite.
#[test]
fn steps_of_no_length() {
    let state = Simulation::new(SliderCrank::default()).unwrap();
    let (system, state) = (state.system(), state.state());
    let settings = Settings::default();
    let mut two_level = TwoLevelStepper::new(system.clone(), state.clone(), &settings).unwrap();
    let bdf = Settings {
        method: Method::by_name("bdf").unwrap(),
        ..settings
    };
    let mut bdf = BaselineStepper::new(system.clone(), state.clone(), &bdf).unwrap();
    for error in [
        two_level.step(0.0).unwrap_err(),
        two_level.step(f64::NAN).unwrap_err(),
        bdf.step(-1e-3).unwrap_err(),
        bdf.step(0.0).unwrap_err(),
    ] {
        assert!(
            matches!(error, SimulationError::Setting { name: "step", .. }),
            "{error}"
        );
    }
    let rattle = Settings {
        method: Method::Rattle,
        ..settings
    };
    for error in [
        PaperStepper::new(system.clone(), state.clone(), &rattle).unwrap_err(),
        TwoLevelStepper::new(system.clone(), state.clone(), &rattle).unwrap_err(),
        BaselineStepper::new(system.clone(), state.clone(), &settings).unwrap_err(),
    ] {
        assert!(
            matches!(error, SimulationError::OtherMethod { .. }),
            "{error}"
        );
    }
}

mechanism!(Contradicted {
    world: Planar(),
    fast: Param(2.0_rad_per_s),
    bar: Bar(mass = 1.0_kg, length = 1.0_m),
    pivot: Revolute(ground.origin, bar.a),
    first: Drive(bar.angle, value = t * 1.0_rad_per_s),
    second: Drive(bar.angle, value = t * fast),
});

mechanism!(Infinite {
    world: Planar(),
    way: Param(0.0_m),
    bar: Bar(mass = 1.0_kg, length = 1.0_m),
    pivot: Revolute(ground.origin, bar.a),
    coil: TorsionSpring(ground, bar, stiffness = 1.0_N_m * 1.0_m / way),
});

mechanism!(Falling {
    world: Planar(gravity = [0.0, -pull]),
    pull: Param(1e308_m_per_s2),
    stone: Particle(mass = 1.0_kg, at = [0.0_m, 0.0_m], free = true),
});

/// The start was accepted, and the first step asked for a smaller step, which does not help.
#[test]
fn contradictions_of_velocities_are_named() {
    let error = Simulation::new(Contradicted::default()).unwrap_err();
    let SimulationError::Contradiction { row, rate } = &error else {
        panic!("{error}");
    };
    assert!(["first", "second"].contains(row), "{error}");
    assert!(rate.abs() > 0.4, "{error}");
    let agreed = Contradicted { fast: 1.0 };
    Simulation::new(agreed).unwrap().run_until(0.1).unwrap();
}

#[test]
fn what_is_not_finite_is_refused() {
    let error = Simulation::new(Infinite::default()).unwrap_err();
    assert!(matches!(error, SimulationError::Guess { .. }), "{error}");
    for settings in [Settings::default(), Settings::for_tolerance(1e-6)] {
        let stone = Simulation::with_settings(Falling::default(), settings);
        let error = stone
            .and_then(|mut stone| stone.run_until(2.0))
            .unwrap_err();
        println!("{error}");
    }
}
