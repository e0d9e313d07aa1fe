//! F and f, and their tangents, where they share their code.
//!
//! In space, if M is constant, they differ by the gyroscopic terms of free bodies only. Where they are long, F is f and
//! these terms, and the tangents of both are one function of which each method writes its own outputs.

use super::functions::matrix;
use super::likeness::Likeness;
use super::lower::{Hoisted, Lowering};
use super::{Function, Output, Place};
use crate::derivatives::Derived;
use crate::symbolic::Graph;

/// The name of the function.
pub const ALL_TANGENTS: &str = "all_tangents";
/// The name of the terms of F that f has not.
pub const TURNING: &str = "turning";
/// Outputs of f, by the names that they have beside those of F, and by their own.
const APPLIED: [(&str, &str); 2] = [("applied_q", "f_q"), ("applied_v", "f_v")];

/// The function, if both are long and not the same.
pub(super) fn all_tangents(
    graph: &mut Graph,
    hoisted: &mut Hoisted,
    likeness: &Likeness,
    derived: &Derived,
    functions: &[Function],
) -> Option<Function> {
    let long = |name: &str| {
        let mut long = functions.iter().filter(|function| function.is_long());
        long.find(|function| function.name == name)
    };
    let (total, applied) = (long("force_tangents")?, long("applied_force_tangents")?);
    if !derived.constant_mass || total.computes_the_same(applied) {
        return None;
    }
    let mut code = Lowering::new(graph, hoisted).with_likeness(Some(likeness));
    matrix(&mut code, "f_q", &derived.total.by_position);
    matrix(&mut code, "f_v", &derived.total.by_velocity);
    matrix(&mut code, "p_q", &derived.momentum_by_position);
    matrix(&mut code, APPLIED[0].0, &derived.applied.by_position);
    matrix(&mut code, APPLIED[1].0, &derived.applied.by_velocity);
    Some(code.finish(ALL_TANGENTS))
}

/// Longer forces are not written out twice.
const LONGEST: usize = 1000;

/// p × ω, the difference of F and f where M is constant, if f is long.
pub(super) fn turning(
    graph: &mut Graph,
    hoisted: &mut Hoisted,
    derived: &Derived,
    functions: &[Function],
) -> Option<Function> {
    let mut forces = functions.iter();
    let forces = forces.find(|function| function.name == "forces")?;
    let turns = derived
        .turning
        .iter()
        .any(|&x| !derived.system.graph.is_zero(x));
    if !derived.constant_mass || !turns || forces.operations.len() < LONGEST {
        return None;
    }
    let mut code = Lowering::new(graph, hoisted);
    for (i, &value) in derived.turning.iter().enumerate() {
        if !derived.system.graph.is_zero(value) {
            code.output(TURNING, Place::Element(i), value);
        }
    }
    Some(code.finish(TURNING))
}

/// An output of the function as one of the tangents of F or f; `None` if it belongs to the other.
pub fn of_tangents(function: &Function, output: &Output) -> Option<Output> {
    let of_applied = APPLIED.iter().find(|(name, _)| *name == output.sink);
    match (function.name, of_applied) {
        ("applied_force_tangents", of_applied) => {
            let (_, sink) = *of_applied?;
            Some(Output { sink, ..*output })
        }
        (_, Some(_)) => None,
        _ => Some(*output),
    }
}
