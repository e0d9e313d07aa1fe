//! Parameters, inputs, outputs, local coordinates and laws.

use crate::dimension::Dimension;
use crate::symbolic::Expr;
use crate::syntax::Entry;

/// A parameter, input or output.
#[derive(Debug, Clone)]
pub struct Quantity {
    /// Its name.
    pub name: String,
    /// SI unit, empty where dimensionless or not stated.
    pub unit: String,
    /// Default value; of a constant of Rust its nominal value, which is all that the compiler knows of it.
    pub default: f64,
    /// The constant of Rust that is the default value of the program.
    pub constant: Option<syn::ExprPath>,
    /// Documentation comment.
    pub doc: String,
}

/// A coordinate of a part on its own.
#[derive(Debug, Clone)]
pub struct Local {
    /// For example `crank.b.x`.
    pub name: String,
    /// SI unit.
    pub unit: String,
}

/// A state: the velocity of a coordinate that nothing depends on.
#[derive(Debug, Clone)]
pub struct ScalarState {
    /// Its name, its unit, and its initial value with the defaults of all parameters.
    pub quantity: Quantity,
    /// The coordinate whose velocity it is.
    pub local: u32,
    /// A usual size, with the defaults of all parameters, …
    pub scale: f64,
    /// … and the value whose size it is.
    pub scaled_by: Expr,
    /// Its rate.
    pub rate: Expr,
}

/// A user's law.
#[derive(Debug, Clone)]
pub struct Law {
    /// Where the function is.
    pub path: syn::Expr,
    /// The number of its arguments.
    pub arguments: usize,
}

/// The quantity that an entry declares.
pub(super) fn quantity(entry: &Entry, default: f64, dimension: Option<Dimension>) -> Quantity {
    let unit = dimension.map_or_else(String::new, Dimension::unit);
    Quantity {
        name: entry.name.to_string(),
        unit,
        default,
        constant: None,
        doc: entry.doc.clone(),
    }
}
