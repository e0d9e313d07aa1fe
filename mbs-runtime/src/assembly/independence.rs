//! Which rows depend on others at a pose.

use crate::System;
use crate::constraint_geometry::ConstraintGeometry;
use crate::linear::{Dependence, dependence};
use crate::row_scale::RowScale;
use crate::singular::NOTHING;
use crate::yardstick::Yardstick;

/// The rows that do not depend on others. A row that is zero except for round-off is dependent.
pub(crate) fn independent_rows<
    S: System<Q, N, R>,
    const Q: usize,
    const N: usize,
    const R: usize,
>(
    _: &S,
    geometry: &ConstraintGeometry<S, Q, N, R>,
    yardstick: &Yardstick<Q, N>,
) -> Dependence {
    dependence(geometry.a.rows(), geometry.w.rows(), |i| {
        vanishes(geometry, yardstick, i)
    })
}

/// Whether a row is zero except for round-off.
pub(crate) fn vanishes<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    geometry: &ConstraintGeometry<S, Q, N, R>,
    yardstick: &Yardstick<Q, N>,
    row: usize,
) -> bool {
    let expected = RowScale::<R>::expected::<S, Q, N>(row, yardstick.length);
    yardstick.row_length_squared(&geometry.a[row]) <= (NOTHING * expected).powi(2)
}
