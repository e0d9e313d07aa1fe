//! The error about a mechanism whose generated code is larger than the budget of its world.

use crate::analysis::Analysis;
use crate::dag::ALL_TANGENTS;
use crate::diagnostics::{Errors, Failure};
use crate::emit::Size;
use crate::model;
use crate::syntax::Declaration;

/// About what rustc takes for a statement in release, by the mechanisms of the page on compile times, and bytes beside those that it
/// takes for any crate.
const SECONDS: f64 = 0.6e-3;
const BYTES: [f64; 2] = [2e8, 1e4];
/// The most names in a message.
const MOST_NAMES: usize = 3;

/// More statements than the budget.
///
/// # Errors
/// The size of the mechanism, what dominates it, and what rustc would need.
pub(crate) fn check(
    declaration: &Declaration,
    analysis: &Analysis,
    size: &Size,
) -> Result<(), Failure> {
    let mut errors = Errors::new();
    let (budget, statements) = (model::budget(declaration, &mut errors), size.statements());
    if statements > budget {
        let (function, most) = size.largest().unwrap_or_default();
        let program = &analysis.program;
        let about = match function == ALL_TANGENTS {
            true => program.all_tangents.as_ref(),
            false => program.function(function),
        };
        let about = about.map_or_else(String::new, |function| {
            about_names(&program.dominant(function))
        });
        let (seconds, memory) = (
            SECONDS * statements as f64,
            BYTES[0] + BYTES[1] * statements as f64,
        );
        let formulation = analysis.outline.formulation.name();
        errors.at(
            declaration.name.span(),
            format!(
                "`{}` is too large: what is generated has {statements} statements, the budget is {budget}; in release rustc would take about {} s and {:.1} GB; the largest function is `{function}` with {most} statements{about}; use other coordinates (these are `{formulation}`) or fewer parts, or write a larger `budget =` in the world",
                declaration.name,
                seconds.ceil(),
                memory / 1e9,
            ),
        );
    }
    errors.stop_if_any()
}

fn about_names(names: &[&str]) -> String {
    let shown: Vec<String> = names
        .iter()
        .take(MOST_NAMES)
        .map(|name| format!("`{name}`"))
        .collect();
    let others = names.len().saturating_sub(MOST_NAMES);
    match (shown.is_empty(), others) {
        (true, _) => String::new(),
        (false, 0) => format!(", most of them about {}", shown.join(", ")),
        (false, _) => format!(
            ", most of them about {} and {others} others",
            shown.join(", ")
        ),
    }
}
