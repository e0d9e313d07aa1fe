//! The promises around the step: no allocation, resuming bit for bit, events, landing times, errors.

use crate::common::alloc::count;
use crate::common::planar::{FourBar, SliderCrank};
use crate::common::scenes::*;
use crate::common::{Hand, Parameters, Scene};
use mbs_runtime::nalgebra::SVector;
use mbs_runtime::{
    AnySimulation, Flow, Mechanism, Method, PaperSettings, PaperStepper, Settings, Simulation,
    SimulationError, State, TwoLevelStepper,
};

fn new<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    settings: Settings,
) -> Result<Simulation<Hand<T, Q, N, R>, Q, N, R>, SimulationError> {
    Simulation::with_any_method(Parameters(scene), settings)
}

fn allocations<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    settings: Settings,
) -> u64 {
    let mut simulation = new(scene, settings).unwrap();
    simulation.step().unwrap();
    let before = count();
    for _ in 0..200 {
        simulation.step().unwrap();
    }
    count() - before
}

#[test]
fn steps_do_not_allocate() {
    let kept = Box::new(count());
    assert!(count() > *kept, "the allocator does not count");
    let settings = Settings::default();
    assert_eq!(allocations(FourBar, settings), 0);
    assert_eq!(allocations(SliderCrankAngles, settings), 0);
    assert_eq!(allocations(StiffPendulum::default(), settings), 0);
    assert_eq!(allocations(Towing, settings), 0);
    assert_eq!(allocations(DampedSleigh::default(), settings), 0);
    let paper = Settings {
        method: Method::Paper(PaperSettings::default()),
        ..settings
    };
    assert_eq!(allocations(SliderCrank, paper), 0);
}

/// A singular pose goes through the regularised solves: these do not allocate either.
#[test]
fn singular_passages_do_not_allocate() {
    let system = Parameters(FourBar).prepare().unwrap();
    let (q, v) = FourBar.guess();
    let settings = Settings::default();
    let state = State::new(0.0, q.into(), v.into());
    let mut stepper = TwoLevelStepper::new(system, state, &settings).unwrap();
    let before = count();
    for _ in 0..2000 {
        stepper.step(1e-3).unwrap();
    }
    assert_eq!(count() - before, 0);
}

fn resumes<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    settings: Settings,
) {
    let mut whole = new(scene.clone(), settings).unwrap();
    whole.run_until(0.1).unwrap();
    let state = whole.state().clone();
    whole.run_until(0.2).unwrap();
    let mut resumed =
        Simulation::resume_with_any_method(Parameters(scene), settings, state).unwrap();
    resumed.run_until(0.2).unwrap();
    assert_eq!(whole.state(), resumed.state());
    assert_eq!(whole.energy(), resumed.energy());
}

#[test]
fn resuming_continues_bit_for_bit() {
    let settings = Settings::default();
    resumes(SliderCrank, settings);
    resumes(SliderCrankAngles, settings);
    resumes(StiffPendulum::default(), settings);
    resumes(Towing, settings);
    resumes(Shaken, settings);
    for carried_fields in [true, false] {
        // A state is resumed if it satisfies the rows.
        let paper = PaperSettings {
            velocity_tolerance: 1e-6,
            residual_tolerance: 1e-6,
            carried_fields,
            ..PaperSettings::default()
        };
        resumes(
            SliderCrank,
            Settings {
                method: Method::Paper(paper),
                ..settings
            },
        );
    }
}

#[test]
fn runs_land_exactly() {
    let mut simulation = new(
        FourBar,
        Settings {
            step: 7e-4,
            ..Settings::default()
        },
    )
    .unwrap();
    simulation.run_until(0.1).unwrap();
    assert_eq!(simulation.time(), 0.1);
    assert_eq!(simulation.report().steps, 143);
    let times: Vec<f64> = simulation
        .samples(0.2, 0.03)
        .map(|sample| sample.unwrap().time)
        .collect();
    assert_eq!(times.len(), 4);
    assert!((times[3] - 0.19).abs() < 1e-12 && simulation.time() == times[3]);
    // An interval of which a multiple is past the end by round-off ends there.
    let interval = 0.01 * (1.0 + 1e-8);
    let samples = simulation.samples(0.22, interval).map(Result::unwrap);
    assert_eq!((samples.count(), simulation.time()), (4, 0.22));
    // Thirty steps of 1e-3 are thirty steps, whatever their sum rounds to.
    let mut simulation = new(FourBar, Settings::default()).unwrap();
    simulation.run_until(0.03).unwrap();
    assert_eq!(simulation.report().steps, 30);
}

#[test]
fn events_are_located() {
    let mut simulation = new(SliderCrank, Settings::default()).unwrap();
    let first = simulation
        .run_to_event("crank_upright", 5.0)
        .unwrap()
        .unwrap();
    assert!((0.38..0.40).contains(&first), "{first}");
    assert_eq!(simulation.time(), first);
    assert!(
        simulation.positions()[0].abs() < 1e-10,
        "{:?}",
        simulation.positions()
    );
    let second = simulation
        .run_to_event("crank_upright", 5.0)
        .unwrap()
        .unwrap();
    assert!(second > first + 0.1, "{first} {second}");
    assert_eq!(
        simulation
            .run_to_event("crank_upright", second + 1e-3)
            .unwrap(),
        None
    );
    assert_eq!(simulation.time(), second + 1e-3);
    let error = simulation
        .run_to_event("upright", 9.0)
        .unwrap_err()
        .to_string();
    assert_eq!(
        error,
        "no event is named `upright`; there are: crank_upright"
    );
}

#[test]
fn wrong_settings_are_refused() {
    for step in [0.0, -1e-3, f64::NAN, f64::INFINITY] {
        let error = new(
            FourBar,
            Settings {
                step,
                ..Settings::default()
            },
        )
        .err()
        .unwrap();
        assert!(
            error.to_string().starts_with("setting `step` is"),
            "{error}"
        );
    }
    let step = 1e-300;
    let error = new(
        FourBar,
        Settings {
            step,
            ..Settings::default()
        },
    )
    .err()
    .unwrap();
    assert_eq!(
        error.to_string(),
        "setting `step` is 1e-300; give it a value from 1e-100 to 1e100"
    );
    let paper = PaperSettings {
        penalty_growth: 1.0,
        ..PaperSettings::default()
    };
    let method = Method::Paper(paper);
    let error = new(
        FourBar,
        Settings {
            method,
            ..Settings::default()
        },
    )
    .err()
    .unwrap();
    assert_eq!(
        error.to_string(),
        "setting `penalty_growth` is 1; give it a finite value above 1"
    );
    let flow = Some(Flow::Leapfrog);
    let error = new(
        SliderCrankAngles,
        Settings {
            flow,
            ..Settings::default()
        },
    )
    .err()
    .unwrap();
    assert_eq!(
        error.to_string(),
        "the leapfrog flow cannot be used here: the mass matrix depends on the positions; use midpoint, or leave the choice to the runtime"
    );
}

#[test]
fn wrong_times_are_refused() {
    let mut simulation = new(FourBar, Settings::default()).unwrap();
    simulation.run_until(0.1).unwrap();
    for time in [0.05, f64::NAN, f64::INFINITY] {
        assert!(matches!(
            simulation.run_until(time),
            Err(SimulationError::Time { .. })
        ));
        assert!(simulation.samples(time, 0.1).next().unwrap().is_err());
    }
    for interval in [0.0, -1.0, f64::NAN] {
        assert!(simulation.samples(1.0, interval).next().unwrap().is_err());
    }
    assert_eq!(simulation.time(), 0.1);
}

#[test]
fn contradicting_rows_are_named() {
    let error = new(Contradiction, Settings::default()).err().unwrap();
    let SimulationError::Assembly(verdict) = &error else {
        panic!("{error}")
    };
    assert_eq!(verdict.rank, 1);
    assert_eq!(verdict.redundant_rows, ["far"]);
    let text = error.to_string();
    assert!(text.contains("`near` (residual 5.000e-1 m)"), "{text}");
    assert!(text.contains("`far` (residual -5.000e-1 m)"), "{text}");
}

#[test]
fn states_that_cannot_be_resumed_are_refused() {
    let (q, v) = FourBar.guess();
    let resume = |state| Simulation::resume(Parameters(FourBar), Settings::default(), state);
    let (q, v) = (SVector::from(q), SVector::from(v));
    assert!(resume(State::new(0.0, q, v)).is_ok());
    let error = resume(State::new(0.0, 1.01 * q, v))
        .err()
        .unwrap()
        .to_string();
    assert!(
        error.starts_with("cannot resume from this state: the row `crank"),
        "{error}"
    );
    let error = resume(State::new(0.0, q, v.add_scalar(1.0)))
        .err()
        .unwrap()
        .to_string();
    assert!(
        error.starts_with("cannot resume from this state: the row `crank"),
        "{error}"
    );
    let error = resume(State::new(f64::NAN, q, v))
        .err()
        .unwrap()
        .to_string();
    assert!(
        error.starts_with("cannot resume from this state: time is NaN"),
        "{error}"
    );
    let error = resume(State::new(0.0, SVector::repeat(f64::NAN), v))
        .err()
        .unwrap()
        .to_string();
    assert!(
        error.starts_with("cannot resume from this state: a coordinate is NaN"),
        "{error}"
    );
}

#[test]
fn an_assembled_guess_is_left_as_it_is() {
    let simulation = new(FourBar, Settings::default()).unwrap();
    let (q, v) = FourBar.guess();
    assert_eq!(simulation.positions(), &SVector::from(q));
    assert_eq!(simulation.velocities(), &SVector::from(v));
    assert_eq!(simulation.assembly().moved, 0.0);
    assert_eq!(
        (simulation.assembly().rank, simulation.report().rank),
        (5, 5)
    );
}

#[test]
fn steppers_work_alone_and_simulations_behind_a_face() {
    let (q, v) = SliderCrank.guess();
    let system = Parameters(SliderCrank).prepare().unwrap();
    let settings = Settings::default();
    let state = State::new(0.0, q.into(), v.into());
    let algorithm_1 = Settings {
        method: Method::Paper(PaperSettings::default()),
        ..settings
    };
    let mut paper = PaperStepper::new(system, state, &algorithm_1).unwrap();
    paper.step(1e-3).unwrap();
    assert_eq!(paper.state().time, 1e-3);
    let mut any: Box<dyn AnySimulation> = Box::new(new(FourBar, settings).unwrap());
    any.run_until(0.01).unwrap();
    assert_eq!((any.coordinates().len(), any.sample().time), (6, 0.01));
    assert!(
        any.set_input("torque", 1.0)
            .unwrap_err()
            .to_string()
            .contains("has none")
    );
}
