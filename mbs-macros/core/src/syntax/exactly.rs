//! Initial values that are held.

use syn::{Expr, Ident};

/// The kind whose first value is an initial value without a name.
pub(super) const COORDINATE: &str = "Coordinate";

/// The names of initial values.
const NAMES: [&str; 7] = [
    "angle",
    "rate",
    "at",
    "from",
    "to",
    "velocity",
    "angular_velocity",
];

/// Whether an argument of this name may be an initial value.
pub(super) fn may_be_initial(argument: &Ident) -> bool {
    NAMES.iter().any(|name| argument == name)
}

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
