//! The largest error of a run against its reference, as a multiple of the tolerance, for every tolerance and order, and
//! the order with the fewest stages.
//!
//! `cargo run --release -p mbs-examples --example tolerances [scene…] [--csv book/src/results/readme]`

use mbs_examples::pages::record::Recorder;
use mbs_examples::pages::scene_runs::reference;
use mbs_examples::pages::tolerances::{COLUMNS, KEYS};
use mbs_examples::reference::ReferenceTable;
use mbs_examples::scene::Scene;
use mbs_examples::scenes::scenes;
use mbs_runtime::output::Frame;
use mbs_runtime::{Report, Settings, SimulationError};

/// The position columns of a scene, and its size in their unit.
struct Case {
    scene: &'static str,
    columns: &'static [&'static str],
    size: f64,
}

const CASES: [Case; 8] = [
    Case {
        scene: "pendulum",
        columns: &["x_m", "y_m"],
        size: 1.0,
    },
    Case {
        scene: "slider-crank",
        columns: &["p1x_m", "p1y_m", "p2x_m"],
        size: 2.0,
    },
    Case {
        scene: "double-four-bar",
        columns: &["b0x_m", "b0y_m"],
        size: 2.0,
    },
    Case {
        scene: "andrews",
        columns: &[
            "beta_rad",
            "theta_rad",
            "gamma_rad",
            "phi_rad",
            "delta_rad",
            "omega_rad",
            "epsilon_rad",
        ],
        size: 1.0,
    },
    Case {
        scene: "bricard",
        columns: &["p3x_m", "p3y_m", "p3z_m", "p2x_m", "p2z_m", "p5y_m"],
        size: 1.0,
    },
    Case {
        scene: "chaplygin-sleigh",
        columns: &["edge_x_m", "edge_y_m", "theta_rad"],
        size: 1.0,
    },
    Case {
        scene: "heavy-top",
        columns: &["x_m", "y_m", "z_m"],
        size: 1.0,
    },
    Case {
        scene: "flyball-governor",
        columns: &["s_m", "ball1_x_m", "ball1_y_m", "ball1_z_m"],
        size: 1.0,
    },
];
const TOLERANCES: [f64; 7] = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9];
const ORDERS: [u8; 4] = [2, 4, 6, 8];
/// Number of instants.
const LOOKS: u32 = 1000;
/// Below this tolerance second order takes too long.
const LEAST_OF_SECOND: f64 = 1e-7;

fn main() -> Result<(), String> {
    let recorder = Recorder::new("cargo run --release -p mbs-examples --example tolerances");
    let wanted = &recorder.arguments;
    let mut file = recorder.file("tolerances.csv", &COLUMNS, KEYS)?;
    println!(
        "| scene | order | error / tolerance (stages) at 1e-3 | 1e-4 | 1e-5 | 1e-6 | 1e-7 | 1e-8 | 1e-9 |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    for case in &CASES {
        let Some(scene) = scenes().iter().find(|scene| scene.name == case.scene) else {
            continue;
        };
        if !wanted.is_empty() && !wanted.iter().any(|name| name == case.scene) {
            continue;
        }
        let Some(reference) = reference(scene)? else {
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
    let mut simulation = (scene.build)(&[], settings)?;
    let mut frames = vec![Frame::record(simulation.as_ref())];
    let interval = reference.interval().unwrap_or(scene.duration);
    for instant in 1..=(scene.duration / interval).round() as u32 {
        let time = f64::from(instant) * interval;
        simulation.run_past(time, scene.duration)?;
        simulation.look_at(time, &mut |seen| frames.push(Frame::record(seen)))?;
    }
    let deviations = reference.compare(&frames);
    let positions = deviations
        .iter()
        .filter(|deviation| case.columns.contains(&deviation.column));
    let largest = positions.fold(0.0_f64, |largest, deviation| {
        match deviation.largest > largest || deviation.largest.is_nan() {
            true => deviation.largest,
            false => largest,
        }
    });
    let mut alone = (scene.build)(&[], settings)?;
    alone.run_until(scene.duration)?;
    let mut looking = (scene.build)(&[], settings)?;
    for instant in 1..LOOKS {
        let time = f64::from(instant) * scene.duration / f64::from(LOOKS);
        looking.run_past(time, scene.duration)?;
        looking.look_at(time, &mut |_| {})?;
    }
    looking.run_until(scene.duration)?;
    Ok((largest / case.size, alone.report(), looking.report().stages))
}
