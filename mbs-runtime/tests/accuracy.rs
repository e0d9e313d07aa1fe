//! An accuracy instead of a method: what is chosen, its error, and what is refused.

use crate::common::planar::SliderCrank;
use crate::common::spatial::Sprung;
use crate::common::{Hand, Parameters, Scene, distance};
use crate::composition::{run, settings};
use mbs_runtime::{Method, Settings, Simulation, SimulationError, methods};

type Run<T, const Q: usize, const N: usize, const R: usize> = Simulation<Hand<T, Q, N, R>, Q, N, R>;

fn with_accuracy<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    accuracy: f64,
) -> Run<T, Q, N, R> {
    Simulation::with_accuracy(Parameters(scene), accuracy).unwrap()
}

#[test]
fn a_few_rows_take_the_explicit_method() {
    let simulation = with_accuracy(SliderCrank, 1e-6);
    assert_eq!(simulation.settings().method, Method::Projected);
    assert_eq!(simulation.time(), 0.0);
    assert_eq!(simulation.report().steps, 0);
}

/// Rounded once, so that it is printed with one digit.
#[test]
fn the_tolerance_is_a_fifth_of_the_accuracy() {
    let tolerance = |accuracy| with_accuracy(SliderCrank, accuracy).settings().tolerance;
    assert_eq!(tolerance(1e-9), Some(2e-10));
    assert_eq!(tolerance(1e-6), Some(2e-7));
}

#[test]
fn stiff_dampers_take_collocation() {
    let stiff = || Sprung::<true> {
        damping: 1e5,
        ..Sprung::default()
    };
    let exact = run(stiff(), settings(8, 2e-4), 0.5);
    for accuracy in [1e-4, 1e-6, 1e-8] {
        let mut simulation = with_accuracy(stiff(), accuracy);
        assert_eq!(simulation.settings().method, Method::Radau);
        simulation.run_until(0.5).unwrap();
        let error = distance(simulation.positions(), exact.positions());
        println!("{accuracy:e}: {error:.1e}, {:?}", simulation.report());
        assert!(error < 3.0 * accuracy, "{accuracy:e}: {error:e}");
    }
}

/// Each is compiled by its name; those that an accuracy has beside the two-level one are there together.
#[test]
fn candidates_that_are_not_compiled_are_left_out() {
    let stiff = Sprung::<true> {
        damping: 1e5,
        ..Sprung::default()
    };
    let settings = Settings::accuracy(1e-4);
    let simulation =
        Simulation::with_methods(Parameters(stiff), settings, methods::Projected).unwrap();
    assert_eq!(simulation.settings().method, Method::TwoLevel);
}

#[test]
fn without_other_methods_it_is_the_two_level_one() {
    let simulation =
        Simulation::with_settings(Parameters(SliderCrank), Settings::accuracy(1e-6)).unwrap();
    assert_eq!(simulation.settings().method, Method::TwoLevel);
}

#[test]
fn the_error_is_that_which_was_asked_for() {
    let exact = run(SliderCrank, settings(8, 1e-3), 1.0);
    for accuracy in [1e-3, 1e-6, 1e-9] {
        let mut simulation = with_accuracy(SliderCrank, accuracy);
        simulation.run_until(1.0).unwrap();
        let error = distance(simulation.positions(), exact.positions());
        println!("{accuracy:e}: {error:.1e}");
        assert!(error < 3.0 * accuracy, "{accuracy:e}: {error:e}");
    }
}

/// The choice is by counts, and the settings that it leaves are those of a run that goes on.
#[test]
fn a_resumed_run_is_the_same_bit_for_bit() {
    let mut whole = with_accuracy(SliderCrank, 1e-7);
    whole.run_until(0.5).unwrap();
    let (settings, state) = (*whole.settings(), whole.state().clone());
    let mut resumed =
        Simulation::resume_with_any_method(Parameters(SliderCrank), settings, state).unwrap();
    whole.run_until(2.0).unwrap();
    resumed.run_until(2.0).unwrap();
    assert_eq!(whole.state(), resumed.state());
    assert_eq!(
        whole.settings(),
        with_accuracy(SliderCrank, 1e-7).settings()
    );
}

#[test]
fn what_is_no_accuracy_is_refused() {
    let refused = |settings: Settings| {
        let error = Simulation::with_settings(Parameters(SliderCrank), settings).err();
        assert!(
            matches!(
                error,
                Some(SimulationError::Setting {
                    name: "accuracy",
                    ..
                })
            ),
            "{error:?}"
        );
    };
    for accuracy in [0.0, 1.0, -1e-6, f64::NAN, 1e-13] {
        refused(Settings::accuracy(accuracy));
    }
    refused(Settings {
        tolerance: Some(1e-6),
        ..Settings::accuracy(1e-6)
    });
    refused(Settings {
        fixed_iterations: Some(2),
        ..Settings::accuracy(1e-6)
    });
}
