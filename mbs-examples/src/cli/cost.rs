//! `mbs explain --cost`: the size of each generated function.

use mbs_runtime::Model;

use super::table::{Align, table};

use Align::{Left, Right};

/// Operations of each function, and how many of them are written out.
///
/// # Errors
/// A message, if the declaration has lost its meaning.
pub fn cost(model: &Model) -> Result<String, String> {
    let tokens = model.declaration.parse();
    let tokens = tokens.map_err(|_| format!("the declaration of {} is not Rust", model.name))?;
    let (_, Ok(analysis)) = mbs_macros_core::analyse(tokens) else {
        return Err(format!("{} does not compile from its own text", model.name));
    };
    let program = &analysis.program;
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
            parts,
        ]);
    }
    rows.push([
        "all".to_owned(),
        totals[0].to_string(),
        totals[1].to_string(),
        String::new(),
    ]);
    let heading = [
        ("function", Left),
        ("operations", Right),
        ("written out", Right),
        ("parts", Left),
    ];
    Ok(table(heading, &rows))
}
