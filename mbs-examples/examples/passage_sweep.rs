//! Passages at every order, with and without placement: a table of orders and steps, then a sweep over random steps
//! that counts failures and wrong branches.
//!
//! `cargo run --release -p mbs-examples --example passage_sweep [steps per order] [--csv book/src/results/readme]`

use mbs_examples::pages::orders::{COLUMNS, DURATION, INTERVALS, KEYS, SCENES, row, run};
use mbs_examples::pages::record::Recorder;
use mbs_examples::pages::scene_runs::reference;
use mbs_runtime::{Method, Settings};

const ORDERS: [u8; 4] = [2, 4, 6, 8];
const TABLE: [f64; 6] = [5e-2, 2.5e-2, 1e-2, 5e-3, 2.5e-3, 1e-3];
/// Steps are drawn from here, log-uniformly.
const STEPS: [f64; 2] = [5e-4, 2e-2];
/// A run that is this far from the reference, m, is on another branch.
const ASTRAY: f64 = 0.3;

/// The methods of the sweeps, with their orders.
const METHODS: [(Method, &[u8]); 2] =
    [(Method::TwoLevel, &ORDERS), (Method::Projected, &[4, 6, 8])];

/// Columns of the file of the sweeps; the first four identify a sweep.
const SWEEPS: [&str; 13] = [
    "scene",
    "method",
    "order",
    "placement",
    "runs",
    "failed",
    "astray",
    "energy_error_median_J",
    "energy_error_90_J",
    "energy_error_worst_J",
    "position_error_median_m",
    "position_error_worst_m",
    "placed_percent",
];

fn main() -> Result<(), String> {
    let mut recorder =
        Recorder::new("cargo run --release -p mbs-examples --example passage_sweep")?;
    let count: usize = recorder.number(0, 100)?;
    let mut orders = recorder.file("orders.csv", &COLUMNS, KEYS)?;
    let mut sweeps = recorder.file("passages.csv", &SWEEPS, 4)?;
    for (scene, columns) in SCENES {
        let Some(reference) = reference(scene)? else {
            println!("{}: there is no reference", scene.name);
            continue;
        };
        let case = (scene, columns);
        let settings = |order, step, placement| Settings {
            order,
            step,
            placement,
            ..Settings::default()
        };
        println!(
            "\n{}, {DURATION} s: energy error, J (position error, m) [stages; iterations a stage; placed steps]",
            scene.name
        );
        for placement in [false, true] {
            for order in ORDERS {
                for step in TABLE {
                    let with = if placement { "placed" } else { "fixed " };
                    let settings = settings(order, step, placement);
                    for interval in INTERVALS {
                        let outcome = run(case, &reference, settings, interval);
                        orders.put(row(scene, &settings, interval, &outcome))?;
                    }
                    let outcome = run(case, &reference, settings, INTERVALS[0]);
                    let report = outcome.report;
                    println!(
                        "order {order} {with} h = {step:<6} {:>9.1e} ({}) [{}; {:.2}; {}]",
                        report.energy_error,
                        outcome
                            .position
                            .map_or("stopped".to_owned(), |e| format!("{e:.1e}")),
                        report.stages,
                        report.iterations as f64 / report.stages as f64,
                        report.placed_steps,
                    );
                }
            }
        }
        println!(
            "\n{}, {count} steps an order in [{:e}, {:e}] s: energy error, J, and position error, m",
            scene.name, STEPS[0], STEPS[1]
        );
        println!(
            "method order placement failed astray   median      90 %    worst   median    worst  placed, % of steps"
        );
        let sweeps_of = |&(method, orders): &(Method, &'static [u8])| {
            let placements = [false, true].into_iter();
            placements.flat_map(move |placement| {
                orders.iter().map(move |&order| (method, placement, order))
            })
        };
        for (method, placement, order) in METHODS.iter().flat_map(sweeps_of) {
            let mut random = 0x9e37_79b9_7f4a_7c15_u64;
            let (mut failed, mut astray, mut placed, mut steps) = (0, 0, 0, 0);
            let (mut errors, mut positions) = (Vec::new(), Vec::new());
            for _ in 0..count {
                let ratio: f64 = STEPS[1] / STEPS[0];
                let step = STEPS[0] * ratio.powf(uniform(&mut random));
                let outcome = run(
                    case,
                    &reference,
                    Settings {
                        method,
                        ..settings(order, step, placement)
                    },
                    INTERVALS[0],
                );
                placed += outcome.report.placed_steps;
                steps += outcome.report.steps;
                match outcome.position {
                    None => failed += 1,
                    Some(error) => {
                        astray += usize::from(!(error < ASTRAY));
                        errors.push(outcome.report.energy_error);
                        positions.push(error);
                    }
                }
            }
            errors.sort_by(f64::total_cmp);
            positions.sort_by(f64::total_cmp);
            let at = |errors: &[f64], part: f64| {
                let index = (part * errors.len() as f64) as usize;
                errors
                    .get(index.min(errors.len().saturating_sub(1)))
                    .copied()
                    .unwrap_or(f64::NAN)
            };
            let placement = if placement { "yes" } else { "no" };
            let placed = 100.0 * placed as f64 / steps as f64;
            let errors = [
                at(&errors, 0.5),
                at(&errors, 0.9),
                at(&errors, 1.0),
                at(&positions, 0.5),
                at(&positions, 1.0),
            ];
            let [median, most, worst, position, farthest] = errors;
            println!(
                "{:>9} {order:>5} {placement:>9} {failed:>6} {astray:>6} {median:>8.1e} {most:>9.1e} {worst:>8.1e} {position:>8.1e} {farthest:>8.1e}  {placed:.2}",
                method.name()
            );
            let mut row = vec![scene.name.to_owned(), method.name().to_owned()];
            row.push(order.to_string());
            row.push(placement.to_owned());
            row.extend([count, failed, astray].map(|count| count.to_string()));
            row.extend(errors.map(|error| format!("{error:.4e}")));
            row.push(format!("{placed:.2}"));
            sweeps.put(row)?;
        }
    }
    Ok(())
}

/// The next number in [0, 1): xorshift64*.
fn uniform(state: &mut u64) -> f64 {
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    (state.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 11) as f64 / (1u64 << 53) as f64
}
