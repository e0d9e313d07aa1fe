//! Steps that are too long for a motion end right, or with an error by name; never with nonsense and `Ok`.

use mbs_runtime::{Flow, Mechanism, Settings, Simulation, SimulationError, System, mechanism};

mechanism!(Pendulum {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    rod: Bar(mass = 1.0_kg, length = 1.0_m, angle = 0.0_deg),
    pivot: Revolute(ground.origin, rod.a),
});

mechanism!(NaturalPendulum {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Natural),
    rod: Bar(mass = 1.0_kg, length = 1.0_m, angle = 0.0_deg),
    pivot: Revolute(ground.origin, rod.a),
});

mechanism!(Bob {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    stiffness: Param(2e10_N_per_m),
    stretch: Param(1e-4_m),
    bob: Particle(mass = 1.0_kg, at = [1.0_m + stretch, 0.0]),
    spring: SpringDamper(
        ground.origin,
        bob.origin,
        stiffness = stiffness,
        length = 1.0_m
    ),
});

/// The largest energy error of a run, as a multiple of the largest kinetic energy it can have.
fn run<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: M,
    settings: Settings,
    until: f64,
    energy: f64,
) where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let mut simulation = Simulation::with_settings(mechanism, settings).unwrap();
    let what = format!("{} {:?}", S::MODEL.name, settings.step);
    let end = simulation.run_until(until);
    let error = simulation.energy().error;
    println!("{what} {:?}: {error:e} J, {end:?}", simulation.flow());
    match end {
        Ok(()) => assert!(error.abs() < 0.6 * energy, "{what}: {error:e} J"),
        Err(SimulationError::EnergyGain {
            time,
            gained,
            available,
            ..
        }) => {
            assert!(time <= until && gained > 0.2 * available, "{what}");
        }
        Err(SimulationError::EnergyLoss {
            time,
            lost,
            available,
            ..
        }) => {
            assert!(time <= until && lost > 0.2 * available, "{what}");
        }
        Err(SimulationError::NotConverged { .. } | SimulationError::NonFinite { .. }) => {}
        Err(error) => panic!("{what}: {error}"),
    }
}

fn settings(step: f64, order: u8) -> Settings {
    Settings {
        step,
        order,
        ..Settings::default()
    }
}

#[test]
fn pendulums_in_long_steps() {
    for order in [2, 4, 6, 8] {
        for step in [0.1, 0.3, 0.5, 1.0, 5.0, 20.0] {
            run(Pendulum::default(), settings(step, order), 150.0, 20.0);
            run(
                NaturalPendulum::default(),
                settings(step, order),
                150.0,
                20.0,
            );
        }
    }
}

#[test]
fn stiff_springs() {
    for stiffness in [1e6, 1e8, 2e10, 1e12, 1e14] {
        for stretch in [0.0, 1e-4, 0.5] {
            let energy = 20.0 + 0.5 * stiffness * stretch * stretch;
            for (step, flow) in [(1e-3, None), (1e-3, Some(Flow::Implicit)), (1e-2, None)] {
                let bob = Bob { stiffness, stretch };
                let settings = Settings {
                    flow,
                    ..settings(step, 2)
                };
                run(bob, settings, 3.0, energy);
            }
        }
    }
}

/// The spring vibrates some times in a step and gives its energy to the pendulum, or takes it away: with `Ok` a run
/// ended with 1.5e8 times its energy, another with a tenth. What the message advises helps.
#[test]
fn steps_longer_than_a_vibration_are_refused() {
    let end = |stiffness, stretch, settings: Settings, until| {
        let bob = Bob { stiffness, stretch };
        let mut simulation = Simulation::with_settings(bob, settings).unwrap();
        let end = simulation.run_until(until);
        (end, simulation.energy().error)
    };
    let (gain, _) = end(2e10, 1e-4, settings(1e-3, 2), 3.0);
    assert!(
        matches!(gain, Err(SimulationError::EnergyGain { .. })),
        "{gain:?}"
    );
    for (stiffness, step) in [(2e10, 1e-3), (1e8, 1e-3), (1e8, 1e-2), (1e6, 1e-2)] {
        let (loss, _) = end(stiffness, 0.5, settings(step, 2), 3.0);
        assert!(
            matches!(loss, Err(SimulationError::EnergyLoss { .. })),
            "{loss:?}"
        );
    }
    let tolerant = Settings {
        tolerance: Some(1e-3),
        ..settings(1e-2, 2)
    };
    for better in [settings(1e-4, 2), tolerant] {
        let (end, error) = end(1e6, 0.5, better, 0.3);
        assert_eq!(end, Ok(()));
        assert!(error.abs() < 1e-2 * 1.25e5, "{error} J");
    }
}

/// A tolerance chooses steps that are short enough, also from a first step that is too long.
#[test]
fn a_tolerance_recovers_from_a_long_first_step() {
    let settings = Settings {
        step: 5.0,
        tolerance: Some(1e-4),
        ..settings(5.0, 6)
    };
    let mut simulation = Simulation::with_settings(NaturalPendulum::default(), settings).unwrap();
    simulation.run_until(10.0).unwrap();
    assert!(simulation.energy().error.abs() < 1e-2);
}

mechanism!(PushedBob {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    stiffness: Param(2e10_N_per_m),
    stretch: Param(1e-4_m),
    push: Input(0.1_N),
    bob: Particle(mass = 1.0_kg, at = [1.0_m + stretch, 0.0]),
    spring: SpringDamper(
        ground.origin,
        bob.origin,
        stiffness = stiffness,
        length = 1.0_m
    ),
    thrust: Force(bob.origin, value = [push, 0.0]),
});

/// The same where a force does work: until ten times the energy of the motion was gained, nothing was said.
#[test]
fn pushed_motions_are_refused_too() {
    for (stiffness, stretch, step) in [
        (2e10, 0.5, 1e-3),
        (1e8, 0.5, 1e-3),
        (1e6, 0.5, 1e-2),
        // The energy of the spring at the start was counted twice.
        (2e10, 1e-4, 1e-3),
    ] {
        let bob = PushedBob { stiffness, stretch };
        let mut simulation = Simulation::with_settings(bob, settings(step, 2)).unwrap();
        let end = simulation.run_until(3.0);
        println!("{stiffness:e} {stretch:e} {step:e}: {end:?}");
        assert!(
            matches!(
                end,
                Err(SimulationError::EnergyGain { .. } | SimulationError::EnergyLoss { .. })
            ),
            "{stiffness:e}: {end:?}"
        );
    }
}

/// The works of forces that push a vibration back and forth have errors that cancel each other. Their sum without signs
/// grew until nothing was refused: a run ended with `Ok` and fifteen times the energy of its spring.
#[test]
fn pushed_vibrations_are_refused_however_long() {
    let (stiffness, stretch) = (1e8, 1e-4);
    let bob = PushedBob { stiffness, stretch };
    let mut simulation = Simulation::with_settings(bob, settings(1e-2, 2)).unwrap();
    simulation.set_input("push", 10.0).unwrap();
    let end = simulation.run_until(10.0);
    assert!(
        matches!(end, Err(SimulationError::EnergyGain { time, .. }) if time < 0.2),
        "{end:?}"
    );
}

mechanism!(Braked {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    damping: Param(1.0_N_s_per_m),
    rod: Bar(mass = 1.0_kg, length = 1.0_m, angle = 0.0_deg),
    bob: Particle(mass = 1.0_kg, at = [1.5_m, 0.5]),
    pivot: Revolute(ground.origin, rod.a),
    link: SpringDamper(
        rod.b,
        bob.origin,
        stiffness = 0.0,
        damping = damping,
        length = 0.5_m
    ),
    brake: SpringDamper(
        ground.point(0.0, -2.0_m),
        rod.b,
        stiffness = 0.0,
        damping = damping,
        length = 0.5_m
    ),
});

/// A damper that stops a part within a step takes another work than the trapezoidal rule says; the motion is right.
#[test]
fn stiff_dampers_are_not_refused() {
    for damping in [1.0, 1e2, 1e4, 1e6, 1e8] {
        for step in [1e-3, 1e-2, 5e-2] {
            let mut simulation =
                Simulation::with_settings(Braked { damping }, settings(step, 2)).unwrap();
            let end = simulation.run_until(2.0);
            println!("{damping:e} {step:e}: {:?}", simulation.energy());
            assert_eq!(end, Ok(()), "{damping:e} {step:e}");
        }
    }
}

/// The shorter steps that take the place of one that leaps over a turn were all that was taken of it: the clock of a control loop
/// fell behind.
#[test]
fn steps_without_placement_have_their_length() {
    for order in [2, 4, 6] {
        for step in [0.05, 0.1, 0.2, 0.3, 0.5, 1.0] {
            let settings = Settings {
                placement: false,
                ..settings(step, order)
            };
            let mut pendulum =
                Simulation::with_settings(NaturalPendulum::default(), settings).unwrap();
            for _ in 0..200 {
                let before = pendulum.time();
                pendulum.step().unwrap();
                let passed = pendulum.time() - before;
                assert!((passed - step).abs() < 1e-12, "{order} {step}: {passed}");
            }
        }
    }
}

/// The state was that after the refused step.
#[test]
fn a_step_that_fails_moves_nothing() {
    let bob = Bob {
        stiffness: 2e10,
        stretch: 1e-4,
    };
    for placement in [true, false] {
        let settings = Settings {
            placement,
            ..settings(1e-3, 2)
        };
        let mut bob = Simulation::with_settings(bob, settings).unwrap();
        loop {
            let (before, report) = (bob.state().clone(), bob.report());
            let Err(error) = bob.step() else {
                continue;
            };
            assert!(
                matches!(error, SimulationError::EnergyGain { .. }),
                "{error}"
            );
            let now = bob.state();
            assert_eq!((now.time, now.clock), (before.time, before.clock));
            assert_eq!(
                (now.positions, now.velocities),
                (before.positions, before.velocities)
            );
            assert_eq!(now.ledger, before.ledger);
            assert_eq!(now.poses_ahead, before.poses_ahead);
            let again = bob.step().unwrap_err();
            assert_eq!(again, error);
            assert_eq!(bob.report().steps, report.steps);
            break;
        }
    }
}

mechanism!(Cart {
    world: Planar(),
    push: Input(unit = N),
    cart: Particle(mass = 1.0_kg, at = [1.0_m, 0.0_m]),
    spring: SpringDamper(
        ground.origin,
        cart.origin,
        stiffness = 400.0_N_per_m,
        damping = 2.0_N_s_per_m,
        length = 1.0_m
    ),
    force: Force(on = cart.origin, value = [push, 0.0]),
});

/// What the motion has had goes with its state: a step that is accepted is accepted after resuming, too. (Of 200 such steps 71 were
/// refused.)
#[test]
fn a_resumed_motion_is_judged_by_all_that_it_had() {
    for step in [1e-2, 2e-2] {
        let settings = settings(step, 2);
        let mut simulation = Simulation::with_settings(Cart::default(), settings).unwrap();
        for number in 0..200 {
            let push = if number / 17 % 2 == 0 { 300.0 } else { -300.0 };
            simulation.set_input("push", push).unwrap();
            let state = simulation.state().clone();
            let mut resumed = Simulation::resume(Cart::default(), settings, state).unwrap();
            let outcomes = [simulation.step(), resumed.step()];
            assert_eq!(outcomes[0], outcomes[1], "step {number} of {step} s");
            assert_eq!(simulation.state(), resumed.state());
        }
    }
}

mechanism!(Relay {
    world: Planar(),
    push: Input(unit = N),
    cart: Particle(mass = 2.0_kg, at = [1.0_m, 0.0]),
    rail: PointOnLine(cart.origin, ground.origin, axis = X),
    motor: Force(
        on = cart.origin,
        value = [push - 4.0_N_s_per_m * cart.velocity.x, 0.0_N]
    ),
    place: Output(cart.origin.x),
    speed: Output(cart.velocity.x),
});

/// A relay that switches for ever: its works cancel, the errors of their sum do not.
#[test]
fn a_controller_may_switch_for_ever() {
    let settings = Settings {
        step: 0.01,
        placement: false,
        ..Settings::default()
    };
    let mut simulation = Simulation::with_settings(Relay::default(), settings).unwrap();
    let mut farthest: f64 = 0.0;
    for _ in 0..90_000 {
        let values = simulation.outputs();
        let (place, speed) = (values.place, values.speed);
        farthest = farthest.max(place.abs());
        let wanted = if place + 0.05 * speed > 0.0 {
            -10.0
        } else {
            10.0
        };
        simulation.inputs_mut().push = wanted;
        simulation.step().unwrap();
    }
    assert!(farthest < 1.1, "{farthest} m");
}

mechanism!(Pulled {
    world: Planar(),
    hand: Input(0.0_m),
    block: Particle(mass = 1.0_kg, at = [0.0_m, 0.0]),
    guide: PointOnLine(block, ground.origin, axis = X),
    pull: Force(
        on = block,
        value = [
            200.0_N_per_m * (hand - block.origin.x) - 5.0_N_s_per_m * block.velocity.x,
            0.0_N
        ]
    ),
    x: Output(block.origin.x),
});

/// Each jump gives a work with an error of the same sign.
#[test]
fn an_input_may_jump_for_ever() {
    let settings = Settings {
        step: 1.0 / 60.0,
        ..Settings::default()
    };
    let mut simulation = Simulation::with_settings(Pulled::default(), settings).unwrap();
    for jump in 1..=1000 {
        simulation.inputs_mut().hand = if jump % 2 == 0 { 1.0 } else { -1.0 };
        simulation.run_until(0.5 * f64::from(jump)).unwrap();
        assert!(simulation.outputs().x.abs() < 2.1);
    }
}

mechanism!(Press {
    world: Planar(),
    speed: Input(0.1_m_per_s),
    since: Input(0.0_s),
    crank: Bar(mass = 1.0_kg, length = 0.1_m, angle = 40.0_deg),
    rod: Bar(mass = 1.0_kg, length = 0.3_m, angle = -12.0_deg),
    piston: Particle(mass = 1.0_kg),
    main: Revolute(ground.origin, crank.a),
    big: Revolute(crank.b, rod.a),
    small: Revolute(rod.b, piston),
    bore: PointOnLine(piston, ground.origin, axis = X),
    drive: Drive(piston.origin.x, value = 0.35_m, rate = speed, since = since),
});

/// Its rates grow without bound towards the pose in which crank and rod are stretched. The message blamed long steps and a spring.
#[test]
fn a_drive_that_goes_too_far_is_named_with_an_accuracy() {
    for accuracy in [1e-3, 1e-6, 1e-9] {
        let mut press = Simulation::with_accuracy(Press::default(), accuracy).unwrap();
        let error = press.run_until(2.0).expect_err("0.4 m is the end");
        assert!((press.time() - 0.5).abs() < 1e-4, "{}", press.time());
        let text = error.to_string();
        println!("{accuracy:e}: {text}");
        assert!(
            text.contains(
                "look for a pose that the mechanism cannot pass, as where a drive goes too far"
            ),
            "{text}"
        );
        assert!(!text.contains("or a tolerance"), "{text}");
    }
}
