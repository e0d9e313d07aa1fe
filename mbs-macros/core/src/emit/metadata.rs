//! The constant `MODEL`.

use super::body::number;
use crate::analysis::{Analysis, Candidate};
use crate::contract;
use crate::dag::Program;
use crate::equations::{Row, RowKind};
use crate::mobility::{self, Mobility};
use crate::model::{Held, Outline, Part, Quantity, Stored};
use crate::schema::World;
use std::fmt::Write;

/// The initialiser of `MODEL`, as text.
pub(super) fn emit(analysis: &Analysis, program: &Program) -> String {
    let (outline, mobility) = (&analysis.outline, analysis.mobility.as_ref());
    let layout = &analysis.derived.system.layout;
    let list = |items: Vec<String>| format!("&[{}]", items.join(", "));
    let stored = |items: &[Stored]| list(items.iter().map(coordinate_text).collect());
    let parts = outline.parts.iter().enumerate();
    let parts = parts.filter(|(_, part)| !part.representation.is_number());
    let parts = parts.map(|(index, part)| part_text(outline, index, part));
    let segments = outline.drawing.segments.iter().map(|(part, from, to)| {
        format!("::mbs_runtime::Segment {{ part: {part:?}, from: {from}, to: {to} }}")
    });
    let sites = outline.drawing.sites();
    let reactions = program.reactions.iter().map(|(joint, component, unit)| {
        let at = match sites.get(joint.as_str()) {
            Some(point) => format!("::core::option::Option::Some({point})"),
            None => "::core::option::Option::None".to_owned(),
        };
        format!(
            "::mbs_runtime::Reaction {{ joint: {joint:?}, component: {component:?}, unit: {unit:?}, at: {at} }}"
        )
    });
    let functions = program.functions.iter();
    let operations = functions
        .map(|function| (function.name, function.cost()))
        .chain(contract::loops(program))
        .map(|(name, cost)| {
            format!(
                "::mbs_runtime::FunctionCost {{ function: {:?}, additions: {}, multiplications: {}, divisions: {}, calls: {} }}",
                name, cost.additions, cost.multiplications, cost.divisions, cost.calls
            )
        })
        .collect();
    let outputs = outline.outputs.iter().map(quantity_text).collect();
    let mut out = String::from("&::mbs_runtime::Model {\n");
    let mut field = |name: &str, value: String| {
        let _ = writeln!(out, "{name}: {value},");
    };
    field("name", format!("{:?}", outline.name));
    field("doc", format!("{:?}", outline.doc));
    field("declaration", format!("{:?}", outline.text));
    let world = match outline.world {
        World::Planar => "Planar",
        World::Spatial => "Spatial",
    };
    field("world", format!("::mbs_runtime::World::{world}"));
    field("up", format!("[{}]", outline.up.map(number).join(", ")));
    field("coordinates", stored(&layout.coordinates));
    field("velocities", stored(&layout.velocities));
    field("rows", list(program.rows.iter().map(row_text).collect()));
    field("parts", list(parts.collect()));
    field(
        "parameters",
        list(outline.parameters.iter().map(quantity_text).collect()),
    );
    field(
        "inputs",
        list(outline.inputs.iter().map(quantity_text).collect()),
    );
    field("outputs", list(outputs));
    field(
        "events",
        list(
            outline
                .events
                .iter()
                .map(|name| format!("{name:?}"))
                .collect(),
        ),
    );
    let points = outline.drawing.points.iter();
    field(
        "points",
        lines(points.map(|(name, _)| name.as_str()).collect()),
    );
    field("marks", outline.drawing.marks.to_string());
    field("segments", list(segments.collect()));
    field("reactions", list(reactions.collect()));
    let reductions = outline.reductions.iter();
    field(
        "reductions",
        lines(reductions.map(String::as_str).collect()),
    );
    field("operations", list(operations));
    field("structure", structure(program));
    let moving = program.size - layout.states.len();
    field("mobility", mobility_text(mobility, program, moving));
    let candidates = analysis.candidates.iter();
    let chosen = outline.formulation;
    field("formulation", format!("{:?}", chosen.name()));
    field("candidates", list(candidates.map(candidate_text).collect()));
    out.push('}');
    out
}

/// A list of names or sentences.
pub(super) fn lines(items: Vec<&str>) -> String {
    format!("&{items:?}")
}

fn coordinate_text(item: &Stored) -> String {
    let (name, unit) = (&item.name, item.unit.to_string());
    format!("::mbs_runtime::Coordinate {{ name: {name:?}, unit: {unit:?} }}")
}

fn part_text(outline: &Outline, index: usize, part: &Part) -> String {
    let modelled_as = match outline.tree.carrier(index) {
        Some(joint) => joint.describe(part.representation),
        None => part.representation.describe().to_owned(),
    };
    format!(
        "::mbs_runtime::Part {{ name: {:?}, kind: {:?}, modelled_as: {modelled_as:?} }}",
        part.name, part.kind
    )
}

fn row_text(row: &Row) -> String {
    let kind = match row.kind {
        RowKind::Holonomic => "Holonomic",
        RowKind::Rheonomic => "Rheonomic",
        RowKind::Nonholonomic => "Nonholonomic",
    };
    let Row {
        name, entry, unit, ..
    } = row;
    format!(
        "::mbs_runtime::Row {{ name: {name:?}, entry: {entry:?}, kind: ::mbs_runtime::RowKind::{kind}, unit: {unit:?} }}"
    )
}

/// The initialiser of the `Structure`.
pub(super) fn structure(program: &Program) -> String {
    let s = program.structure;
    format!(
        "::mbs_runtime::Structure {{ constant_mass: {}, velocity_forces: {}, position_forces: {}, time_dependent: {}, rheonomic: {}, smooth: {}, holonomic_rows: {}, rotations: {} }}",
        s.constant_mass,
        s.velocity_forces,
        s.position_forces,
        s.time_dependent,
        s.rheonomic,
        s.smooth,
        s.holonomic_rows,
        s.rotations
    )
}

/// `moving` velocities are no states.
fn mobility_text(mobility: Option<&Mobility>, program: &Program, moving: usize) -> String {
    let Some(mobility) = mobility else {
        return "::core::option::Option::None".to_owned();
    };
    let integrable: Vec<&str> = mobility
        .integrable
        .iter()
        .map(|&row| program.rows[row].name.as_str())
        .collect();
    let redundant: Vec<String> = mobility
        .redundant
        .iter()
        .map(|redundancy| {
            format!(
                "::mbs_runtime::Redundancy {{ row: {:?}, follows_from: &{:?}, left_out: {} }}",
                redundancy.row, redundancy.follows_from, redundancy.vacuous
            )
        })
        .collect();
    format!(
        "::core::option::Option::Some(::mbs_runtime::Mobility {{ rank: {}, degrees_of_freedom: {}, redundant: &[{}], undetermined: &{:?}, integrable: &{integrable:?}, summary: {:?} }})",
        mobility.rank,
        mobility.mobility,
        redundant.join(", "),
        mobility.undetermined,
        mobility::summary(mobility, &program.rows, moving)
    )
}

fn candidate_text(candidate: &Candidate) -> String {
    format!(
        "::mbs_runtime::Candidate {{ formulation: {:?}, coordinates: {}, velocities: {}, rows: {}, rank: {}, operations: {}, cut: &{:?}, taken: {} }}",
        candidate.formulation.name(),
        candidate.coordinates,
        candidate.velocities,
        candidate.rows,
        option_text(candidate.rank),
        option_text(candidate.operations),
        candidate.cut,
        candidate.taken
    )
}

fn option_text(number: Option<usize>) -> String {
    match number {
        Some(number) => format!("::core::option::Option::Some({number})"),
        None => "::core::option::Option::None".to_owned(),
    }
}

pub(super) fn quantity_text(quantity: &Quantity) -> String {
    let default = match &quantity.constant {
        // Its type is checked where the defaults are made.
        Some(constant) => quote::quote! { #constant as f64 }.to_string(),
        None => number(quantity.default),
    };
    format!(
        "::mbs_runtime::Quantity {{ name: {:?}, unit: {:?}, default: {default}, doc: {:?} }}",
        quantity.name, quantity.unit, quantity.doc
    )
}

/// The constant that says that outputs read accelerations or reactions; nothing where none does.
pub(super) fn acceleration_level(program: &Program) -> &'static str {
    match program.function("outputs_at_acceleration_level") {
        Some(_) => "const HAS_OUTPUTS_AT_ACCELERATION_LEVEL: bool = true;\n",
        None => "",
    }
}

/// The constant that says that accelerations follow from independent velocities; nothing where they do not.
pub(super) fn partitioned(program: &Program) -> &'static str {
    match program.function("partitioned_accelerations") {
        Some(_) => "const PARTITIONED: bool = true;\n",
        None => "",
    }
}

/// The constant `HELD`; nothing where no initial value is held.
pub(super) fn held(held: &[Held]) -> String {
    if held.is_empty() {
        return String::new();
    }
    let texts = held.iter().map(|held| {
        let level = if held.is_velocity { "Velocity" } else { "Position" };
        format!(
            "::mbs_runtime::Held {{ name: {:?}, unit: {:?}, level: ::mbs_runtime::Level::{level} }}",
            held.name, held.unit
        )
    });
    let texts: Vec<String> = texts.collect();
    format!(
        "const HELD: &'static [::mbs_runtime::Held] = &[{}];\n",
        texts.join(", ")
    )
}
