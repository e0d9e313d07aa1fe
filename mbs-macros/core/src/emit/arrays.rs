//! Families whose members have values of different shapes: they cannot be an array of the program.

use super::fields::{Content, Field, fields};
use crate::analysis::Analysis;
use crate::syntax::Declaration;
use proc_macro2::Ident;

/// Families of assemblies whose members have other values than the first one, and what these values are.
pub fn uneven_families(
    declaration: &Declaration,
    analysis: &Analysis,
) -> Vec<(Ident, &'static str)> {
    let outline = &analysis.outline;
    let mut uneven = Vec::new();
    for (what, list) in [
        ("parameters", &outline.parameters),
        ("inputs", &outline.inputs),
        ("outputs", &outline.outputs),
    ] {
        note(&fields(declaration, list), what, &mut uneven);
    }
    uneven
}

fn note(fields: &[Field], what: &'static str, uneven: &mut Vec<(Ident, &'static str)>) {
    for field in fields {
        if field.has_other_members() {
            uneven.push((field.name.clone(), what));
            continue;
        }
        for content in field.contents() {
            if let Content::Assembly(_, inside) = content {
                note(inside, what, uneven);
            }
        }
    }
}
