//! Time: steps are counted exactly, the clock never runs back, and what is not a number is refused by name.

use mbs_runtime::{Method, Settings, Simulation, SimulationError, mechanism};

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
