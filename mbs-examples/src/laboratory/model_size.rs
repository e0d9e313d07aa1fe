//! One slider-crank modelled in four ways: the cost of each at the same accuracy.

use std::io;

use super::measure::{errors, time};
use super::methods::{Entry, entry};
use super::outcome::Outcome;
use super::store::{Row, Store};
use super::svg::{Anchor, GRID, INK, Svg};
use super::yardstick::Yardstick;

/// The columns of `model-size.csv`; the first three identify a row.
pub const COLUMNS: [&str; 13] = [
    "model",
    "method",
    "bound",
    "coordinates",
    "velocities",
    "rows",
    "rank",
    "operations",
    "repeats",
    "step_s",
    "cpu_s",
    "position_error",
    "outcome",
];
/// How many of them identify a row.
pub const KEYS: usize = 3;

/// The bounds of the position error, m.
const BOUNDS: [f64; 2] = [1e-3, 1e-6];
/// The methods.
const METHODS: [&str; 3] = ["two-level 2", "two-level 8", "projected 8"];
/// Numbers of steps grow by this factor, from the least of them to the most.
const FINER: f64 = 1.15;
const STEPS: [f64; 2] = [50.0, 300_000.0];
/// A run is stopped after this processor time, s.
const PATIENCE: f64 = 2.0;

/// Rows of the chart of so many models.
pub fn points(models: usize) -> usize {
    models * METHODS.len() * BOUNDS.len()
}

/// Measures the rows that the store does not have yet; times are the least of `repeats`, in which the models alternate.
///
/// # Errors
/// A file that cannot be written.
pub fn measure(
    models: &[Yardstick],
    repeats: u32,
    store: &mut Store,
    tick: &mut dyn FnMut(),
) -> io::Result<()> {
    let mut cells = Vec::new();
    for method in METHODS.iter().filter_map(|label| entry(label)) {
        for bound in BOUNDS {
            for model in models {
                let bound_text = format!("{bound:e}");
                let key = [model.scene.name, method.label, &bound_text];
                if store.find(&key).is_none() {
                    store.put(coarsest(model, &method, bound, &key))?;
                }
                cells.push((model, method, bound_text));
                tick();
            }
        }
    }
    for _ in 1..repeats {
        for (model, method, bound) in &cells {
            let key = [model.scene.name, method.label, bound];
            let Some(mut row) = store.find(&key).cloned() else {
                continue;
            };
            let done: u32 = row[8].parse().unwrap_or(repeats);
            let (Ok(step), Ok(before)) = (row[9].parse::<f64>(), row[10].parse::<f64>()) else {
                continue;
            };
            if done < repeats && row[12] == Outcome::Ok.name() {
                let now = time(model, method, step).unwrap_or(f64::INFINITY);
                row[8] = (done + 1).to_string();
                row[10] = format!("{:.6e}", before.min(now));
                store.put(row)?;
            }
        }
    }
    store.compact()
}

/// The longest step with which the error, and that of the two next shorter steps, stays within the bound.
fn coarsest(model: &Yardstick, method: &Entry, bound: f64, key: &[&str; KEYS]) -> Row {
    let mut count = STEPS[0];
    let mut found = None;
    while count < STEPS[1] && found.is_none() {
        let steps = [1.0, 1.01, 1.02].map(|factor| model.duration / (count * factor).ceil());
        let mut worst: f64 = 0.0;
        for step in steps {
            if worst <= bound {
                let run = errors(model, method, step, PATIENCE);
                worst = match run.outcome {
                    Outcome::Ok => worst.max(run.position),
                    _ => f64::INFINITY,
                };
            }
        }
        if worst <= bound {
            found = Some((steps[0], worst));
        }
        count *= FINER;
    }
    let scene = model.scene;
    let rank = (scene.build)(&[], method.settings(model.duration, scene.step))
        .map_or(0, |simulation| simulation.assembly().rank);
    // Of all functions, each once.
    let operations = scene.model.operations.iter();
    let operations: usize = operations
        .map(|cost| cost.additions + cost.multiplications + cost.divisions + cost.calls)
        .sum();
    let mut row: Row = key.iter().map(|&cell| cell.to_owned()).collect();
    row.extend(
        [
            scene.model.coordinates.len(),
            scene.model.velocities.len(),
            scene.model.rows.len(),
            rank,
        ]
        .map(|number| number.to_string()),
    );
    row.push(operations.to_string());
    row.push("1".to_owned());
    match found {
        Some((step, error)) => {
            let cpu = time(model, method, step).unwrap_or(f64::INFINITY);
            row.extend([step, cpu, error].map(|number| format!("{number:.6e}")));
            row.push(Outcome::Ok.name().to_owned());
        }
        None => {
            row.extend(["-", "-", "-", "not reached"].map(str::to_owned));
        }
    }
    row
}

/// Bars of the processor time, one group for each method and bound.
pub fn draw(rows: &[Row]) -> String {
    // In the order of the headings, whatever the order in which they were measured.
    let place = |row: &&Row| {
        let method = METHODS.iter().position(|method| *method == row[1]);
        let bound = BOUNDS.iter().position(|bound| row[2].parse() == Ok(*bound));
        (method, bound)
    };
    let mut rows: Vec<&Row> = rows.iter().collect();
    rows.sort_by_key(place);
    const LEFT: f64 = 250.0;
    const UNIT: f64 = 130.0;
    let number = |row: &Row, i: usize| row[i].parse::<f64>().unwrap_or(f64::NAN);
    let times = rows.iter().map(|row| 1e3 * number(row, 10));
    let most = times.filter(|t| t.is_finite()).fold(1e-3, f64::max);
    let least = 10_f64.powi(-2);
    let decades = (most / least).log10().ceil().max(1.0);
    let (mut y, mut group) = (64.0, String::new());
    let height = 120.0 + 27.0 * rows.len() as f64 + 34.0 * (METHODS.len() * BOUNDS.len()) as f64;
    let mut svg = Svg::new(LEFT + UNIT * decades + 130.0, height);
    svg.text(
        [12.0, 28.0],
        19.0,
        Anchor::Start,
        INK,
        "One slider-crank, four models",
    );
    for decade in 0..=decades as i32 {
        let x = LEFT + UNIT * f64::from(decade);
        svg.line([x, 50.0], [x, height - 56.0], GRID, 1.0);
        let label = format!("{}", least * 10_f64.powi(decade));
        svg.text([x, height - 36.0], 14.0, Anchor::Middle, INK, &label);
    }
    for row in &rows {
        let heading = format!("{}, position error ≤ {} m", row[1], row[2]);
        if heading != group {
            svg.text([12.0, y + 22.0], 14.0, Anchor::Start, INK, &heading);
            y += 34.0;
            group = heading;
        }
        let label = format!("{}: {} + {}", row[0], row[4], row[5]);
        svg.text([LEFT - 10.0, y + 16.0], 14.0, Anchor::End, INK, &label);
        let time = 1e3 * number(row, 10);
        let length = UNIT * (time / least).log10().max(0.02);
        if time.is_finite() {
            svg.rect([LEFT, y + 2.0], [length, 19.0], "#14507d");
            let text = format!("{time:.3} ms");
            svg.text(
                [LEFT + length + 8.0, y + 17.0],
                14.0,
                Anchor::Start,
                INK,
                &text,
            );
        } else {
            svg.text(
                [LEFT + 8.0, y + 17.0],
                14.0,
                Anchor::Start,
                INK,
                "not reached",
            );
        }
        y += 27.0;
    }
    let note = "processor time of 10 s, ms; velocities + rows beside each model";
    svg.text([LEFT, height - 12.0], 14.0, Anchor::Start, INK, note);
    svg.finish("One slider-crank, four models")
}
