//! The reference page of the language, from the schema and the table of units.

use crate::model::{Dimension, UNITS};
use crate::schema::{Absent, Expects, Field, Group, KINDS, Kind, WORLDS};
use std::fmt::Write;

const HEADINGS: [(Group, &str); 5] = [
    (Group::Value, "Values"),
    (Group::Part, "Parts"),
    (Group::Joint, "Joints"),
    (Group::Constraint, "Conditions"),
    (Group::Force, "Forces"),
];

/// The page as Markdown.
pub fn page() -> String {
    let mut out = String::from(INTRODUCTION);
    let _ = writeln!(out, "\n## Worlds");
    WORLDS.iter().for_each(|kind| entry(&mut out, kind));
    for (group, heading) in HEADINGS {
        let _ = writeln!(out, "\n## {heading}");
        KINDS
            .iter()
            .filter(|kind| kind.group == group)
            .for_each(|kind| entry(&mut out, kind));
    }
    units(&mut out);
    out
}

const INTRODUCTION: &str = "\
# The language

A declaration is a list of entries `name: Kind(arguments)`, in any order. Arguments marked *positional* may be given in
their order without a name; all others are `name = value`. Numbers carry units as suffixes (`0.15_m`, `9.81_m_per_s2`,
`30.0_deg`); a bare number is in SI units. `ground`, `t`, `pi`, `X` and `Y` have fixed meanings.

Expressions know `+ − * /`, `sin cos tan asin acos atan sinh cosh tanh exp ln sqrt abs sign step`, `atan2 hypot min max`,
`x.powi(2)` and `x.powf(1.5)`, vectors `[x, y]` with `dot cross norm unit` and `.x .y`, `rate(…)` for the time derivative of
an expression of positions, and `law(path, argument, …)` for functions of your own (`fn([f64; K]) -> (f64, [f64; K])`, value
and partials). Parts have `angle`, `rate`, `velocity`, the axes `x` and `y`, points (`a`, `b`, `center` of a bar; `origin`
and `center` of a body; `origin` of a particle and of the ground), `point(x, y)` in their own axes, and
`velocity_at(point)`; points have `x`, `y` and `velocity`; a coordinate has `rate`.

This page is written by the compiler's own table of kinds, and tested to be up to date.
";

fn entry(out: &mut String, kind: &Kind) {
    let _ = writeln!(out, "\n### `{}`\n\n{}\n", kind.name, kind.doc);
    let _ = writeln!(out, "| argument | takes | if left out | |");
    let _ = writeln!(out, "|---|---|---|---|");
    kind.fields.iter().for_each(|field| row(out, field));
}

fn row(out: &mut String, field: &Field) {
    let positional = if field.positional {
        " *(positional)*"
    } else {
        ""
    };
    let absent = match field.default {
        Absent::Required => "required",
        Absent::Assumed(text) => text,
    };
    let _ = writeln!(
        out,
        "| `{}`{positional} | {} | {absent} | {} |",
        field.name,
        takes(field.expects),
        field.doc
    );
}

fn takes(expects: Expects) -> String {
    let moving = "; may change with time, state and inputs";
    match expects {
        Expects::Known(dimension) => dimension.to_string(),
        Expects::KnownAny => "a number".to_owned(),
        Expects::KnownVector(dimension) => format!("[x, y], each {dimension}"),
        Expects::Moving(dimension) => format!("{dimension}{moving}"),
        Expects::MovingAny => format!("a number{moving}"),
        Expects::MovingVector(dimension) => format!("[x, y], each {dimension}{moving}"),
        Expects::Anything => "an expression or a list".to_owned(),
        Expects::Point => "a point".to_owned(),
        Expects::Part => "a part or `ground`".to_owned(),
        Expects::Axis => "`X`, `Y` or [x, y]".to_owned(),
        Expects::Frame => "`Frame([x, y], angle)`".to_owned(),
        Expects::Law => "the path of a law".to_owned(),
        Expects::Unit => "an SI unit".to_owned(),
        Expects::Flag => "`true` or `false`".to_owned(),
    }
}

fn units(out: &mut String) {
    let _ = writeln!(
        out,
        "\n## Units\n\nJoined by `_`, divided after `per`, powers as digits: `kg_m2`, `N_s_per_m`.\n"
    );
    let _ = writeln!(out, "| unit | in SI | of |");
    let _ = writeln!(out, "|---|---|---|");
    for (name, factor, dimension) in UNITS {
        let unit = if *dimension == Dimension::NONE {
            "rad".to_owned()
        } else {
            dimension.unit()
        };
        let _ = writeln!(out, "| `{name}` | {factor} {unit} | {dimension} |");
    }
}
