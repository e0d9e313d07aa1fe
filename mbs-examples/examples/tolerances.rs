//! The largest error of a run against its reference, as a multiple of the tolerance, for every tolerance and order, and
//! the order with the fewest stages.
//!
//! `cargo run --release -p mbs-examples --example tolerances [scene…] [--csv book/src/results/readme]`

use mbs_examples::pages::cases::{CASES, Case};
use mbs_examples::pages::record::Recorder;
use mbs_examples::pages::tolerances::{COLUMNS, KEYS};
use mbs_examples::reference::ReferenceTable;
use mbs_examples::scene::Scene;
use mbs_runtime::{Report, Settings, SimulationError};

const TOLERANCES: [f64; 7] = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9];
const ORDERS: [u8; 4] = [2, 4, 6, 8];
/// Number of instants.
const LOOKS: u32 = 1000;
/// Below this tolerance second order takes too long.
const LEAST_OF_SECOND: f64 = 1e-7;

fn main() -> Result<(), String> {
    let recorder = Recorder::new("cargo run --release -p mbs-examples --example tolerances")?;
    recorder.check_names(CASES.iter().map(|case| case.scene))?;
    let wanted = &recorder.arguments;
    let mut file = recorder.file("tolerances.csv", &COLUMNS, KEYS)?;
    println!(
        "| scene | order | error / tolerance (stages) at 1e-3 | 1e-4 | 1e-5 | 1e-6 | 1e-7 | 1e-8 | 1e-9 |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    for case in &CASES {
        if !wanted.is_empty() && !wanted.iter().any(|name| name == case.scene) {
            continue;
        }
        let Some((scene, reference)) = case.load()? else {
            continue;
        };
        for order in ORDERS {
            let mut cells = Vec::new();
            for tolerance in TOLERANCES {
                if order == 2 && tolerance < 0.9 * LEAST_OF_SECOND {
                    cells.push(String::new());
                    continue;
                }
                match run(case, scene, &reference, order, tolerance) {
                    Ok((error, report, with_looks)) => {
                        let ratio = error / tolerance;
                        cells.push(format!("{ratio:.2} ({})", report.stages));
                        let mut row = vec![scene.name.to_owned(), order.to_string()];
                        row.push(format!("{tolerance:e}"));
                        row.push(format!("{ratio:.4}"));
                        row.extend([report.stages, with_looks].map(|count| count.to_string()));
                        file.put(row)?;
                    }
                    Err(SimulationError::Order { .. }) => cells.push("–".to_owned()),
                    Err(error) => cells.push(error.to_string()),
                }
            }
            println!("| {} | {order} | {} |", scene.name, cells.join(" | "));
        }
    }
    Ok(())
}

/// The largest error at the instants of the reference, in sizes; counts without the steps to instants, and stages with
/// an instant every thousandth of the run.
fn run(
    case: &Case,
    scene: &Scene,
    reference: &ReferenceTable,
    order: u8,
    tolerance: f64,
) -> Result<(f64, Report, u64), SimulationError> {
    let settings = Settings {
        order,
        step: scene.step,
        tolerance: Some(tolerance),
        ..Settings::default()
    };
    let error = case.error(scene, reference, settings)?;
    let mut alone = (scene.build)(&[], settings)?;
    alone.run_until(scene.duration)?;
    let mut looking = (scene.build)(&[], settings)?;
    for instant in 1..LOOKS {
        let time = f64::from(instant) * scene.duration / f64::from(LOOKS);
        looking.run_past(time, scene.duration)?;
        looking.look_at(time, &mut |_| {})?;
    }
    looking.run_until(scene.duration)?;
    Ok((error, alone.report(), looking.report().stages))
}
