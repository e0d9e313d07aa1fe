//! Time: steps are counted exactly, the clock never runs back, and what is not a number is refused by name.

use mbs_runtime::{Method, Settings, Simulation, SimulationError, mechanism, methods};

mechanism!(Pendulum {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    length: Param(1.0_m),
    speed: Param(0.0_rad_per_s),
    rod: Bar(
        mass = 1.0_kg,
        length = length,
        angle = 20.0_deg,
        rate = speed
    ),
    pivot: Revolute(ground.origin, rod.a),
    never: Event(sqrt(rod.b.y / length - 10.0)),
    level: Event(rod.b.y),
});

fn simulation(
    settings: Settings,
) -> Result<Simulation<impl mbs_runtime::System<1, 1, 0>, 1, 1, 0>, SimulationError> {
    Simulation::with_any_method(Pendulum::default(), settings)
}

#[test]
fn steps_are_counted() {
    for method in [Method::TwoLevel, Method::Projected] {
        for (step, steps, time) in [(1e-3, 40_000, 40.0), (1e-2, 30_000, 300.0)] {
            let settings = Settings {
                method,
                step,
                ..Settings::default()
            };
            let mut simulation = simulation(settings).unwrap();
            for _ in 0..steps {
                simulation.step().unwrap();
            }
            assert_eq!(simulation.time(), time);
        }
    }
}

#[test]
fn the_clock_does_not_run_back() {
    let mut simulation = simulation(Settings::default()).unwrap();
    simulation.run_until(1.0).unwrap();
    let state = simulation.state().clone();
    simulation.run_until(1.0 - 1e-10).unwrap();
    assert_eq!(simulation.state(), &state);
    let error = simulation.run_until(0.9).unwrap_err();
    assert!(matches!(error, SimulationError::Time { .. }), "{error}");
}

/// A millionth of such a step is longer than the run so far. Times before it were reached without an error.
#[test]
fn the_past_is_refused_whatever_the_step() {
    for step in [1e5, 1e9, 1e15] {
        let settings = Settings {
            step,
            ..Settings::default()
        };
        let mut free = Simulation::with_settings(Free::default(), settings).unwrap();
        free.run_until(0.5).unwrap();
        for wanted in [0.4, 0.0, -1e-3, -100.0] {
            let errors = [
                free.run_until(wanted).err(),
                free.run_to_event("tiny", wanted).err(),
            ];
            for error in errors {
                assert!(
                    matches!(error, Some(SimulationError::Time { .. })),
                    "{step:e}, {wanted}: {error:?}"
                );
            }
            assert_eq!(free.time(), 0.5);
        }
    }
}

#[test]
fn times_that_are_not_numbers_are_refused() {
    let mut simulation = simulation(Settings::default()).unwrap();
    for (time, latest) in [(f64::NAN, 1.0), (f64::INFINITY, 1.0), (0.5, f64::INFINITY)] {
        let error = simulation.run_past(time, latest).unwrap_err();
        assert!(matches!(error, SimulationError::Time { .. }), "{error}");
    }
    assert!(simulation.run_until(f64::NAN).is_err());
    assert_eq!(simulation.time(), 0.0);
}

#[test]
fn an_event_that_is_no_number_is_an_error() {
    let mut simulation = simulation(Settings::default()).unwrap();
    assert!(simulation.run_to_event("level", 1.0).unwrap().is_some());
    let error = simulation.run_to_event("never", 1.0).unwrap_err();
    assert!(
        matches!(error, SimulationError::Event { event: "never", .. }),
        "{error}"
    );
    assert!(error.to_string().contains("`never`"), "{error}");
}

#[test]
fn a_guess_that_is_no_number_is_named() {
    let pendulum = Pendulum {
        speed: f64::NAN,
        ..Pendulum::default()
    };
    let error = Simulation::new(pendulum).err().unwrap();
    assert!(!error.to_string().contains("resume"), "{error}");
}

mechanism!(Free {
    world: Planar(),
    particle: Particle(
        mass = 1.0_kg,
        at = [0.0_m, 0.0_m],
        velocity = [1.0_m_per_s, 0.0]
    ),
    tiny: Event(1e-200 * (particle.origin.x - 0.3_m)),
});

/// Runs that are shorter than the round-off of a time add up. The particle had not moved.
#[test]
fn short_runs_add_up_at_large_times() {
    for (time, piece) in [(1.7e9, 1e-6), (1.7e9, 1.001e-3), (1e9, 1.0005e-3)] {
        for settings in [Settings::default(), Settings::for_tolerance(1e-6)] {
            let start = Simulation::with_settings(Free::default(), settings).unwrap();
            let mut state = start.state().clone();
            state.time = time;
            let mut late = Simulation::resume(Free::default(), settings, state).unwrap();
            for number in 1..=1000 {
                late.run_until(time + f64::from(number) * piece).unwrap();
            }
            let moved = late.positions()[0];
            assert!(
                (moved - 1000.0 * piece).abs() < 2e-6,
                "{time:e}, {piece}: {moved} m"
            );
        }
    }
}

/// A run that is less than a millionth of the given step moves: it is one step. It ended well without any motion.
#[test]
fn runs_much_shorter_than_the_step_move() {
    for step in [1e5, 1e7, 1e9] {
        let settings = Settings {
            step,
            ..Settings::default()
        };
        let mut free = Simulation::with_settings(Free::default(), settings).unwrap();
        let found = free.run_to_event("tiny", 1.0).unwrap().unwrap();
        assert!((found - 0.3).abs() < 1e-9, "{step:e}: {found}");
        free.run_until(0.5).unwrap();
        free.run_past(0.6, 0.7).unwrap();
        assert_eq!(free.time(), 0.7);
        let steps = free.report().steps;
        for number in 8..=100 {
            let time = 0.1 * f64::from(number);
            free.run_until(time).unwrap();
            let place = free.positions()[0];
            assert!((place - time).abs() < 1e-12, "{step:e}: {place} {time}");
        }
        assert_eq!(free.report().steps, steps + 93);
    }
}

#[test]
fn events_of_tiny_values_are_found() {
    let mut simulation = Simulation::new(Free::default()).unwrap();
    let found = simulation.run_to_event("tiny", 1.0).unwrap();
    let time = found.expect("the particle passes the place");
    assert!((time - 0.3).abs() < 1e-9, "{time}");
}

mechanism!(Falling {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    rod: Bar(mass = 1.0_kg, length = 0.5_m, angle = 1.3_rad),
    pivot: Revolute(ground.origin, rod.a),
    plain: Event(rod.angle - 1.0),
    plateau: Event(max(rod.angle - 1.0, 0.0)),
    on: Event(step(rod.angle - 1.0)),
    touch: Event((t - 0.5_s) * (t - 0.5_s)),
});

/// Expressions that are 0 after the change were found at the end of the step, 50 and 100 ms late.
#[test]
fn the_first_instant_of_zero_is_found() {
    let coarse = Settings {
        order: 4,
        step: 0.02,
        ..Settings::default()
    };
    let tolerance = Settings::for_tolerance(1e-6);
    for settings in [coarse, tolerance, Settings::accuracy(1e-6)] {
        let begin =
            || Simulation::with_methods(Falling::default(), settings, methods::Accuracy).unwrap();
        let time = |event| begin().run_to_event(event, 1.0).unwrap().unwrap();
        let plain = time("plain");
        assert!((plain - 0.25613).abs() < 1e-5, "{plain}");
        for event in ["plateau", "on"] {
            let found = time(event);
            assert!((found - plain).abs() < 1e-11, "{event}: {found} {plain}");
        }
        let mut falling = begin();
        falling.run_to_event("plateau", 1.0).unwrap();
        // It stays 0, and is an event again only after it has had a sign.
        assert_eq!(falling.run_to_event("plateau", 0.4).unwrap(), None);
    }
    // The end of a step is a root: few stages tell that it is the first instant of zero.
    let mut falling = Simulation::with_settings(Falling::default(), coarse).unwrap();
    let found = falling.run_to_event("touch", 1.0).unwrap();
    assert_eq!(found, Some(0.5));
    let stages = falling.report().stages;
    assert!(stages < 25 * 7 + 60, "{stages}");
}

/// A pair that goes to the end of the run passes the last sample.
#[test]
fn the_last_sample_is_at_its_instant() {
    for settings in [
        Settings::default(),
        Settings::for_tolerance(1e-6),
        Settings::accuracy(1e-6),
    ] {
        let mut simulation = simulation(settings).unwrap();
        let samples = simulation.samples(1.005, 0.01);
        let times: Vec<f64> = samples.map(|sample| sample.unwrap().time).collect();
        assert_eq!(times.len(), 101);
        for (number, time) in times.iter().enumerate() {
            assert!((time - 0.01 * number as f64).abs() < 1e-12, "{time}");
        }
    }
}

/// A cart on a rail that follows a program of the time since `start`, with a rod that hangs from it.
macro_rules! cart {
    ($name:ident, $place:expr) => {
        mechanism!($name {
            world: Planar(gravity = [0.0, -9.81_m_per_s2]),
            start: Param(0.0_s),
            cart: Body(mass = 5.0_kg, inertia = 1.0_kg_m2),
            rail: Prismatic(ground.origin, cart.origin, axis = X),
            later: Let(max(0.0_s, t - start - 1.0_s)),
            motor: Drive(rail.stroke, value = $place),
            rod: Bar(mass = 1.0_kg, length = 0.5_m, angle = -90.0_deg),
            hang: Revolute(cart.origin, rod.a),
            swing: Output(rod.angle),
            allow: Unused(),
        });
    };
}

cart!(Shaken, 0.5_m * sin(2.0_rad_per_s * (t - start)));
cart!(Pushed, 2.5_m_per_s2 * later * later);

macro_rules! follows_at_large_times {
    ($cart:ident) => {
        for accuracy in [1e-5, 1e-6, 1e-7] {
            for settings in [
                Settings::accuracy(accuracy),
                Settings::for_tolerance(0.2 * accuracy),
            ] {
                let [early, million, ten_millions] = [0.0, 1e6, 1e7].map(|start| {
                    let cart = Simulation::new($cart { start: 0.0 }).unwrap();
                    let mut state = cart.state().clone();
                    state.time = start;
                    let cart = $cart { start };
                    let mut cart =
                        Simulation::resume_with_methods(cart, settings, state, methods::Accuracy)
                            .unwrap();
                    cart.run_until(start + 3.0).unwrap();
                    (cart.outputs().swing, cart.report().stages)
                });
                for (swing, stages) in [million, ten_millions] {
                    let error = (swing - early.0).abs();
                    assert!(error < accuracy, "{accuracy}: {error:e}");
                    assert!(stages < 2 * early.1, "{accuracy}: {stages}, {early:?}");
                }
            }
        }
    };
}

/// The program of a drive is followed at the instants that the clock shows. Runs ended with `Tolerance`, or took fifty times as many
/// stages.
#[test]
fn drives_are_followed_at_large_times() {
    follows_at_large_times!(Shaken);
    follows_at_large_times!(Pushed);
}

/// The shortest steps that the clock counts are not short for the first step.
#[test]
fn a_drive_sets_out_next_to_the_clock() {
    for (start, accuracy) in [(7.7e6, 1e-7), (1.1e7, 3e-7)] {
        let mut state = Simulation::new(Pushed { start: 0.0 })
            .unwrap()
            .state()
            .clone();
        state.time = start;
        let settings = Settings::accuracy(accuracy);
        let cart = Pushed { start };
        let mut cart =
            Simulation::resume_with_methods(cart, settings, state, methods::Accuracy).unwrap();
        cart.run_until(start + 3.0).unwrap();
        assert!((cart.outputs().swing + 1.88444).abs() < 1e-5);
    }
}

mechanism!(Thrown {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    ball: Particle(
        mass = 0.2_kg,
        at = [0.0_m, 0.0_m],
        velocity = [0.0_m_per_s, 4.905]
    ),
    touch: Event(ball.origin.y),
});

/// A step from exactly 0 that is as long as the flight was skipped, as one that leaves 0.
#[test]
fn an_event_that_begins_at_0_is_found_in_a_long_step() {
    for accuracy in [1e-1, 1e-3, 1e-6, 1e-9] {
        let thrown = Simulation::with_accuracy(Thrown::default(), accuracy);
        let mut thrown = thrown.expect("it assembles");
        let found = thrown.run_to_event("touch", 10.0).expect("it runs");
        let time = found.expect("it falls");
        assert!((time - 1.0).abs() < 1e-9, "{accuracy}: {time}");
        assert_eq!(thrown.run_to_event("touch", 3.0).expect("it runs"), None);
    }
    for step in [0.01, 0.3, 1.3] {
        let settings = Settings {
            step,
            ..Settings::default()
        };
        let thrown = Simulation::with_settings(Thrown::default(), settings);
        let mut thrown = thrown.expect("it assembles");
        let found = thrown.run_to_event("touch", 10.0).expect("it runs");
        let time = found.expect("it falls");
        assert!((time - 1.0).abs() < 1e-9, "{step}: {time}");
    }
}

/// The search ended at a millionth of a millionth of the time, which is a step at the time of a Unix clock.
#[test]
fn events_at_large_times_are_found_to_the_round_off_of_the_clock() {
    let begin = Simulation::new(Thrown::default()).expect("it assembles");
    for start in [1e8, 1.7e9, 5e9] {
        let mut state = begin.state().clone();
        state.time = start;
        let thrown = Simulation::resume(Thrown::default(), Settings::default(), state);
        let mut thrown = thrown.expect("the state");
        let found = thrown.run_to_event("touch", start + 2.0).expect("it runs");
        let late = found.expect("it falls") - start - 1.0;
        assert!(late.abs() <= 8.0 * f64::EPSILON * start, "{start}: {late}");
    }
}

mechanism!(SlowStart {
    world: Planar(),
    ball: Particle(mass = 1.0_kg, at = [0.0_m, 0.0_m]),
    push: Force(on = ball.origin, value = [1.0_N_per_s * t * t / 1.0_s, 0.0]),
    sets_out: Event(ball.origin.x),
});

/// The cubic of a step leaves 0 with the wrong sign where the motion does as t⁴.
#[test]
fn what_leaves_0_slowly_is_no_event() {
    for accuracy in [1e-1, 1e-3, 1e-6, 1e-9] {
        let pushed = Simulation::with_accuracy(SlowStart::default(), accuracy);
        let mut pushed = pushed.expect("it assembles");
        let found = pushed.run_to_event("sets_out", 3.0).expect("it runs");
        assert_eq!(found, None, "{accuracy}");
        assert!((pushed.positions()[0] - 81.0 / 12.0).abs() < accuracy.max(1e-8) * 10.0);
    }
    for (order, step) in [(2, 0.1), (4, 0.5), (8, 1.0)] {
        let settings = Settings {
            order,
            step,
            ..Settings::default()
        };
        let pushed = Simulation::with_settings(SlowStart::default(), settings);
        let mut pushed = pushed.expect("it assembles");
        let found = pushed.run_to_event("sets_out", 3.0).expect("it runs");
        assert_eq!(found, None, "{order}");
    }
}
