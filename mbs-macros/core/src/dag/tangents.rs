//! The tangents of F and f as one function.
//!
//! In space, if M is constant, they differ by the gyroscopic terms of free bodies only. Where both are long, their code
//! is the same, and each method writes its own outputs.

use super::functions::matrix;
use super::likeness::Likeness;
use super::lower::{Hoisted, Lowering};
use super::{Function, Output};
use crate::derivatives::Derived;
use crate::symbolic::Graph;

/// The name of the function.
pub const ALL_TANGENTS: &str = "all_tangents";
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
