//! `mbs explain --cost`: the size of each generated function.

use mbs_macros_core::emit;
use mbs_runtime::Model;

use super::table::{Align, table};

use Align::{Left, Right};

/// Operations of each function, how many of them are written out, and the statements of its Rust.
///
/// # Errors
/// A message, if the declaration has lost its meaning.
pub fn cost(model: &Model) -> Result<String, String> {
    let tokens = model.declaration.parse();
    let tokens = tokens.map_err(|_| format!("the declaration of {} is not Rust", model.name))?;
    let (Some(declaration), Ok(analysis)) = mbs_macros_core::analyse(tokens) else {
        return Err(format!("{} does not compile from its own text", model.name));
    };
    let program = &analysis.program;
    let (_, size) = emit::written(&declaration, &analysis, program);
    let mut rows = Vec::new();
    let mut totals = [0, 0];
    for function in &program.functions {
        let operations = function.operations.len();
        if operations == 0 {
            continue;
        }
        let parts = program.parts(function);
        let written = program.written(function, parts.as_ref());
        let parts = parts.map_or_else(String::new, |parts| {
            let uses: usize = parts.shapes.iter().map(|shape| shape.table.len()).sum();
            format!("{uses}, {} of them different", parts.shapes.len())
        });
        totals = [totals[0] + operations, totals[1] + written];
        rows.push([
            function.name.to_owned(),
            operations.to_string(),
            written.to_string(),
            size.of(function.name).to_string(),
            parts,
        ]);
    }
    // What is no function of the equations: constants, motion along velocities, elimination.
    for &(name, statements) in &size.functions {
        let known = program.function(name);
        if known.is_none_or(|function| function.operations.is_empty()) && statements > 0 {
            let empty = String::new;
            rows.push([
                name.to_owned(),
                empty(),
                empty(),
                statements.to_string(),
                empty(),
            ]);
        }
    }
    rows.push([
        "all".to_owned(),
        totals[0].to_string(),
        totals[1].to_string(),
        size.statements().to_string(),
        String::new(),
    ]);
    let heading = [
        ("function", Left),
        ("operations", Right),
        ("written out", Right),
        ("statements", Right),
        ("parts", Left),
    ];
    Ok(table(heading, &rows))
}
