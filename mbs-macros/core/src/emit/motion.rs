//! Motion along velocities: `advance`, `difference` and `free_flight`, which depend on the positions of
//! rotations in q and v.

use super::body::Body;
use crate::dag::{Function, Program};
use crate::symbolic::Graph;
use std::fmt::Write;

/// The body of one of them.
pub(super) fn body(graph: &Graph, program: &Program, name: &str) -> String {
    let plain = program.rotations.is_empty() && program.unwrapped_angles.is_empty();
    match (name, plain) {
        ("advance", true) => "::mbs_runtime::generated::translated(q, v, h)".to_owned(),
        ("difference", true) => "::mbs_runtime::generated::displacement(from, to)".to_owned(),
        (_, true) => "*q = self.advance(q, v, h);".to_owned(),
        ("advance", false) => advance(graph, program),
        ("difference", false) => difference(program),
        (_, false) => free_flight(graph, program),
    }
}

fn advance(graph: &Graph, program: &Program) -> String {
    format!(
        "{}let mut next = *q;\n{}{}{}::core::convert::Into::into(next)",
        predicted(graph, program),
        translations(program, |slot, i| format!(
            "next[{slot}] = q[{slot}] + h * v[{i}];"
        )),
        rotations(program, |_, q, v| format!(
            "[{}] = ::mbs_runtime::generated::turned([{}], [{}], h);",
            elements("next", q, 4),
            elements("q", q, 4),
            elements("v", v, 3)
        )),
        count(graph, program, "next"),
    )
}

fn difference(program: &Program) -> String {
    format!(
        "let mut v = [0.0; {}];\n{}{}::core::convert::Into::into(v)",
        program.size,
        translations(program, |slot, i| format!(
            "v[{i}] = to[{slot}] - from[{slot}];"
        )),
        rotations(program, |_, q, v| format!(
            "[{}] = ::mbs_runtime::generated::rotation_between([{}], [{}]);",
            elements("v", v, 3),
            elements("from", q, 4),
            elements("to", q, 4)
        )),
    )
}

fn free_flight(graph: &Graph, program: &Program) -> String {
    format!(
        "{}{}{}{}",
        predicted(graph, program),
        translations(program, |slot, i| format!("q[{slot}] += h * v[{i}];")),
        rotations(program, |index, q, v| format!(
            "([{}], [{}]) = self.spins[{index}].flight([{}], [{}], h);",
            elements("q", q, 4),
            elements("v", v, 3),
            elements("q", q, 4),
            elements("v", v, 3)
        )),
        count(graph, program, "q"),
    )
}

/// One line for each velocity that is the rate of a coordinate: (coordinate, velocity).
fn translations(program: &Program, line: impl Fn(usize, usize) -> String) -> String {
    let turns = |i: usize| {
        program
            .rotations
            .iter()
            .any(|rotation| (rotation.velocity..rotation.velocity + 3).contains(&i))
    };
    (0..program.size)
        .filter(|&i| !turns(i))
        .fold(String::new(), |text, i| {
            text + &line(program.slots[i], i) + "\n"
        })
}

/// One line for each rotation: (index, first coordinate, first velocity).
fn rotations(program: &Program, line: impl Fn(usize, usize, usize) -> String) -> String {
    let list = program.rotations.iter().enumerate();
    list.fold(String::new(), |text, (index, rotation)| {
        text + &line(index, rotation.coordinate, rotation.velocity) + "\n"
    })
}

/// The angles where rotations and coordinates that are angles lead them, from which they are counted: a free body may turn many times
/// in a step. Empty if neither changes them.
fn predicted(graph: &Graph, program: &Program) -> String {
    let Some([statements, rates]) = array(graph, program, "unwrapped_rates", "rates") else {
        return String::new();
    };
    let slots = program.unwrapped_angles.iter();
    let angles: Vec<String> = slots.map(|slot| format!("q[{slot}]")).collect();
    format!(
        "let turned = {{ {statements} let (angles, rates) = ([{}], [{rates}]); \
         ::core::array::from_fn::<f64, {}, _>(|i| angles[i] + h * rates[i]) }};\n",
        angles.join(", "),
        angles.len()
    )
}

/// Joint angles are counted from their last values, or from where [`predicted`] leads these.
fn count(graph: &Graph, program: &Program, q: &str) -> String {
    let Some([statements, angles]) = array(graph, program, "unwrapped_angles", "angles") else {
        return String::new();
    };
    let targets: Vec<String> = program
        .unwrapped_angles
        .iter()
        .map(|slot| format!("{q}[{slot}]"))
        .collect();
    let targets = targets.join(", ");
    let predicted = match function(program, "unwrapped_rates") {
        Some(_) => format!("[{targets}] = turned;\n"),
        None => String::new(),
    };
    format!("{predicted}[{targets}] = {{ let q = &{q}; {statements} [{angles}] }};\n")
}

/// Statements and values of a function that gives an array; `None` if the mechanism does not have it.
fn array(
    graph: &Graph,
    program: &Program,
    name: &str,
    values: &'static str,
) -> Option<[String; 2]> {
    let renamed = Function {
        name: values,
        ..function(program, name)?.clone()
    };
    let body = Body::of_method(graph, &renamed);
    Some([body.statements(), body.values().join(", ")])
}

fn function<'a>(program: &'a Program, name: &str) -> Option<&'a Function> {
    let mut functions = program.functions.iter();
    functions.find(|function| function.name == name)
}

/// `q[3], q[4], …`.
fn elements(array: &str, first: usize, count: usize) -> String {
    let list: Vec<String> = (first..first + count)
        .map(|i| format!("{array}[{i}]"))
        .collect();
    list.join(", ")
}

/// The lines of `prepare` that make the spins; inertias are entries of the mass matrix, in constants.
pub(super) fn spins(program: &Program, operand: impl Fn(crate::dag::Operand) -> String) -> String {
    let list: Vec<String> = program
        .rotations
        .iter()
        .map(|rotation| {
            let rows: Vec<String> = rotation
                .inertia
                .iter()
                .map(|row| format!("[{}]", row.map(&operand).join(", ")))
                .collect();
            format!(
                "::mbs_runtime::generated::Spin::new(&[{}], {:?})?",
                rows.join(", "),
                rotation.part
            )
        })
        .collect();
    let mut out = String::new();
    let _ = writeln!(out, "let spins = [{}];", list.join(", "));
    out
}
