//! The summary of `mbs simulate`.

use std::fmt::Write as _;

use serde_json::{Map, Value, json};

use mbs_runtime::{Method, MethodChange, Model, RankLoss};

use super::results::FILES;
use super::simulate::Run;
use super::table::{Align, table};

/// Singular poses, and changes of the method, that are printed one by one.
const SHOWN: usize = 3;

/// The one object of `--json`.
pub fn json(run: &Run) -> String {
    let (model, report) = (run.simulation.model(), run.simulation.report());
    let settings = run.simulation.settings();
    let last = by_declared_name(model, &run.simulation.output_values());
    let reference = run.reference.as_ref().ok().map(|columns| {
        let file = run.scene.reference.map(|reference| reference.file);
        let columns: Map<String, Value> = columns
            .iter()
            .map(|c| {
                let errors = json!({"final": c.at_end, "max": c.largest, "instants": c.instants});
                (c.column.to_owned(), errors)
            })
            .collect();
        json!({"file": file, "errors": columns})
    });
    let object = json!({
        "scene": run.scene.name,
        "method": run.simulation.settings().method.name(),
        // Algorithm 1 has its own discretisation.
        "flow": matches!(settings.method, Method::TwoLevel).then(|| run.simulation.flow().name()),
        "order": settings.true_order(),
        "step_s": step(run),
        "tolerance": settings.tolerance,
        "accuracy": run.accuracy,
        "method_changes": method_changes(run.simulation.method_changes()),
        "coordinates": model.coordinates.len(),
        "velocities": run.simulation.velocities().len(),
        "rows": model.rows.len(),
        "rank": report.rank,
        "steps": report.steps,
        "stages": report.stages,
        "cpu_s": run.cpu,
        "final_time_s": run.simulation.time(),
        "energy_error_J": report.energy_error,
        "holonomic_error": report.holonomic_error,
        "velocity_error": report.velocity_error,
        "rejected_steps": report.rejected_steps,
        "placed_steps": report.placed_steps,
        "rank_losses": report.rank_losses,
        "events": events(run.simulation.rank_losses()),
        "status": if run.stopped.is_some() { "stopped" } else { "ok" },
        "message": run.stopped.as_ref().map(ToString::to_string),
        "final": last,
        "reference": reference,
    });
    format!("{object:#}\n")
}

/// The step, s; with a tolerance the mean step.
fn step(run: &Run) -> f64 {
    match run.simulation.settings().tolerance {
        Some(_) => run.simulation.time() / run.simulation.report().steps.max(1) as f64,
        None => run.simulation.settings().step,
    }
}

/// Singular poses passed.
fn events(losses: &[RankLoss]) -> Value {
    losses
        .iter()
        .map(
            |loss| json!({"time": loss.time, "sigma_min": loss.sigma_min, "joints": loss.joints(), "undetermined": loss.undetermined}),
        )
        .collect()
}

/// Changes of the method, for an accuracy.
fn method_changes(changes: &[MethodChange]) -> Value {
    changes
        .iter()
        .map(|change| {
            json!({
                "time": change.time,
                "before": change.before.name(),
                "method": change.method.name(),
                "order": change.order,
                "operations_per_s": change.operations,
            })
        })
        .collect()
}

/// Outputs under the names of the declaration: a vector, whose components are `p1.x` and `p1.y`, is `p1: [x, y]`.
fn by_declared_name(model: &Model, values: &[f64]) -> Map<String, Value> {
    let mut object = Map::new();
    for (output, value) in model.outputs.iter().zip(values) {
        match output.name.split_once('.') {
            None => drop(object.insert(output.name.to_owned(), json!(value))),
            Some((vector, _)) => {
                let components = object.entry(vector).or_insert_with(|| json!([]));
                if let Value::Array(components) = components {
                    components.push(json!(value));
                }
            }
        }
    }
    object
}

/// The summary as text.
pub fn text(run: &Run) -> String {
    let mut text = String::new();
    // Writing to a String cannot fail.
    let _ = write_text(&mut text, run);
    text
}

fn write_text(out: &mut String, run: &Run) -> std::fmt::Result {
    let (model, report) = (run.simulation.model(), run.simulation.report());
    let settings = run.simulation.settings();
    writeln!(
        out,
        "{}: {} ({})\n",
        run.scene.name, run.scene.title, run.scene.source
    )?;
    writeln!(
        out,
        "  model        {}, {} of rank {}",
        count(model.coordinates.len(), "coordinate"),
        count(model.rows.len(), "constraint row"),
        report.rank
    )?;
    for redundant in &run.simulation.assembly().redundant_rows {
        writeln!(out, "               `{redundant}` is redundant")?;
    }
    let method = match settings.method {
        Method::TwoLevel => format!(
            "{}, {} flow",
            settings.method.name(),
            run.simulation.flow().name()
        ),
        _ => settings.method.name().to_owned(),
    };
    let steps = match settings.tolerance {
        Some(tolerance) => format!(
            "tolerance {tolerance:e}, steps of {:.3e} s on average",
            step(run)
        ),
        None => format!("step {} s", settings.step),
    };
    writeln!(
        out,
        "  method       {method}, order {}, {steps}",
        settings.true_order()
    )?;
    if let Some(accuracy) = run.accuracy {
        writeln!(
            out,
            "               chosen for an accuracy of {accuracy:e}: the fewest operations per second of motion"
        )?;
    }
    write_method_changes(out, run.simulation.method_changes())?;
    let samples = match run.sampling {
        0 => String::new(),
        stages => format!(" and {stages} for samples between them"),
    };
    writeln!(
        out,
        "  run          {} s in {} steps, {} stages{samples} ({} rejected, {} placed), {:.3} ms of processor time",
        run.simulation.time(),
        report.steps,
        report.stages - run.sampling,
        report.rejected_steps,
        report.placed_steps,
        1e3 * run.cpu
    )?;
    if let Some(error) = &run.stopped {
        writeln!(
            out,
            "  STOPPED      at t = {} s: {error}",
            run.simulation.time()
        )?;
    }
    writeln!(
        out,
        "  energy       error {:.2e} J at most",
        report.energy_error
    )?;
    if !model.rows.is_empty() {
        writeln!(
            out,
            "  constraints  |φ| ≤ {:.2e}, |A v + b| ≤ {:.2e}",
            report.holonomic_error, report.velocity_error
        )?;
    }
    write_events(
        out,
        run.simulation.rank_losses(),
        report.rank_losses,
        step(run),
    )?;
    for (index, (output, value)) in model
        .outputs
        .iter()
        .zip(run.simulation.output_values())
        .enumerate()
    {
        let head = if index == 0 { "final" } else { "" };
        writeln!(
            out,
            "  {head:<11}  {} = {} {}",
            output.name,
            readable(value),
            output.unit
        )?;
    }
    write_reference(out, run)?;
    if let Some(directory) = &run.files {
        writeln!(
            out,
            "\n  files in {}: {}",
            directory.display(),
            FILES.join(", ")
        )?;
    }
    Ok(())
}

/// The first changes of the method, and how many there were.
fn write_method_changes(out: &mut String, changes: &[MethodChange]) -> std::fmt::Result {
    for change in changes.iter().take(SHOWN) {
        let [before, after] = change.operations;
        writeln!(
            out,
            "               from {:.6} s on {} of order {}: {after:.1e} operations per second of motion, {} {before:.1e}",
            change.time,
            change.method.name(),
            change.order,
            change.before.name()
        )?;
    }
    match changes.len().checked_sub(SHOWN) {
        None | Some(0) => Ok(()),
        Some(more) => writeln!(out, "               and {more} more changes of the method"),
    }
}

/// The first singular poses of the list, which has the last ones of `count` in all. Their times are good to about a hundredth of a
/// step of this length, s.
fn write_events(
    out: &mut String,
    losses: &[RankLoss],
    count: usize,
    step: f64,
) -> std::fmt::Result {
    let decimals = decimals(0.01 * step);
    for (index, loss) in losses.iter().take(SHOWN).enumerate() {
        writeln!(
            out,
            "  {:<11}  t = {:.decimals$} s, σ_min {:.1e}: {}{}",
            if index == 0 { "singular" } else { "" },
            loss.time,
            loss.sigma_min,
            loss.joints().join(", "),
            match loss.undetermined {
                true => " (at rest: the branch is not determined)",
                false => "",
            }
        )?;
    }
    match count.saturating_sub(losses.len().min(SHOWN)) {
        0 => Ok(()),
        _ if count > losses.len() => {
            let kept = losses.len();
            writeln!(
                out,
                "               {count} in all; these are the first of the last {kept}"
            )
        }
        more => writeln!(out, "               and {more} more"),
    }
}

/// How many decimals are not below an error.
fn decimals(error: f64) -> usize {
    // The logarithm of a power of ten is a little off.
    (1e-9 - error.log10()).floor().clamp(0.0, 9.0) as usize
}

fn write_reference(out: &mut String, run: &Run) -> std::fmt::Result {
    let columns = match (&run.reference, &run.scene.reference) {
        (Ok(columns), Some(reference)) => {
            let instants = columns.first().map_or(0, |c| c.instants);
            let file = reference.file;
            writeln!(
                out,
                "  reference    {file}, {} in common",
                count(instants, "instant")
            )?;
            columns
        }
        (Err(why), Some(_)) => return writeln!(out, "  reference    {why}"),
        _ => return Ok(()),
    };
    let heading = [
        ("          ", Align::Left),
        ("column", Align::Left),
        ("final error", Align::Right),
        ("largest error", Align::Right),
    ];
    let rows: Vec<_> = columns
        .iter()
        .map(|c| {
            let at_end = c
                .at_end
                .map_or("-".to_owned(), |error| format!("{error:.2e}"));
            [
                String::new(),
                c.column.to_owned(),
                at_end,
                format!("{:.2e}", c.largest),
            ]
        })
        .collect();
    *out += &table(heading, &rows);
    Ok(())
}

/// Ten digits; the trajectory has all digits.
fn readable(value: f64) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        1e-3..1e6 => format!("{value:.9}"),
        _ => format!("{value:.9e}"),
    }
}

/// `1 row`, `2 rows`.
pub fn count(number: usize, what: &str) -> String {
    let plural = if number == 1 { "" } else { "s" };
    format!("{number} {what}{plural}")
}
