//! `mbs explain`: the model of a scene.

use std::fmt::{self, Write as _};

use clap::Args;
use mbs_examples::pages::candidates::considered;
use mbs_examples::scene::Scene;
use mbs_runtime::{AnySimulation, Coordinate, Model, Quantity, RowKind, Settings};

use super::cost::cost;
use super::failure::Failure;
use super::find;
use super::print::print;
use super::table::{Align, table};

use Align::{Left, Right};

/// Arguments of `mbs explain`.
#[derive(Args)]
pub struct Explain {
    /// Name of the scene; `mbs list` shows them.
    scene: String,
    /// Print the equations in LaTeX instead.
    #[arg(long)]
    latex: bool,
    /// Print the size of each generated function instead.
    #[arg(long, conflicts_with = "latex")]
    cost: bool,
}

impl Explain {
    /// Prints the explanation.
    pub fn run(&self) -> Result<(), Failure> {
        let scene = find::scene(&self.scene)?;
        if self.latex {
            return print(&latex(scene.model)?);
        }
        if self.cost {
            return print(&cost(scene.model)?);
        }
        let mut text = String::new();
        // Writing to a String cannot fail.
        let _ = explain(&mut text, scene);
        print(&text)
    }
}

/// The equations of motion in LaTeX.
fn latex(model: &Model) -> Result<String, String> {
    mbs_macros_core::explain::latex(model.declaration)
}

fn explain(out: &mut String, scene: &Scene) -> fmt::Result {
    let model = scene.model;
    writeln!(out, "{}: {}", scene.name, scene.title)?;
    for line in [model.doc, scene.source] {
        if !line.is_empty() {
            writeln!(out, "{line}")?;
        }
    }
    if !model.candidates.is_empty() {
        write!(out, "\n{}", considered(model))?;
    }
    section(
        out,
        "Parts",
        [("part", Left), ("kind", Left), ("modelled as", Left)],
        model.parts.iter().map(|p| [p.name, p.kind, p.modelled_as]),
    );
    let heading = [
        ("coordinates", Left),
        ("unit", Left),
        ("velocities", Left),
        ("unit", Left),
    ];
    section(out, "Coordinates", heading, state(model).into_iter());
    let heading = [
        ("row", Left),
        ("kind", Left),
        ("entry", Left),
        ("unit", Left),
    ];
    section(out, "Constraint rows", heading, {
        model
            .rows
            .iter()
            .map(|r| [r.name, kind(r.kind), r.entry, r.unit])
    });
    if !model.reductions.is_empty() {
        writeln!(out, "\nReductions")?;
        for reduction in model.reductions {
            writeln!(out, "  {reduction}")?;
        }
    }
    structure(out, scene)?;
    reactions(out, model);
    operations(out, model);
    quantities(out, "Parameters", model.parameters);
    quantities(out, "Inputs", model.inputs);
    section(
        out,
        "Outputs",
        [("output", Left), ("unit", Left), ("", Left)],
        model.outputs.iter().map(|q| [q.name, q.unit, q.doc]),
    );
    if !model.events.is_empty() {
        writeln!(out, "\nEvents\n  {}", model.events.join(", "))?;
    }
    Ok(())
}

/// The properties of the equations that follow from the symbolic expressions and the assembled mechanism.
fn structure(out: &mut String, scene: &Scene) -> fmt::Result {
    let structure = scene.model.structure;
    let depends = |yes: bool, true_case, false_case| if yes { true_case } else { false_case };
    writeln!(out, "\nStructure")?;
    writeln!(
        out,
        "  mass matrix  {}",
        depends(
            structure.constant_mass,
            "constant",
            "depends on the coordinates"
        )
    )?;
    let forces = match (structure.position_forces, structure.velocity_forces) {
        (false, false) => "constant in positions and velocities",
        (true, false) => "depend on positions",
        (false, true) => "depend on velocities",
        (true, true) => "depend on positions and velocities",
    };
    writeln!(out, "  forces       {forces}")?;
    writeln!(
        out,
        "  time         {}",
        depends(
            structure.time_dependent,
            "appears in a row or force",
            "does not appear"
        )
    )?;
    let (rows, holonomic) = (scene.model.rows.len(), structure.holonomic_rows);
    writeln!(
        out,
        "  rows         {holonomic} holonomic, {} nonholonomic",
        rows - holonomic
    )?;
    let settings = Settings {
        step: scene.step,
        ..Settings::default()
    };
    match &scene.model.mobility {
        Some(mobility) => writeln!(out, "  mobility     {}", mobility.summary)?,
        None => writeln!(out, "  mobility     no pose was found at compile time")?,
    }
    match (scene.build)(&[], settings) {
        Ok(simulation) => assembled(out, simulation.as_ref()),
        Err(error) => writeln!(out, "  assembly     failed: {error}"),
    }
}

fn assembled(out: &mut String, simulation: &dyn AnySimulation) -> fmt::Result {
    let verdict = simulation.assembly();
    writeln!(out, "  at the start rank {}", verdict.rank)?;
    if !verdict.redundant_rows.is_empty() {
        let rows = verdict.redundant_rows.join(", ");
        writeln!(out, "               {rows} redundant there")?;
    }
    writeln!(out, "  flow         {}", simulation.flow().name())
}

/// Coordinates, each with its velocity; the components of a point or rotation are on one line.
fn state(model: &Model) -> Vec<[String; 4]> {
    let (coordinates, velocities) = (grouped(model.coordinates), grouped(model.velocities));
    let lines = coordinates.len().max(velocities.len());
    let cell = |groups: &[[String; 2]], line: usize| match groups.get(line) {
        Some(group) => group.clone(),
        None => [String::new(), String::new()],
    };
    let lines = (0..lines).map(|line| {
        let ([q, q_unit], [v, v_unit]) = (cell(&coordinates, line), cell(&velocities, line));
        [q, q_unit, v, v_unit]
    });
    lines.collect()
}

/// `crank.b.x, y` with its unit.
fn grouped(list: &[Coordinate]) -> Vec<[String; 2]> {
    let mut groups: Vec<([String; 2], &str)> = Vec::new();
    for item in list {
        let (stem, component) = item.name.rsplit_once('.').unwrap_or(("", item.name));
        match groups.last_mut() {
            Some(([text, unit], last))
                if *last == stem && unit == item.unit && !stem.is_empty() =>
            {
                *text += &format!(", {component}");
            }
            _ => groups.push(([item.name.to_owned(), item.unit.to_owned()], stem)),
        }
    }
    groups.into_iter().map(|(group, _)| group).collect()
}

/// The reactions of each joint, and whether they are determined.
fn reactions(out: &mut String, model: &Model) {
    let mut joints: Vec<[String; 3]> = Vec::new();
    let mut unit = "";
    for reaction in model.reactions {
        match joints.last_mut() {
            Some([joint, components, _]) if joint == reaction.joint => {
                *components += &match unit == reaction.unit {
                    true => format!(", {}", reaction.component),
                    false => format!(" {unit}; {}", reaction.component),
                };
            }
            _ => {
                finish(&mut joints, unit);
                let mark = match model.is_determined(reaction.joint) {
                    true => "",
                    false => "minimum-norm, not unique",
                };
                joints.push([reaction.joint, reaction.component, mark].map(str::to_owned));
            }
        }
        unit = reaction.unit;
    }
    finish(&mut joints, unit);
    section(
        out,
        "Reactions on the second partner, in the ground's axes",
        [("joint", Left), ("components", Left), ("", Left)],
        joints.into_iter(),
    );
}

/// The unit of the last components.
fn finish(joints: &mut [[String; 3]], unit: &str) {
    if let Some([_, components, _]) = joints.last_mut() {
        *components += &format!(" {unit}");
    }
}

fn operations(out: &mut String, model: &Model) {
    let heading = [
        ("function", Left),
        ("+ −", Right),
        ("×", Right),
        ("÷", Right),
        ("calls", Right),
    ];
    let rows = model.operations.iter().map(|cost| {
        let counts = [
            cost.additions,
            cost.multiplications,
            cost.divisions,
            cost.calls,
        ];
        let [additions, multiplications, divisions, calls] = counts.map(|n| n.to_string());
        [
            cost.function.to_owned(),
            additions,
            multiplications,
            divisions,
            calls,
        ]
    });
    section(out, "Operations", heading, rows);
}

fn quantities(out: &mut String, title: &str, quantities: &[Quantity]) {
    let heading = [
        ("name", Left),
        ("default", Right),
        ("unit", Left),
        ("", Left),
    ];
    let rows = quantities.iter().map(|q| {
        [
            q.name.to_owned(),
            q.default.to_string(),
            q.unit.to_owned(),
            q.doc.to_owned(),
        ]
    });
    section(out, title, heading, rows);
}

/// A titled table; nothing if it has no rows.
fn section<const COLUMNS: usize, Cell: Into<String>>(
    out: &mut String,
    title: &str,
    heading: [(&str, Align); COLUMNS],
    rows: impl Iterator<Item = [Cell; COLUMNS]>,
) {
    let rows: Vec<[String; COLUMNS]> = rows.map(|row| row.map(Into::into)).collect();
    if !rows.is_empty() {
        *out += &format!("\n{title}\n{}", table(heading, &rows));
    }
}

fn kind(kind: RowKind) -> &'static str {
    match kind {
        RowKind::Holonomic => "holonomic",
        RowKind::Rheonomic => "rheonomic",
        RowKind::Nonholonomic => "nonholonomic",
        _ => "other",
    }
}
