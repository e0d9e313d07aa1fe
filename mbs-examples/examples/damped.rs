//! Methods for forces of velocity, compared by the time that they need for an error of the positions at the end: a governor with
//! stiff dampers, a slider-crank and a double four-bar with a soft one through their singular poses, and a body on a stiff
//! bushing with dampers.
//!
//! `cargo run --release -p mbs-examples --example damped [--csv book/src/results/readme]`

use mbs_examples::pages::record::{File, Recorder};
use mbs_examples::scenes::flyball_governor::FlyballGovernor;
use mbs_examples::scenes::passages::{DoubleFourBar, OnBushing, SliderCrank};
use mbs_runtime::nalgebra::SVector;
use mbs_runtime::{BdfSettings, Mechanism, Method, Settings, Simulation, SimulationError, System};
use std::time::Instant;

const DURATION: f64 = 10.0;
/// m or rad.
const BOUNDS: [f64; 3] = [1e-2, 1e-4, 1e-6];
/// Steps of the coarsest run; each next one has a fifth more.
const FEWEST: f64 = 20.0;
/// No method is tried with more of them.
const MOST: f64 = 20_000.0;
/// A run counts if as many finer ones stay within the bound, too: a long step past a singular pose may succeed by luck.
const STEADY: usize = 3;
/// Runs with so many times the steps of the first one that holds are timed, too: where long steps fail and are halved, shorter
/// ones are faster.
const FURTHER: f64 = 30.0;
const REPEATS: usize = 5;

const BY_TOLERANCE: &str = "radau, tolerance";
/// Of settings.
const LEAST_TOLERANCE: f64 = 1e-12;

/// Label, method and order.
const METHODS: [(&str, Method, u8); 8] = [
    ("two-level 2", Method::TwoLevel, 2),
    ("two-level 4", Method::TwoLevel, 4),
    ("two-level 6", Method::TwoLevel, 6),
    ("two-level 8", Method::TwoLevel, 8),
    ("projected 8", Method::Projected, 8),
    ("radau", Method::Radau, 2),
    (BY_TOLERANCE, Method::Radau, 2),
    (
        "bdf",
        Method::Bdf(BdfSettings {
            tolerance: 1e-6,
            max_order: 5,
        }),
        2,
    ),
];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let recorder = Recorder::new("cargo run --release -p mbs-examples --example damped")?;
    recorder.check_names([])?;
    let columns = ["mechanism", "bound", "method", "control", "ms", "error"];
    let mut file = recorder.file("damped.csv", &columns, 3)?;
    print!("| mechanism | error |");
    METHODS
        .iter()
        .for_each(|(label, ..)| print!(" {label}, ms |"));
    println!("\n|---|---|{}", "---|".repeat(METHODS.len()));
    compare("governor", FlyballGovernor::default(), &mut file)?;
    let crank = SliderCrank {
        damping: 0.01,
        ..SliderCrank::default()
    };
    compare("slider-crank", crank, &mut file)?;
    let bars = DoubleFourBar {
        damping: 0.01,
        ..DoubleFourBar::default()
    };
    compare("double four-bar", bars, &mut file)?;
    let body = OnBushing {
        stiffness: 1e6,
        damping: 2e3,
        ..OnBushing::default()
    };
    compare("body on a bushing", body, &mut file)
}

fn compare<M, S, const Q: usize, const N: usize, const R: usize>(
    name: &str,
    mechanism: M,
    file: &mut File,
) -> Result<(), Box<dyn std::error::Error>>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    // Two methods whose equations of a step differ; half of their distance is the error of the reference.
    let fine = |method, order, step| {
        let settings = Settings {
            method,
            order,
            step,
            ..Settings::default()
        };
        run(&mechanism, settings).map(|(end, _)| end)
    };
    let reference = fine(Method::Radau, 2, 1e-3)?;
    let other = fine(Method::TwoLevel, 8, 5e-3)?;
    eprintln!(
        "{name}: reference to {:.0e}",
        0.5 * distance(&reference, &other)
    );
    let mut rows = BOUNDS.map(|bound| format!("| {name} | {bound:.0e} |"));
    for (label, method, order) in METHODS {
        // The steps of the first run that holds, and control, time and error of the fastest one.
        let mut found: [Option<(f64, f64, f64, f64)>; BOUNDS.len()] = [None; BOUNDS.len()];
        let mut recent: Vec<(Settings, f64)> = Vec::new();
        let mut steps = FEWEST;
        while steps < MOST
            && (found.iter()).any(|found| found.is_none_or(|(first, ..)| steps < FURTHER * first))
        {
            let settings = match label {
                BY_TOLERANCE => Settings {
                    tolerance: Some(tolerance(steps).max(LEAST_TOLERANCE)),
                    ..settings(method, order, DURATION * 1e3)
                },
                _ => settings(method, order, steps),
            };
            let error = match run(&mechanism, settings) {
                Ok((end, _)) => distance(&end, &reference),
                Err(_) => f64::INFINITY,
            };
            recent.push((settings, error));
            let last = &recent[recent.len().saturating_sub(STEADY + 1)..];
            for (bound, found) in BOUNDS.into_iter().zip(&mut found) {
                let holds = last.len() > STEADY && last.iter().all(|(_, error)| *error <= bound);
                if !holds || found.is_some_and(|(first, ..)| steps > FURTHER * first) {
                    continue;
                }
                let (settings, error) = last[0];
                let ms = time(&mechanism, settings)?;
                let first = found.map_or(steps, |(first, ..)| first);
                if found.is_none_or(|(_, _, least, _)| ms < least) {
                    *found = Some((first, control(&settings), ms, error));
                }
            }
            steps = (1.2 * steps).ceil();
        }
        for ((row, bound), found) in rows.iter_mut().zip(BOUNDS).zip(found) {
            let Some((_, control, ms, error)) = found else {
                row.push_str(" – |");
                continue;
            };
            row.push_str(&format!(" {ms:.2} |"));
            let values = [control, ms, error].map(|value| format!("{value:.3e}"));
            let keys = [name.to_owned(), format!("{bound:e}"), label.to_owned()];
            file.put(keys.into_iter().chain(values).collect())?;
        }
    }
    rows.iter().for_each(|row| println!("{row}"));
    Ok(())
}

/// A run of this many steps, or for BDF of such a tolerance.
fn settings(method: Method, order: u8, steps: f64) -> Settings {
    let (method, step) = match method {
        Method::Bdf(bdf) => {
            let tolerance = tolerance(steps);
            (
                Method::Bdf(BdfSettings { tolerance, ..bdf }),
                DURATION / 50.0,
            )
        }
        other => (other, DURATION / steps),
    };
    Settings {
        method,
        order,
        step,
        ..Settings::default()
    }
}

/// One that falls with the fourth power of steps.
fn tolerance(steps: f64) -> f64 {
    0.1 * (FEWEST / steps).powi(4)
}

/// The step, s, or the tolerance.
fn control(settings: &Settings) -> f64 {
    match settings.method {
        Method::Bdf(bdf) => bdf.tolerance,
        _ => settings.tolerance.unwrap_or(settings.step),
    }
}

/// The end of a run, and its processor time, ms.
fn run<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: &M,
    settings: Settings,
) -> Result<(SVector<f64, Q>, f64), SimulationError>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let mut simulation = Simulation::with_any_method(mechanism.clone(), settings)?;
    let start = Instant::now();
    simulation.run_until(DURATION)?;
    Ok((*simulation.positions(), 1e3 * start.elapsed().as_secs_f64()))
}

/// The least of some runs, ms.
fn time<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: &M,
    settings: Settings,
) -> Result<f64, SimulationError>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let mut least = f64::INFINITY;
    for _ in 0..REPEATS {
        least = least.min(run(mechanism, settings)?.1);
    }
    Ok(least)
}

fn distance<const Q: usize>(a: &SVector<f64, Q>, b: &SVector<f64, Q>) -> f64 {
    (a - b).amax()
}
