//! What a force element contributes.

use crate::model::elements::force::Load;
use crate::symbolic::Expr;

/// Its potential energy and its other forces, in local coordinates.
#[derive(Debug, Default)]
pub(in crate::equations) struct Action {
    /// Potential energy.
    pub potential: Option<Expr>,
    /// Forces without potential.
    pub loads: Vec<Load>,
}
