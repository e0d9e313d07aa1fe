//! What a force element contributes.

use crate::model::elements::force::Load;
use crate::symbolic::Expr;

/// A potential energy, in two forms where one is accurate and the other short.
#[derive(Debug, Clone, Copy)]
pub(in crate::equations) struct Potential {
    /// As it is evaluated: accurate near its minimum.
    pub energy: Expr,
    /// The same function in a form whose derivatives are short.
    pub generator: Expr,
}

impl From<Expr> for Potential {
    fn from(energy: Expr) -> Potential {
        Potential {
            energy,
            generator: energy,
        }
    }
}

/// Its potential energy and its other forces, in local coordinates.
#[derive(Debug, Default)]
pub(in crate::equations) struct Action {
    /// Potential energy.
    pub potential: Option<Potential>,
    /// Forces without potential.
    pub loads: Vec<Load>,
}
