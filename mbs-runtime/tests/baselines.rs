//! The integrators of the literature: each shows its own order on every kind of structure it takes, agrees with the
//! two-level method at order 8, and refuses what it cannot do.

mod common;

use common::planar::{DampedSliderCrank, SliderCrank};
use common::scenes::*;
use common::spatial::{HeavyTop, RollingDisk, Sprung};
use common::{Hand, Parameters, Scene};
use mbs_runtime::{BaumgarteSettings, Method, Settings, Simulation};

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
    let mut simulation = Simulation::with_settings(Parameters(scene), settings).unwrap();
    simulation.run_until(time).unwrap();
    simulation
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    let pairs = a.iter().zip(b);
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
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
) -> [f64; Q] {
    if !T::STRUCTURE.velocity_forces {
        return *run(scene, by_name("two-level", 8, 2.5e-3), time).positions();
    }
    let at = |step| *run(scene.clone(), by_name("two-level", 2, step), time).positions();
    let [a, b, c] = [4e-4, 2e-4, 1e-4].map(at);
    std::array::from_fn(|i| {
        let (ab, bc) = ((4.0 * b[i] - a[i]) / 3.0, (4.0 * c[i] - b[i]) / 3.0);
        (16.0 * bc - ab) / 15.0
    })
}

#[test]
fn explicit_methods_have_their_order() {
    for name in ["baumgarte", "projected"] {
        for (order, h) in [(4, 0.01), (6, 0.04)] {
            let by = by_name(name, order, h);
            let expected = f64::from(order);
            slope(SliderCrank, by, expected, 0.24);
            slope(SliderCrankAngles, by, expected, 0.24);
            slope(Shaken, by, expected, 0.48);
        }
        let by = by_name(name, 4, 0.05);
        slope(Sleigh::default(), by, 4.0, 2.0);
        slope(Towing, by, 4.0, 1.0);
        slope(DampedSliderCrank, by_name(name, 4, 0.01), 4.0, 0.2);
    }
}

#[test]
fn explicit_methods_turn_bodies_with_their_order() {
    for name in ["baumgarte", "projected"] {
        for (order, h) in [(4, 5e-3), (6, 1e-2)] {
            let expected = f64::from(order);
            slope(HeavyTop, by_name(name, order, h), expected, 0.1);
            slope(RollingDisk, by_name(name, order, 10.0 * h), expected, 1.0);
            slope(
                Sprung::<false> {
                    stiffness: 40.0,
                    damping: 0.0,
                    spin: [1.0, 2.0, -1.0],
                },
                by_name(name, order, 2.0 * h),
                expected,
                0.2,
            );
        }
    }
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
