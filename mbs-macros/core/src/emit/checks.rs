//! The checks of arguments that follow from parameters, in `prepare`.

use super::body::Body;
use crate::dag::Function;
use crate::equations::System;
use crate::model::Wanted;
use std::collections::HashSet;
use std::fmt::Write;

/// The statements, with the type of the equations; members of a family with the same value are checked once.
pub(super) fn emit(system: &System, checks: &Function, equations: &str) -> String {
    let body = Body::of_preparation(&system.graph, checks, equations);
    let mut out = body.statements();
    let mut values = body.values().into_iter();
    let mut known = HashSet::new();
    for requirement in &system.requirements {
        let own: Vec<String> = values.by_ref().take(requirement.values.len()).collect();
        let own = own.join(", ");
        let argument = &requirement.argument;
        let (function, rest) = match requirement.wanted {
            Wanted::NotNegative => ("require_not_negative", format!("{argument:?}, {own}")),
            Wanted::Positive(words) => (
                "require_positive",
                format!("{argument:?}, {own}, {words:?}"),
            ),
            Wanted::Inertia => ("require_inertia", format!("[{own}]")),
        };
        if known.insert((function, rest.clone())) {
            let entry = &requirement.entry;
            let _ = writeln!(
                out,
                "::mbs_runtime::generated::{function}({entry:?}, {rest})?;"
            );
        }
    }
    out
}
