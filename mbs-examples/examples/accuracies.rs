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
/// Steps between two instants of the reference, from one on, and tolerances, from the largest on, by these factors.
const PARTS: (f64, f64, f64) = (1.0, 1.25, 2e3);
const TOLERANCES: (f64, f64, f64) = (3e-2, 0.5, 1e-12);
/// Errors below this are round-off.
const ROUND_OFF: f64 = 1e-11;
/// The least of so many runs is the time of a run.
const REPEATED: usize = 5;

fn main() -> Result<(), String> {
    let recorder = Recorder::new("cargo run --release -p mbs-examples --example accuracies");
    let wanted = &recorder.arguments;
    let mut file = recorder.file("accuracies.csv", &COLUMNS, KEYS)?;
    let is_wanted =
        |case: &&Case| wanted.is_empty() || wanted.iter().any(|name| name == case.scene);
    for case in CASES.iter().filter(is_wanted) {
        let Some((scene, reference)) = case.load()? else {
            continue;
        };
        let others = others(case, scene, &reference);
        for accuracy in ACCURACIES {
            let settings = Settings {
                step: scene.step,
                ..Settings::accuracy(accuracy)
            };
            let failed = |error: SimulationError| format!("{}: {error}", case.scene);
            let error = case.error(scene, &reference, settings).map_err(failed)?;
            let begun = ProcessTime::now();
            let built = (scene.build)(&[], settings).map_err(failed)?;
            let start = begun.elapsed().as_secs_f64();
            let chosen = *built.settings();
            let time = time(scene, chosen).map_err(failed)?;
            let as_good = others.iter().filter(|other| other.error <= error);
            let fastest = as_good.min_by(|a, b| a.time.total_cmp(&b.time));
            let (name, least) = match fastest {
                Some(other) if other.time < time => (other.name.as_str(), other.time),
                _ => ("this", time),
            };
            let chosen = format!("{} {}", chosen.method.name(), chosen.order);
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

/// A run with given settings.
struct Other {
    name: String,
    error: f64,
    time: f64,
}

/// All runs of the search that come to their end.
fn others(case: &Case, scene: &Scene, reference: &ReferenceTable) -> Vec<Other> {
    let mut found = Vec::new();
    for (method, order) in METHODS
        .iter()
        .flat_map(|method| ORDERS.map(|order| (*method, order)))
    {
        let base = Settings {
            method,
            order,
            step: scene.step,
            ..Settings::default()
        };
        // Whole numbers of steps between the instants, so that both runs take the same.
        let interval = reference.interval().unwrap_or(scene.duration);
        let by_steps = geometric(PARTS).map(|parts| {
            let step = interval / parts.round();
            (format!("step {step:.2e} s"), Settings { step, ..base })
        });
        found.extend(search(case, scene, reference, by_steps));
        let by_tolerances = geometric(TOLERANCES).map(|tolerance| {
            let tolerance_settings = Settings {
                tolerance: Some(tolerance),
                ..base
            };
            (format!("tolerance {tolerance:.0e}"), tolerance_settings)
        });
        found.extend(search(case, scene, reference, by_tolerances));
    }
    found
}

/// The runs with these settings that come to their end, from coarse to fine.
fn search(
    case: &Case,
    scene: &Scene,
    reference: &ReferenceTable,
    candidates: impl Iterator<Item = (String, Settings)>,
) -> Vec<Other> {
    let mut found = Vec::new();
    for (by, settings) in candidates {
        let run = case
            .error(scene, reference, settings)
            .and_then(|error| Ok((error, time(scene, settings)?)));
        let Ok((error, time)) = run else {
            continue;
        };
        let name = format!("{} {}, {by}", settings.method.name(), settings.order);
        found.push(Other { name, error, time });
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

/// The processor time of the run alone, s.
fn time(scene: &Scene, settings: Settings) -> Result<f64, SimulationError> {
    let mut least = f64::INFINITY;
    for _ in 0..REPEATED {
        let mut simulation = (scene.build)(&[], settings)?;
        let begun = ProcessTime::now();
        simulation.run_until(scene.duration)?;
        least = least.min(begun.elapsed().as_secs_f64());
    }
    Ok(least)
}
