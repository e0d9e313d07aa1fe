//! Runs with an accuracy instead of a method: what is chosen, its error, and its processor time against the fastest of our
//! methods whose error is not larger, by given steps or by a tolerance.
//!
//! `cargo run --release -p mbs-examples --example accuracies [scene…] [--csv book/src/results/readme]`

use cpu_time::ProcessTime;
use mbs_examples::pages::accuracies::{COLUMNS, KEYS};
use mbs_examples::pages::cases::{CASES, Case};
use mbs_examples::pages::record::Recorder;
use mbs_examples::reference::ReferenceTable;
use mbs_examples::scene::Scene;
use mbs_runtime::{Method, Settings, SimulationError};

const ACCURACIES: [f64; 3] = [1e-3, 1e-6, 1e-9];
const METHODS: [Method; 2] = [Method::TwoLevel, Method::Projected];
const ORDERS: [u8; 3] = [4, 6, 8];
/// Steps between two instants of the reference, from a twentieth on, and tolerances, from the largest on, by these factors.
const PARTS: (f64, f64, f64) = (0.05, 1.25, 2e3);
const TOLERANCES: (f64, f64, f64) = (3e-2, 0.5, 1e-12);
/// Errors below this are round-off.
const ROUND_OFF: f64 = 1e-11;
/// Runs that take so many times the longest one with an accuracy are not the fastest.
const LONG: f64 = 2.0;
/// The least of so many runs is the time of a run.
const REPEATED: usize = 5;

fn main() -> Result<(), String> {
    let recorder = Recorder::new("cargo run --release -p mbs-examples --example accuracies")?;
    recorder.check_names(CASES.iter().map(|case| case.scene))?;
    let wanted = &recorder.arguments;
    let mut file = recorder.file("accuracies.csv", &COLUMNS, KEYS)?;
    let is_wanted =
        |case: &&Case| wanted.is_empty() || wanted.iter().any(|name| name == case.scene);
    for case in CASES.iter().filter(is_wanted) {
        let Some((scene, reference)) = case.load()? else {
            continue;
        };
        let runs = ACCURACIES.map(|accuracy| Own::run(case, scene, &reference, accuracy));
        let runs = runs.into_iter().collect::<Result<Vec<Own>, _>>();
        let failed = |error: SimulationError| format!("{}: {error}", case.scene);
        let runs = runs.map_err(failed)?;
        let longest = runs.iter().map(|run| run.time).fold(0.0, f64::max);
        let others = others(case, scene, &reference, longest);
        for (run, accuracy) in runs.into_iter().zip(ACCURACIES) {
            let Own {
                settings,
                chosen,
                error,
                time,
                start,
            } = run;
            let enough = error.max(ROUND_OFF);
            let as_good = others.iter().filter(|other| other.error <= enough);
            let fastest = as_good.min_by(|a, b| a.time.total_cmp(&b.time));
            let rival = fastest.filter(|other| other.time < time);
            // Once more, one after the other: the machine was another one while others were searched.
            let again = |settings| self::time(scene, settings, f64::INFINITY);
            let times = rival.map(|other| Ok([again(settings)?, again(other.settings)?]));
            let times: Option<[f64; 2]> = times.transpose().map_err(failed)?;
            let (name, [time, least]) = match (rival, times) {
                (Some(other), Some(times)) if times[1] < times[0] => (other.name.as_str(), times),
                _ => ("this", [time, time]),
            };
            let chosen = format!("{} {}", chosen.method.name(), chosen.true_order());
            println!(
                "{:18} {accuracy:.0e} {chosen:12} error {:.3} accuracies, {:.3} ms, choice {:.3} ms; {name} {:.3} ms, ratio {:.2}",
                case.scene,
                error / accuracy,
                1e3 * time,
                1e3 * start,
                1e3 * least,
                time / least
            );
            file.put(vec![
                case.scene.to_owned(),
                format!("{accuracy:e}"),
                chosen,
                format!("{:.4}", error / accuracy),
                format!("{:.4}", 1e3 * time),
                format!("{:.4}", 1e3 * start),
                name.to_owned(),
                format!("{:.4}", 1e3 * least),
            ])?;
        }
    }
    Ok(())
}

/// A run with an accuracy.
struct Own {
    settings: Settings,
    chosen: Settings,
    error: f64,
    /// Processor time of the run and of the choice, s.
    time: f64,
    start: f64,
}

impl Own {
    fn run(
        case: &Case,
        scene: &Scene,
        reference: &ReferenceTable,
        accuracy: f64,
    ) -> Result<Self, SimulationError> {
        let settings = Settings {
            step: scene.step,
            ..Settings::accuracy(accuracy)
        };
        let error = case.error(scene, reference, settings)?;
        let begun = ProcessTime::now();
        let built = (scene.build)(&[], settings)?;
        let start = begun.elapsed().as_secs_f64();
        let chosen = *built.settings();
        Ok(Own {
            settings,
            chosen,
            error,
            time: time(scene, settings, f64::INFINITY)?,
            start,
        })
    }
}

/// A run with given settings.
struct Other {
    name: String,
    settings: Settings,
    error: f64,
    time: f64,
}

/// All runs of the search that come to their end, and are not much longer than the longest with an accuracy.
fn others(case: &Case, scene: &Scene, reference: &ReferenceTable, longest: f64) -> Vec<Other> {
    let mut found = Vec::new();
    let by_order = METHODS
        .iter()
        .flat_map(|method| ORDERS.map(|order| (*method, order)));
    for (method, order) in by_order.chain([(Method::Radau, 2)]) {
        let base = Settings {
            method,
            order,
            step: scene.step,
            ..Settings::default()
        };
        // Whole numbers of steps between the instants, or of instants in a step, so that both runs take the same.
        let interval = reference.interval().unwrap_or(scene.duration);
        let by_steps = geometric(PARTS).map(|parts| {
            let step = match parts < 1.0 {
                true => interval * parts.recip().round(),
                false => interval / parts.round(),
            };
            (format!("step {step:.2e} s"), Settings { step, ..base })
        });
        found.extend(search((case, scene, reference), longest, by_steps));
        let by_tolerances = geometric(TOLERANCES).map(|tolerance| {
            let tolerance_settings = Settings {
                tolerance: Some(tolerance),
                ..base
            };
            (format!("tolerance {tolerance:.0e}"), tolerance_settings)
        });
        found.extend(search((case, scene, reference), longest, by_tolerances));
    }
    found
}

/// The runs with these settings that come to their end, from coarse to fine.
fn search(
    (case, scene, reference): (&Case, &Scene, &ReferenceTable),
    longest: f64,
    candidates: impl Iterator<Item = (String, Settings)>,
) -> Vec<Other> {
    let mut found = Vec::new();
    for (by, settings) in candidates {
        let Ok(time) = time(scene, settings, LONG * longest) else {
            continue;
        };
        // Finer ones take longer.
        if time > LONG * longest {
            break;
        }
        let Ok(error) = case.error(scene, reference, settings) else {
            continue;
        };
        let name = format!("{} {}, {by}", settings.method.name(), settings.true_order());
        found.push(Other {
            name,
            settings,
            error,
            time,
        });
        // Finer ones only repeat round-off.
        if error < ROUND_OFF {
            break;
        }
    }
    found
}

fn geometric((first, factor, last): (f64, f64, f64)) -> impl Iterator<Item = f64> {
    let within = move |value: &f64| (*value - last) * (first - last) >= 0.0;
    std::iter::successors(Some(first), move |value| Some(value * factor)).take_while(within)
}

/// The processor time of the run alone, s; of one run only where that takes longer than `most`.
fn time(scene: &Scene, settings: Settings, most: f64) -> Result<f64, SimulationError> {
    let mut least = f64::INFINITY;
    for _ in 0..REPEATED {
        let mut simulation = (scene.build)(&[], settings)?;
        let begun = ProcessTime::now();
        simulation.run_until(scene.duration)?;
        least = least.min(begun.elapsed().as_secs_f64());
        if least > most {
            break;
        }
    }
    Ok(least)
}
