//! What was modelled, as text: `println!("{}", Arm::MODEL.explain())`.

use std::fmt::{self, Write as _};

use super::members::abridged;
use super::table::{Align, table};
use crate::{Coordinate, Model, Quantity, RowKind};

use Align::{Left, Right};

/// What was modelled, as text; made by [`Model::explain`].
#[derive(Debug, Clone, Copy)]
pub struct Explanation<'a>(&'a Model);

impl Model {
    /// The model as tables: descriptions that were compared, parts, coordinates, rows, structure and mobility, reactions,
    /// operations, parameters, inputs, states, outputs and events.
    ///
    /// ```
    /// use mbs_runtime::{Mechanism, mechanism};
    ///
    /// mechanism!(Arm {
    ///     world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    ///     arm: Bar(mass = 1.0_kg, length = 0.5_m),
    ///     shoulder: Revolute(ground.origin, arm.a),
    /// });
    ///
    /// println!("{}", Arm::MODEL.explain());
    /// # assert!(Arm::MODEL.explain().to_string().contains("Constraint rows") == !Arm::MODEL.rows.is_empty());
    /// ```
    pub fn explain(&self) -> Explanation<'_> {
        Explanation(self)
    }

    /// The descriptions that were compared, with the estimated operations of a step; empty if there was one only.
    pub fn considered(&self) -> String {
        match self.candidates {
            [] => String::new(),
            _ => considered(self),
        }
    }
}

impl fmt::Display for Explanation<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&explain(self.0))
    }
}

/// The whole text.
fn explain(model: &Model) -> String {
    let mut text = model.name.to_owned();
    for part in [": ", model.doc].iter().filter(|_| !model.doc.is_empty()) {
        text += part;
    }
    text.push('\n');
    let out = &mut text;
    if !model.candidates.is_empty() {
        let _ = write!(out, "\n{}", considered(model));
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
        let _ = writeln!(out, "\nReductions");
        let reductions = model.reductions.iter();
        for [reduction] in abridged(reductions.map(|text| [(*text).to_owned()]).collect()) {
            let _ = writeln!(out, "  {reduction}");
        }
    }
    structure(out, model);
    reactions(out, model);
    operations(out, model);
    quantities(out, "Parameters", model.parameters);
    quantities(out, "Inputs", model.inputs);
    let states: Vec<Quantity> = model.states().copied().collect();
    let heading = [
        ("name", Left),
        ("initial", Right),
        ("unit", Left),
        ("", Left),
    ];
    listed(out, "States", heading, &states);
    let outputs = model.outputs.iter();
    let outputs = outputs.filter(|output| !model.is_state(output.name));
    section(
        out,
        "Outputs",
        [("output", Left), ("unit", Left), ("", Left)],
        outputs.map(|q| [q.name, q.unit, q.doc]),
    );
    if !model.events.is_empty() {
        let _ = writeln!(out, "\nEvents\n  {}", model.events.join(", "));
    }
    text
}

/// The properties of the equations that follow from the symbolic expressions and the mobility.
fn structure(out: &mut String, model: &Model) {
    let structure = model.structure;
    // Writing to a String cannot fail.
    let depends = |yes: bool, true_case, false_case| if yes { true_case } else { false_case };
    let _ = writeln!(out, "\nStructure");
    let _ = writeln!(
        out,
        "  mass matrix  {}",
        depends(
            structure.constant_mass,
            "constant",
            "depends on the coordinates"
        )
    );
    let forces = match (structure.position_forces, structure.velocity_forces) {
        (false, false) => "constant in positions and velocities",
        (true, false) => "depend on positions",
        (false, true) => "depend on velocities",
        (true, true) => "depend on positions and velocities",
    };
    let _ = writeln!(out, "  forces       {forces}");
    let _ = writeln!(
        out,
        "  time         {}",
        depends(
            structure.time_dependent,
            "appears in a row or force",
            "does not appear"
        )
    );
    let _ = writeln!(
        out,
        "  smoothness   {}",
        depends(
            structure.smooth,
            "sums, products, sines and cosines alone",
            "other functions, too: steps with a tolerance look for jumps of forces"
        )
    );
    let (rows, holonomic) = (model.rows.len(), structure.holonomic_rows);
    let _ = writeln!(
        out,
        "  rows         {holonomic} holonomic, {} nonholonomic",
        rows - holonomic
    );
    let mobility = model.mobility.map(|mobility| mobility.summary);
    let mobility = mobility.unwrap_or("no pose was found at compile time");
    let _ = writeln!(out, "  mobility     {mobility}");
}

/// The table of the descriptions that were compared.
fn considered(model: &Model) -> String {
    let rows = model.candidates.iter().map(|candidate| {
        [
            candidate.formulation.to_owned(),
            cut(candidate.cut),
            candidate.velocities.to_string(),
            candidate.rows.to_string(),
            candidate
                .rank
                .map_or_else(String::new, |rank| rank.to_string()),
            candidate
                .operations
                .map_or_else(|| "more".to_owned(), |operations| operations.to_string()),
            if candidate.taken { "taken" } else { "" }.to_owned(),
        ]
    });
    let rows: Vec<_> = rows.collect();
    let heading = [
        ("choice", Left),
        ("loops cut at", Left),
        ("velocities", Right),
        ("rows", Right),
        ("rank", Right),
        ("operations", Right),
        ("", Left),
    ];
    format!(
        "Coordinates considered, with the estimated operations of a step\n{}",
        table(heading, &rows)
    )
}

/// The joints that close loops; their number where there are many.
fn cut(joints: &[&str]) -> String {
    match joints.len() {
        0..=3 => joints.join(", "),
        many => format!("{many} joints"),
    }
}

/// Coordinates, each with its velocity; the components of a point or rotation are on one line.
fn state(model: &Model) -> Vec<[String; 4]> {
    let coordinates = model.coordinates.iter();
    let coordinates = coordinates.filter(|q| !model.is_integral(q.name));
    let velocities = model.velocities.iter();
    let velocities = velocities.filter(|v| !model.is_state(v.name));
    let (coordinates, velocities) = (grouped(coordinates), grouped(velocities));
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
fn grouped<'a>(list: impl Iterator<Item = &'a Coordinate>) -> Vec<[String; 2]> {
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
    listed(out, title, heading, quantities);
}

fn listed(out: &mut String, title: &str, heading: [(&str, Align); 4], quantities: &[Quantity]) {
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
        *out += &format!("\n{title}\n{}", table(heading, &abridged(rows)));
    }
}

fn kind(kind: RowKind) -> &'static str {
    match kind {
        RowKind::Holonomic => "holonomic",
        RowKind::Rheonomic => "rheonomic",
        RowKind::Nonholonomic => "nonholonomic",
    }
}
