//! The integrators of the literature: each shows its own order on every kind of structure it takes, agrees with the
//! two-level method at order 8, and refuses what it cannot do.

use crate::common::planar::{DampedSliderCrank, SliderCrank};
use crate::common::scenes::*;
use crate::common::spatial::{HeavyTop, RollingDisk, Sprung};
use crate::common::{Hand, Parameters, Scene, distance};
use mbs_runtime::nalgebra::SVector;
use mbs_runtime::{
    BaumgarteSettings, BdfSettings, GeneralizedAlphaSettings, Method, PaperSettings,
    PenaltySettings, Settings, Simulation, SimulationError,
};

type Run<T, const Q: usize, const N: usize, const R: usize> = Simulation<Hand<T, Q, N, R>, Q, N, R>;

fn by_name(name: &str, order: u8, step: f64) -> Settings {
    Settings {
        method: Method::by_name(name).unwrap(),
        order,
        step,
        ..Settings::default()
    }
}

fn run<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    settings: Settings,
    time: f64,
) -> Run<T, Q, N, R> {
    let mut simulation = Simulation::with_any_method(Parameters(scene), settings).unwrap();
    simulation.run_until(time).unwrap();
    simulation
}

/// Checks the slope of positions between h and h/2, against the two-level method with steps that leave no error.
fn slope<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    settings: Settings,
    expected: f64,
    time: f64,
) {
    let exact = exact(scene.clone(), time);
    let error = |step: f64| {
        let settings = Settings { step, ..settings };
        distance(run(scene.clone(), settings, time).positions(), &exact)
    };
    let (coarse, half) = (error(settings.step), error(0.5 * settings.step));
    let slope = (coarse / half).log2();
    let name = settings.method.name();
    println!(
        "{name} {}: {coarse:.2e} {half:.2e}, slope {slope:.2}",
        settings.order
    );
    assert!(
        (slope - expected).abs() < 0.15 * expected,
        "{name}: {slope}"
    );
}

/// Positions at the end, by the two-level method: order 8, or Richardson's extrapolation of order 2 where forces depend on
/// velocities.
fn exact<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    time: f64,
) -> SVector<f64, Q> {
    if !T::STRUCTURE.velocity_forces {
        return *run(scene, by_name("two-level", 8, 2.5e-3), time).positions();
    }
    let at = |step| *run(scene.clone(), by_name("two-level", 2, step), time).positions();
    let [a, b, c] = [4e-4, 2e-4, 1e-4].map(at);
    let (ab, bc) = ((4.0 * b - a) / 3.0, (4.0 * c - b) / 3.0);
    (16.0 * bc - ab) / 15.0
}

/// Explicit steps of an order that the steps of these tests resolve: the default gain asks for shorter ones before the
/// order shows.
fn explicit(name: &str, order: u8, step: f64) -> Settings {
    let mut settings = by_name(name, order, step);
    if let Method::Baumgarte(baumgarte) = &mut settings.method {
        baumgarte.gain = 10.0;
    }
    settings
}

#[test]
fn explicit_methods_have_their_order() {
    for name in ["baumgarte", "projected"] {
        for (order, h) in [(4, 0.01), (6, 0.04)] {
            let by = explicit(name, order, h);
            let expected = f64::from(order);
            slope(SliderCrank, by, expected, 0.24);
            slope(SliderCrankAngles, by, expected, 0.24);
            slope(Shaken, by, expected, 0.48);
        }
        let by = explicit(name, 4, 0.05);
        slope(Sleigh::default(), by, 4.0, 2.0);
        slope(Towing, by, 4.0, 1.0);
        slope(DampedSliderCrank, explicit(name, 4, 0.01), 4.0, 0.2);
    }
}

#[test]
fn explicit_methods_turn_bodies_with_their_order() {
    for name in ["baumgarte", "projected"] {
        for (order, h) in [(4, 5e-3), (6, 1e-2)] {
            let expected = f64::from(order);
            slope(HeavyTop, explicit(name, order, h), expected, 0.1);
            slope(RollingDisk, explicit(name, order, 10.0 * h), expected, 1.0);
            slope(
                Sprung::<false> {
                    stiffness: 40.0,
                    damping: 0.0,
                    spin: [1.0, 2.0, -1.0],
                },
                explicit(name, order, 2.0 * h),
                expected,
                0.2,
            );
        }
    }
}

#[test]
fn rattle_is_of_second_order() {
    slope(SliderCrank, by_name("rattle", 2, 0.01), 2.0, 0.24);
    slope(SliderCrankAngles, by_name("rattle", 2, 0.01), 2.0, 0.24);
    slope(Shaken, by_name("rattle", 2, 0.01), 2.0, 0.48);
    slope(HeavyTop, by_name("rattle", 2, 1e-3), 2.0, 0.1);
}

/// Its rows hold to a tolerance; with a tight one the order shows.
#[test]
fn the_modified_augmented_lagrangian_is_of_second_order() {
    let by = |step| Settings {
        method: Method::MAlf(PaperSettings {
            velocity_tolerance: 1e-8,
            residual_tolerance: 1e-9,
            ..PaperSettings::m_alf()
        }),
        step,
        ..Settings::default()
    };
    slope(SliderCrank, by(0.01), 2.0, 0.24);
    slope(SliderCrankAngles, by(0.01), 2.0, 0.24);
    slope(Shaken, by(0.01), 2.0, 0.48);
    slope(Sleigh::default(), by(0.05), 2.0, 2.0);
}

#[test]
fn implicit_methods_are_of_second_order() {
    for name in ["index3-projections", "generalized-alpha"] {
        slope(SliderCrank, by_name(name, 2, 0.01), 2.0, 0.24);
        slope(SliderCrankAngles, by_name(name, 2, 0.01), 2.0, 0.24);
        slope(Shaken, by_name(name, 2, 0.01), 2.0, 0.48);
        slope(DampedSliderCrank, by_name(name, 2, 0.01), 2.0, 0.24);
        slope(HeavyTop, by_name(name, 2, 5e-4), 2.0, 0.1);
    }
}

#[test]
fn generalized_alpha_takes_every_row_and_stabilises() {
    let by = |stabilised, step| Settings {
        method: Method::GeneralizedAlpha(GeneralizedAlphaSettings {
            stabilised,
            ..GeneralizedAlphaSettings::default()
        }),
        step,
        ..Settings::default()
    };
    for stabilised in [false, true] {
        slope(Sleigh::default(), by(stabilised, 0.05), 2.0, 2.0);
        slope(Towing, by(stabilised, 0.02), 2.0, 1.0);
        slope(RollingDisk, by(stabilised, 0.02), 2.0, 1.0);
    }
    slope(SliderCrank, by(true, 0.01), 2.0, 0.24);
    slope(SliderCrankAngles, by(true, 0.01), 2.0, 0.24);
    slope(Shaken, by(true, 0.01), 2.0, 0.48);
    let velocity_error = |stabilised| {
        run(SliderCrank, by(stabilised, 0.01), 0.24)
            .report()
            .velocity_error
    };
    let errors = [false, true].map(velocity_error);
    println!("{errors:?}");
    assert!(errors[0] > 1e-4 && errors[1] < 1e-10);
}

/// The position error is in proportion to 1/ξ.
#[test]
fn penalties_err_in_proportion() {
    let time = 0.24;
    let exact = exact(SliderCrank, time);
    let run = |penalty: f64| {
        let settings = Settings {
            method: Method::Penalty(PenaltySettings {
                penalty,
                ..PenaltySettings::default()
            }),
            step: 2e-5,
            ..Settings::default()
        };
        let end = run(SliderCrank, settings, time);
        let error = distance(end.positions(), &exact);
        let violation = end.report().holonomic_error;
        println!("penalty {penalty:.0e}: error {error:.2e}, violation {violation:.2e}");
        [error, violation]
    };
    let (weak, strong) = (run(1e5), run(1e6));
    for i in 0..2 {
        let ratio = weak[i] / strong[i];
        assert!((8.0..12.5).contains(&ratio), "{ratio}");
    }
}

#[test]
fn penalties_are_integrated_with_second_order() {
    let by = |scene, step| {
        let settings = Settings {
            method: Method::Penalty(PenaltySettings {
                penalty: 1e4,
                ..PenaltySettings::default()
            }),
            step,
            ..Settings::default()
        };
        *run(scene, settings, 0.24).positions()
    };
    let fine = by(SliderCrank, 1.25e-4);
    let [coarse, half] = [4e-3, 2e-3].map(|h| distance(&by(SliderCrank, h), &fine));
    let slope = (coarse / half).log2();
    println!("{coarse:.2e} {half:.2e} {slope:.2}");
    assert!((slope - 2.0).abs() < 0.3, "{slope}");
}

/// Errors follow the tolerance, and no more steps are taken than the order needs.
#[test]
fn backward_differentiation_holds_its_tolerance() {
    fn all<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
        scene: T,
        time: f64,
        most: f64,
    ) {
        let exact = exact(scene.clone(), time);
        let run = |tolerance: f64| {
            let settings = Settings {
                method: Method::Bdf(BdfSettings {
                    tolerance,
                    ..BdfSettings::default()
                }),
                step: 0.25 * time,
                ..Settings::default()
            };
            let end = run(scene.clone(), settings, time);
            let error = distance(end.positions(), &exact);
            let report = end.report();
            println!(
                "tolerance {tolerance:.0e}: error {error:.2e}, {} steps, {} iterations, {} rejected",
                report.stages, report.iterations, report.rejected_steps
            );
            assert!(error < most * tolerance, "{error}");
            report.stages as f64
        };
        let steps = [1e-5, 1e-7, 1e-9].map(run);
        let growth = steps[2] / steps[1];
        // 100^(1/6) = 2.2 at order five.
        assert!((1.3..4.5).contains(&growth), "{growth}");
    }
    all(SliderCrank, 0.3, 100.0);
    all(SliderCrankAngles, 0.3, 100.0);
    all(Shaken, 1.0, 300.0);
    all(Sleigh::default(), 2.0, 300.0);
    all(RollingDisk, 1.0, 300.0);
}

/// The steps that a tolerance takes tell the order.
#[test]
fn backward_differentiation_has_the_orders_one_to_five() {
    for max_order in 1..=5 {
        let steps = |tolerance: f64| {
            let settings = Settings {
                method: Method::Bdf(BdfSettings {
                    tolerance,
                    max_order,
                }),
                step: 0.5,
                ..Settings::default()
            };
            run(Shaken, settings, 2.0).report().stages as f64
        };
        let tolerance = if max_order < 3 { 1e-5 } else { 1e-7 };
        let growth = steps(0.01 * tolerance) / steps(tolerance);
        let expected = 100.0_f64.powf(1.0 / f64::from(max_order + 1));
        println!("order {max_order}: {growth:.2}, expected {expected:.2}");
        assert!((growth / expected - 1.0).abs() < 0.2, "{growth}");
    }
}

/// The energy balance counts the works of drives and dampers.
#[test]
fn energy_balances() {
    fn balances<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
        scene: T,
        name: &str,
        step: f64,
    ) {
        let by = |step| by_name(name, 2, step);
        let error = |step: f64| run(scene.clone(), by(step), 0.24).report().energy_error;
        let (coarse, half) = (error(step), error(0.5 * step));
        println!("{name}: {coarse:.2e} {half:.2e}");
        assert!(coarse > 3.0 * half || coarse < 1e-9, "{name}");
    }
    for name in [
        "baumgarte",
        "projected",
        "index3-projections",
        "generalized-alpha",
    ] {
        balances(Shaken, name, 0.01);
        balances(DampedSliderCrank, name, 0.01);
    }
    balances(Shaken, "rattle", 0.01);
}

#[test]
fn what_a_method_cannot_do_is_refused() {
    let refused = |error: Option<SimulationError>| {
        let Some(SimulationError::Method { .. }) = error else {
            panic!("{error:?}");
        };
        assert!(error.unwrap().to_string().contains("use two-level"));
    };
    for name in ["rattle", "index3-projections"] {
        let settings = by_name(name, 2, 1e-2);
        refused(Simulation::with_any_method(Parameters(Sleigh::default()), settings).err());
    }
    let settings = by_name("rattle", 2, 1e-2);
    refused(Simulation::with_any_method(Parameters(DampedSliderCrank), settings).err());
}

/// A v + b = 0 with b = −k t, against the closed form. The largest errors are 6.4e-7 m (penalty) and 2.2e-6 N (BDF).
#[test]
fn nonholonomic_rows_that_depend_on_time_are_followed() {
    let stabilised = Method::GeneralizedAlpha(GeneralizedAlphaSettings {
        stabilised: true,
        ..GeneralizedAlphaSettings::default()
    });
    let named = Method::NAMES.iter().map(|name| Method::by_name(name));
    let methods: Vec<Method> = named.flatten().chain([stabilised]).collect();
    assert_eq!(methods.len(), Method::NAMES.len() + 1);
    let mut wrong = Vec::new();
    for method in methods {
        let settings = Settings {
            method,
            step: 1e-3,
            ..Settings::default()
        };
        let name = method.name();
        let mut run = match Simulation::with_any_method(Parameters(Pushed), settings) {
            Err(SimulationError::Method { .. }) => {
                assert!(["rattle", "index3-projections"].contains(&name), "{name}");
                continue;
            }
            run => run.unwrap(),
        };
        if let Err(error) = run.run_until(1.0) {
            wrong.push(format!("{name}: {error}"));
            continue;
        }
        let wanted = SVector::from(Pushed::positions(1.0));
        let error = distance(run.positions(), &wanted);
        let (force, wanted) = (
            run.reactions().unwrap().multipliers[0],
            Pushed::lateral_force(1.0),
        );
        let line = format!("{name}: {error:.2e} m, {:.2e} N", force - wanted);
        println!("{line}");
        if !(error < 2e-6 && (force - wanted).abs() < 1e-5) {
            wrong.push(line);
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Errors shrink with the tolerance, and steps grow where they may.
#[test]
fn error_control_holds_what_it_promises() {
    let time = 0.24;
    let exact = exact(SliderCrankAngles, time);
    let run = |tolerance| {
        let method = Method::Baumgarte(BaumgarteSettings {
            adaptive: Some(tolerance),
            ..BaumgarteSettings::default()
        });
        let settings = Settings {
            method,
            step: 0.06,
            ..Settings::default()
        };
        let end = run(SliderCrankAngles, settings, time);
        let (error, stages) = (distance(end.positions(), &exact), end.report().stages);
        println!("tolerance {tolerance:.0e}: error {error:.2e}, {stages} stages");
        (error, stages)
    };
    let runs = [1e-4, 1e-6, 1e-8].map(run);
    for ((error, _), tolerance) in runs.iter().zip([1e-4, 1e-6, 1e-8]) {
        assert!(*error < 10.0 * tolerance);
    }
    let growth = runs[2].1 as f64 / runs[1].1 as f64;
    // The error of a step is of order five: 100^(1/5) = 2.5.
    assert!((1.5..4.0).contains(&growth), "{growth}");
}
