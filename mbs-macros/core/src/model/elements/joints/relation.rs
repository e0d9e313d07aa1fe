//! Two scalars that keep a linear relation.

use crate::symbolic::{Expr, Graph};

/// second − ratio · first − offset
pub(super) fn affine(
    graph: &mut Graph,
    first: Expr,
    second: Expr,
    ratio: Expr,
    offset: Expr,
) -> Expr {
    let driven = graph.mul(ratio, first);
    let difference = graph.sub(second, driven);
    graph.sub(difference, offset)
}
