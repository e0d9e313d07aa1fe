//! The constraint rows that depend on others, for the verdict of assembly; not used in steps.

use super::{add_scaled, dot};
use crate::singular::NOTHING;
use nalgebra::SVector;

/// The numerical rank of A, and the rows that depend on those above them.
pub(crate) struct Dependence {
    pub(crate) rank: usize,
    pub(crate) dependent: Vec<usize>,
}

/// Gram–Schmidt on the rows of A in the metric M⁻¹, in declared order; `w` holds M⁻¹Aᵀ row by row.
///
/// Working on the rows instead of on A M⁻¹ Aᵀ keeps all digits: lengths are not squared before they are compared.
pub(crate) fn dependence<const N: usize, const R: usize>(
    a: &[SVector<f64, N>; R],
    w: &[SVector<f64, N>; R],
    vanishes: impl Fn(usize) -> bool,
) -> Dependence {
    let mut basis: Vec<(SVector<f64, N>, SVector<f64, N>)> = Vec::with_capacity(R);
    let mut dependent = Vec::new();
    for i in 0..R {
        let (mut row, mut lifted) = (a[i], w[i]);
        let length = dot(&row, &lifted).max(0.0).sqrt();
        // The second pass restores the orthogonality that the first loses by cancellation.
        for _ in 0..2 {
            for (unit, unit_lifted) in &basis {
                let component = dot(&row, unit_lifted);
                add_scaled(&mut row, -component, unit);
                add_scaled(&mut lifted, -component, unit_lifted);
            }
        }
        let left = dot(&row, &lifted).max(0.0).sqrt();
        if left > NOTHING * length && !vanishes(i) {
            basis.push((row / left, lifted / left));
        } else {
            dependent.push(i);
        }
    }
    Dependence {
        rank: basis.len(),
        dependent,
    }
}
