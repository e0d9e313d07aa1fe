//! How much Rust a mechanism may become.

use crate::diagnostics::{Errors, Place};
use crate::syntax::Declaration;
use syn::{Expr, ExprLit, Lit};

/// Statements, where the world names no others: rustc needs about a minute for them.
const USUAL: usize = 100_000;

/// The `budget =` of the world.
pub fn budget(declaration: &Declaration, errors: &mut Errors) -> usize {
    let world = declaration.world.as_ref();
    let Some(argument) = world.and_then(|world| world.named("budget")) else {
        return USUAL;
    };
    if let Expr::Lit(ExprLit {
        lit: Lit::Int(number),
        ..
    }) = &argument.value
        && let (Ok(budget), "") = (number.base10_parse(), number.suffix())
    {
        return budget;
    }
    let place = Place::of(&argument.value);
    errors.at(
        place,
        format!("expected a whole number of statements, such as {USUAL}"),
    );
    USUAL
}
