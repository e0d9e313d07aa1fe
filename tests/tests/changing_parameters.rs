//! Parameters that change during a run.

use mbs_runtime::{Ledger, Method, Settings, Simulation, SimulationError, mechanism};

mechanism!(Bob {
    doc: "A mass on a spring whose stiffness, force and mass change.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    push: Input(0.0_N),
    mass: Param(0.8_kg),
    force: Param([-6.0_N, 0.0_N, 8.0_N]),
    line: Table([-0.1_m, 0.0_m, 0.1_m], force),
    bob: Particle(mass = mass, at = [0.3_m, -0.9_m]),
    spring: SpringDamper(ground.origin, bob.origin, law = line, length = 0.7_m),
    wind: Force(bob.origin, value = [push, 0.0]),
    place: Output(bob.origin),
});

/// Settings with steps whose energy errors are small beside what changes.
fn fine() -> Settings {
    Settings {
        step: 1e-4,
        ..Settings::default()
    }
}

/// The motion is the one from the same state with the new parameters; only the books know more.
#[test]
fn the_motion_goes_on_with_the_new_parameters() {
    let mut simulation = Simulation::with_settings(Bob::default(), fine()).expect("it assembles");
    simulation.set_input("push", 1.5).expect("an input");
    simulation.run_until(0.5).expect("it runs");
    let before = simulation.energy();
    let steps = simulation.report().steps;
    let heavy = Bob {
        mass: 1.3,
        force: [-90.0, 0.0, 90.0],
    };
    // A balance that begins here.
    let mut state = simulation.state().clone();
    state.ledger = Ledger::default();
    let mut resumed = Simulation::resume(heavy, fine(), state).expect("the state");
    resumed.set_input("push", 1.5).expect("an input");

    let verdict = simulation.set_parameters(heavy).expect("a mechanism");
    assert_eq!((verdict.moved, verdict.changes.len()), (0.0, 0));
    assert_eq!(simulation.inputs().push, 1.5);
    let after = simulation.energy();
    let gain = after.kinetic + after.potential - before.kinetic - before.potential;
    assert!(gain.abs() > 0.1, "{gain}");
    let booked = after.nonconservative_work - before.nonconservative_work;
    assert!((booked - gain).abs() < 1e-14, "{booked}, {gain}");

    simulation.run_until(2.0).expect("it runs");
    resumed.run_until(2.0).expect("it runs");
    assert_eq!(simulation.outputs().place, resumed.outputs().place);
    assert_eq!(simulation.report().steps, steps + resumed.report().steps);
    // Measured: 1.5e-5 J.
    assert!(
        simulation.energy().error.abs() < 5e-5,
        "{:?}",
        simulation.energy()
    );
}

mechanism!(Crane {
    doc: "A slider-crank with a rod of variable length.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    length: Param(2.0_m),
    crank: Bar(
        mass = 1.0_kg,
        length = 0.6_m,
        angle = 0.7,
        rate = 2.0_rad_per_s
    ),
    rod: Bar(mass = 1.0_kg, length = length, angle = -0.8),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.point(0.0_m, -1.0_m), axis = X),
    slider: Output(rod.b.x),
    pin_at: Output(crank.b),
});

/// A rod that is longer at once: the verdict says what has moved, the rows hold, and the balance goes on.
#[test]
fn a_length_that_changes_moves_the_mechanism() {
    let mut simulation = Simulation::with_settings(Crane::default(), fine()).expect("it assembles");
    simulation.run_until(0.3).expect("it runs");
    let error = simulation.energy().error;
    let verdict = simulation
        .set_parameters(Crane { length: 2.05 })
        .expect("it closes");
    assert!(verdict.residual_before > 1e-2 && verdict.residual < 1e-12);
    assert!(verdict.moved > 1e-3 && !verdict.changes.is_empty());
    assert_eq!(simulation.assembly(), &verdict);
    let outputs = simulation.outputs();
    let length = (outputs.slider - outputs.pin_at.x).hypot(outputs.pin_at.y + 1.0);
    assert!((length - 2.05).abs() < 1e-12, "{length}");
    assert!((simulation.energy().error - error).abs() < 1e-13);
    simulation.run_until(1.0).expect("it runs");
    assert!(simulation.report().velocity_error < 1e-12);
    // Measured: 4.1e-7 J.
    assert!(
        simulation.energy().error.abs() < 2e-6,
        "{:?}",
        simulation.energy()
    );
}

/// What is refused changes nothing, to the last bit.
#[test]
fn what_is_refused_changes_nothing() {
    let mut simulation = Simulation::new(Crane::default()).expect("it assembles");
    simulation.run_until(0.3).expect("it runs");
    let mut other = simulation.clone();
    let short = other.set_parameters(Crane { length: 0.1 });
    assert!(
        matches!(&short, Err(SimulationError::NoPose { .. })),
        "{short:?}"
    );
    let text = short.expect_err("it is refused").to_string();
    assert!(
        text.starts_with("no pose near the present one fits these parameters; these rows pull"),
        "{text}"
    );
    let negative = other.set_parameters(Crane { length: -1.0 });
    assert!(
        matches!(negative, Err(SimulationError::Parameter(_))),
        "{negative:?}"
    );
    let none = other.set_parameters(Crane { length: f64::NAN });
    assert!(
        matches!(none, Err(SimulationError::Parameter(_))),
        "{none:?}"
    );
    simulation.run_until(1.0).expect("it runs");
    other.run_until(1.0).expect("it runs");
    assert_eq!(simulation.state(), other.state());
}

/// Methods beside the two-level one, with and without a memory.
#[test]
fn any_method_goes_on() {
    for name in ["projected", "rattle", "generalized-alpha", "bdf"] {
        let settings = Settings {
            method: Method::by_name(name).expect("its name"),
            ..Settings::default()
        };
        let mut simulation =
            Simulation::with_any_method(Crane::default(), settings).expect("it assembles");
        simulation.run_until(0.3).expect("it runs");
        simulation
            .set_parameters(Crane { length: 2.05 })
            .expect("it closes");
        simulation.run_until(0.6).expect("it runs");
        // Measured: at most 1.1e-5 J.
        assert!(simulation.energy().error.abs() < 5e-5, "{name}");
    }
}
