//! Singular passages at every order, with and without placement: a table of orders and steps, then a sweep over random
//! steps that counts failures and wrong branches.
//!
//! `cargo run --release -p mbs-examples --example passage_sweep [steps per order]`

use mbs_examples::reference::ReferenceTable;
use mbs_examples::scene::Scene;
use mbs_examples::scenes::{double_four_bar, slider_crank};
use mbs_runtime::output::Frame;
use mbs_runtime::{Report, Settings};

const SCENES: [(&Scene, &[&str]); 2] = [
    (&slider_crank::SCENE, &["p1x_m", "p1y_m", "p2x_m"]),
    (&double_four_bar::SCENE, &["b0x_m", "b0y_m"]),
];
const ORDERS: [u8; 4] = [2, 4, 6, 8];
const TABLE: [f64; 6] = [5e-2, 2.5e-2, 1e-2, 5e-3, 2.5e-3, 1e-3];
/// Steps are drawn from here, log-uniformly.
const STEPS: [f64; 2] = [5e-4, 2e-2];
/// s
const DURATION: f64 = 10.0;
/// s; the references have these instants.
const INTERVAL: f64 = 0.5;
/// A run that is this far from the reference, m, is on another branch.
const ASTRAY: f64 = 0.3;

struct Outcome {
    report: Report,
    /// Largest error of the named columns, m; `None` if the run stopped.
    position: Option<f64>,
}

fn main() {
    let count = std::env::args().nth(1).and_then(|n| n.parse().ok());
    let count: usize = count.unwrap_or(100);
    for (scene, columns) in SCENES {
        let reference = scene
            .reference
            .and_then(|r| ReferenceTable::find(&r, scene.model).ok().flatten());
        let Some(reference) = reference else {
            println!("{}: the reference was not found", scene.name);
            continue;
        };
        let run = |order, step, placement| run(scene, columns, &reference, order, step, placement);
        println!(
            "\n{}, {DURATION} s: energy error, J (position error, m) [stages; iterations a stage; placed steps]",
            scene.name
        );
        for placement in [false, true] {
            for order in ORDERS {
                for step in TABLE {
                    let with = if placement { "placed" } else { "fixed " };
                    let outcome = run(order, step, placement);
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
            "order placement failed astray   median      90 %    worst   median    worst  placed, % of steps"
        );
        for placement in [false, true] {
            for order in ORDERS {
                let mut random = 0x9e37_79b9_7f4a_7c15_u64;
                let (mut failed, mut astray, mut placed, mut steps) = (0, 0, 0, 0);
                let (mut errors, mut positions) = (Vec::new(), Vec::new());
                for _ in 0..count {
                    let ratio: f64 = STEPS[1] / STEPS[0];
                    let step = STEPS[0] * ratio.powf(uniform(&mut random));
                    let outcome = run(order, step, placement);
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
                println!(
                    "{order:>5} {:>9} {failed:>6} {astray:>6} {:>8.1e} {:>9.1e} {:>8.1e} {:>8.1e} {:>8.1e}  {:.2}",
                    if placement { "yes" } else { "no" },
                    at(&errors, 0.5),
                    at(&errors, 0.9),
                    at(&errors, 1.0),
                    at(&positions, 0.5),
                    at(&positions, 1.0),
                    100.0 * placed as f64 / steps as f64,
                );
            }
        }
    }
}

fn run(
    scene: &Scene,
    columns: &[&str],
    reference: &ReferenceTable,
    order: u8,
    step: f64,
    placement: bool,
) -> Outcome {
    let settings = Settings {
        order,
        step,
        placement,
        ..Settings::default()
    };
    let stopped = Outcome {
        report: Report::default(),
        position: None,
    };
    let Ok(mut simulation) = (scene.build)(&[], settings) else {
        return stopped;
    };
    let mut frames = Vec::new();
    for instant in 0..=(DURATION / INTERVAL) as u32 {
        if simulation.run_until(f64::from(instant) * INTERVAL).is_err() {
            return Outcome {
                report: simulation.report(),
                ..stopped
            };
        }
        frames.push(Frame::record(simulation.as_ref()));
    }
    let deviations = reference.compare(&frames);
    let position = deviations
        .iter()
        .filter(|deviation| columns.contains(&deviation.column))
        .map(|deviation| deviation.largest)
        .fold(0.0, |most, e| if e > most || e.is_nan() { e } else { most });
    Outcome {
        report: simulation.report(),
        position: Some(position),
    }
}

/// The next number in [0, 1): xorshift64*.
fn uniform(state: &mut u64) -> f64 {
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    (state.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 11) as f64 / (1u64 << 53) as f64
}
