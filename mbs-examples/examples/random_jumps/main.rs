//! Random motions with forces that jump or bend, against a fine reference. Each runs with several accuracies; and with two-level steps
//! of orders 4, 6 and 8 and the tolerances that these accuracies give to their methods.
//!
//! Errors are the largest ones of a coordinate at ten instants, in m or rad. They are divided by the accuracy times max(1, A), where
//! A = |Δq|/δ is the change of the motion for a relative change δ of the first parameter.
//!
//! `cargo run --release -p mbs-examples --example random_jumps -- [COUNT] [SEED] [--csv book/src/results/readme]`

mod mechanisms;
#[allow(dead_code)] // For tests, too.
#[path = "../../../tests/src/random.rs"]
mod random;

use mbs_examples::pages::random_jumps::{COLUMNS, KEYS, METHODS};
use mbs_examples::pages::record::Recorder;
use mbs_runtime::{Method, Settings, SimulationError};
use mechanisms::{KINDS, Kind};
use random::Random;

const ACCURACIES: [f64; 5] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6];
/// The length of a run, s, and the instants that are compared.
const DURATION: f64 = 5.0;
const INSTANTS: u32 = 10;
/// Of the reference, and of a run that shows how sure it is.
const TOLERANCES: [f64; 2] = [1e-11, 1e-10];
/// Accuracies are left out where the reference is not sure to this part of them.
const SURE: f64 = 0.3;
/// A relative change of the first parameter.
const CHANGE: f64 = 1e-7;
/// Motions that amplify it more are left out.
const AMPLIFIED: f64 = 1e3;
/// An error of so many accuracies is too large.
const MOST: f64 = 10.0;

/// The tolerance of two-level steps for an accuracy of one: that which `Settings::accuracy` gives to its methods.
const SHARE: f64 = 0.2;

/// Coordinates at the instants.
type Motion = Vec<Vec<f64>>;

fn main() -> Result<(), String> {
    let mut recorder = Recorder::new("cargo run --release -p mbs-examples --example random_jumps")?;
    let (count, seed) = (recorder.number(0, 100)?, recorder.number(1, 1)?);
    let mut file = recorder.file("random_jumps.csv", &COLUMNS, KEYS)?;
    println!("{}", COLUMNS.join(", "));
    let mut all_beyond = 0;
    for kind in &KINDS {
        let mut errors = METHODS.map(|_| Vec::new());
        for run in 0..count {
            let found = measure(kind, seed, run);
            errors
                .iter_mut()
                .zip(found)
                .for_each(|(all, found)| all.extend(found));
        }
        for ((method, _), mut errors) in METHODS.into_iter().zip(errors) {
            errors.sort_by(f64::total_cmp);
            let beyond = errors.iter().filter(|error| !(**error <= MOST)).count();
            all_beyond += beyond;
            let [median, largest] = [errors.len() / 2, errors.len().saturating_sub(1)]
                .map(|place| errors.get(place).copied().unwrap_or(f64::NAN));
            let line = vec![
                kind.name.to_owned(),
                method.to_owned(),
                errors.len().to_string(),
                beyond.to_string(),
                format!("{median:.3}"),
                format!("{largest:.2}"),
            ];
            println!("{}", line.join(", "));
            file.put(line)?;
        }
    }
    match all_beyond {
        0 => Ok(()),
        _ => Err(format!("{all_beyond} errors are above {MOST} accuracies")),
    }
}

/// The settings for an accuracy, with two-level steps of this order or by the accuracy alone.
fn settings(order: Option<u8>, accuracy: f64) -> Settings {
    match order {
        Some(order) => Settings {
            order,
            tolerance: Some(SHARE * accuracy),
            ..Settings::default()
        },
        None => Settings::accuracy(accuracy),
    }
}

/// The errors of a random motion by each of the [`METHODS`], as multiples of the accuracies of which the reference is sure; none without
/// a reference.
fn measure(kind: &Kind, seed: usize, run: usize) -> [Vec<f64>; METHODS.len()] {
    let random = &mut Random::of(&format!("{seed} {} {run}", kind.name));
    let mut draw = |&[least, most]: &[f64; 2]| {
        let mut among = |a: f64, b: f64| 0.5 * (a + b) + random.within(0.5 * (b - a));
        match least > 0.0 && most > 10.0 * least {
            true => among(least.ln(), most.ln()).exp(),
            false => among(least, most),
        }
    };
    let numbers: Vec<f64> = kind.ranges.iter().map(&mut draw).collect();
    let what = format!("{} {numbers:?}", kind.name);
    let mut changed = numbers.clone();
    changed[0] *= 1.0 + CHANGE;
    let references = [
        reference(kind, &numbers, TOLERANCES[0]),
        reference(kind, &numbers, TOLERANCES[1]),
        reference(kind, &changed, TOLERANCES[0]),
    ];
    let [Ok(fine), Ok(coarser), Ok(changed)] = &references else {
        println!("{what}: a reference fails");
        return METHODS.map(|_| Vec::new());
    };
    let amplified = (apart(changed, fine) / CHANGE).max(1.0);
    if amplified > AMPLIFIED {
        return METHODS.map(|_| Vec::new());
    }
    let unsure = apart(coarser, fine);
    let sure: Vec<f64> = ACCURACIES
        .into_iter()
        .filter(|accuracy| unsure <= SURE * accuracy)
        .collect();
    METHODS.map(|(method, order)| {
        let error = |&accuracy: &f64| {
            let motion = motion(kind, &numbers, settings(order, accuracy));
            let error = motion.map_or(f64::INFINITY, |motion| apart(&motion, fine));
            let error = error / (accuracy * amplified);
            if !(error <= MOST) {
                println!("{what}, {method}, {accuracy:e}: {error:.1} accuracies");
            }
            error
        };
        sure.iter().map(error).collect()
    })
}

/// By Radau where it is a candidate, otherwise by explicit steps.
fn reference(kind: &Kind, numbers: &[f64], tolerance: f64) -> Result<Motion, SimulationError> {
    let settings = |method, order| Settings {
        method,
        order,
        tolerance: Some(tolerance),
        ..Settings::default()
    };
    motion(kind, numbers, settings(Method::Radau, 2))
        .or_else(|_| motion(kind, numbers, settings(Method::Projected, 8)))
}

fn motion(kind: &Kind, numbers: &[f64], settings: Settings) -> Result<Motion, SimulationError> {
    let mut simulation = (kind.build)(numbers, settings)?;
    (1..=INSTANTS)
        .map(|instant| {
            simulation.run_until(DURATION * f64::from(instant) / f64::from(INSTANTS))?;
            Ok(simulation.coordinates())
        })
        .collect()
}

/// The largest difference of a coordinate; infinite if one is not a number.
fn apart(one: &Motion, other: &Motion) -> f64 {
    let pairs = one.iter().flatten().zip(other.iter().flatten());
    let differences = pairs.map(|(a, b)| (a - b).abs());
    differences.fold(0.0, |most, difference| match difference.is_nan() {
        true => f64::INFINITY,
        false => difference.max(most),
    })
}
