//! Initial values that are held.

use syn::Expr;

/// The value inside `Exactly(…)`.
pub fn exactly(syntax: &Expr) -> Option<&Expr> {
    match syntax {
        Expr::Group(group) => exactly(&group.expr),
        Expr::Call(call) if call.args.len() == 1 => match &*call.func {
            Expr::Path(path) if path.path.is_ident("Exactly") => call.args.first(),
            _ => None,
        },
        _ => None,
    }
}
