//! The runs behind the README's table of scenes: each scene with its own step and length.

use cpu_time::ProcessTime;
use mbs_runtime::output::Frame;
use mbs_runtime::{AnySimulation, Settings, SimulationError};

use crate::laboratory::store::Row;
use crate::reference::ReferenceTable;
use crate::scene::Scene;
use crate::scenes::scenes;
use std::path::Path;

/// Below `book/src/results`.
pub const FILE: &str = "readme/scenes.csv";
/// The columns of the file; the first identifies a run.
pub const COLUMNS: [&str; 15] = [
    "scene",
    "velocities",
    "rows",
    "rank",
    "step_s",
    "duration_s",
    "steps",
    "stages",
    "iterations",
    "energy_error_J",
    "kinetic_energy_J",
    "position_error",
    "holonomic_error",
    "velocity_error",
    "time_us",
];
/// A repetition gives the same values of these, except for round-off and its growth.
pub const REPEATABLE: [&str; 5] = [
    "energy_error_J",
    "kinetic_energy_J",
    "position_error",
    "holonomic_error",
    "velocity_error",
];
/// How many columns identify a run.
pub const KEYS: usize = 1;

/// Scenes of the table, each with a remark.
pub const SCENES: [(&str, &str); 16] = [
    ("pendulum", " (a bar)"),
    ("slider-crank", ", through singular poses"),
    ("double-four-bar", ", through singular poses"),
    ("four-bar-10", ""),
    ("four-bar-40", ", sparse elimination"),
    ("andrews", ""),
    ("chaplygin-sleigh", " (nonholonomic)"),
    ("driven-slider-crank", " (rheonomic)"),
    ("spherical-pendulum", ""),
    ("heavy-top", ", 150 rad/s"),
    ("bricard", ""),
    ("bricard-reference", ", the same by bodies"),
    ("flyball-governor", ", springs of 8e5 N/m, dampers"),
    ("cardan-shaft", ""),
    ("rolling-disk", " (nonholonomic)"),
    ("rattleback", " (nonholonomic)"),
];

/// A scene by its name.
///
/// # Errors
/// There is no such scene.
pub fn scene(name: &str) -> Result<&'static Scene, String> {
    let found = scenes().iter().find(|scene| scene.name == name);
    found.ok_or_else(|| format!("there is no scene `{name}`"))
}

/// The reference of a scene as the repository has it, thinned; `None` if there is none.
///
/// # Errors
/// A file that cannot be read.
pub fn reference(scene: &Scene) -> Result<Option<ReferenceTable>, String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/reference");
    let read = |reference: &crate::scene::Reference| {
        ReferenceTable::read(folder.join(reference.file), reference, scene.model)
    };
    scene.reference.as_ref().map(read).transpose()
}

/// Runs the scene with its own step and compares it; the row has no time yet.
///
/// # Errors
/// What stopped it.
pub fn run(scene: &Scene) -> Result<Row, String> {
    let table = reference(scene)?;
    let interval = table.as_ref().and_then(ReferenceTable::interval);
    let frames = |simulation: &mut dyn AnySimulation| {
        let samples = (scene.duration / interval.unwrap_or(scene.duration)).round();
        let mut frames = vec![Frame::record(simulation)];
        for sample in 1..=samples as u32 {
            simulation.run_until(f64::from(sample) * scene.duration / samples)?;
            frames.push(Frame::record(simulation));
        }
        Ok::<_, SimulationError>(frames)
    };
    let stopped = |error: SimulationError| format!("{}: {error}", scene.name);
    let mut simulation = start(scene, scene.step).map_err(stopped)?;
    let frames = frames(simulation.as_mut()).map_err(stopped)?;
    let report = simulation.report();
    let kinetic = frames.iter().map(|frame| frame.energy.kinetic);
    let position = table.map(|table| table.position_error(&frames));
    let mut row: Row = vec![scene.name.to_owned()];
    let sizes = [
        scene.model.velocities.len(),
        scene.model.rows.len(),
        report.rank,
    ];
    row.extend(sizes.map(|size| size.to_string()));
    row.extend([scene.step, scene.duration].map(|time| format!("{time:e}")));
    row.extend([report.steps, report.stages, report.iterations].map(|count| count.to_string()));
    row.extend(
        [report.energy_error, kinetic.fold(0.0, f64::max)].map(|energy| format!("{energy:.4e}")),
    );
    row.push(position.map_or_else(String::new, |error| format!("{error:.4e}")));
    row.extend([report.holonomic_error, report.velocity_error].map(|error| format!("{error:.2e}")));
    row.push(String::new());
    Ok(row)
}

/// Processor time of a step with its energy balance, µs.
///
/// # Errors
/// What stopped it.
pub fn time(scene: &Scene) -> Result<f64, String> {
    let stopped = |error: SimulationError| format!("{}: {error}", scene.name);
    let mut simulation = start(scene, scene.step).map_err(stopped)?;
    let begin = ProcessTime::now();
    simulation.run_until(scene.duration).map_err(stopped)?;
    let time = begin.elapsed().as_secs_f64();
    Ok(1e6 * time / simulation.report().steps as f64)
}

/// The scene at its start, with this step.
pub(super) fn start(scene: &Scene, step: f64) -> Result<Box<dyn AnySimulation>, SimulationError> {
    let settings = Settings {
        step,
        ..Settings::default()
    };
    (scene.build)(&[], settings)
}
