//! The verdict on a start.

use super::changes;
use crate::linear::{Dependence, dot, largest, vector};
use crate::row_scale::RowScale;
use crate::sink::Diagonal;
use crate::{AssemblyVerdict, Change, Model, System};
use nalgebra::SVector;

/// Violation of a row, as a displacement relative to the size of the mechanism, above which a guess counts as not assembled.
pub(super) const ASSEMBLED: f64 = 1e-9;

/// What assembly moved.
pub(super) fn moved<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    [guess, q]: [&SVector<f64, Q>; 2],
    [declared, v]: [&SVector<f64, N>; 2],
    length: f64,
) -> Vec<Change> {
    let (before, after) = (guess.as_slice(), q.as_slice());
    let mut changes = changes::changes(S::MODEL.coordinates, before, after, length);
    let (before, after) = (declared.as_slice(), v.as_slice());
    changes.extend(changes::changes(S::MODEL.velocities, before, after, length));
    changes
}

/// The verdict on the pose q, reached from `guess`.
pub(super) fn judge<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    rows: Dependence,
    (phi, scale): (&SVector<f64, R>, &RowScale<R>),
    residual_before: f64,
    [guess, q]: [&SVector<f64, Q>; 2],
) -> AssemblyVerdict {
    let mut change = SVector::zeros();
    let way = system.difference(guess, q);
    system.momentum(q, &way, &mut change);
    let moved = dot(&change, &way).max(0.0);
    let mut mass = Diagonal::<N>::zeros();
    system.mass_matrix(q, &mut mass);
    let total: f64 = mass.0.iter().sum();
    let displacements: SVector<f64, R> = vector(|i| scale.displacement_of(i, phi[i]));
    let worst = worst_rows(S::MODEL, displacements.as_slice(), scale.tolerance);
    AssemblyVerdict {
        residual_before,
        residual: largest(phi),
        moved: if total > 0.0 {
            (moved / total).sqrt()
        } else {
            0.0
        },
        rank: rows.rank,
        redundant_rows: names(S::MODEL, &rows.dependent),
        worst_rows: worst.iter().map(|&(i, name)| (name, phi[i])).collect(),
        changes: Vec::new(),
    }
}

/// The holonomic rows that are farthest from satisfied, the worst first. (Not generic: compiled once.)
fn worst_rows(model: &Model, displacements: &[f64], tolerance: f64) -> Vec<(usize, &'static str)> {
    let displacements = displacements.iter().copied().zip(model.rows);
    let mut worst: Vec<_> = displacements
        .enumerate()
        .take(model.structure.holonomic_rows)
        .collect();
    worst.sort_by(|a, b| b.1.0.total_cmp(&a.1.0));
    worst.retain(|(_, (displacement, _))| *displacement > tolerance);
    worst.truncate(8);
    worst.iter().map(|(i, (_, row))| (*i, row.name)).collect()
}

/// The names of these rows.
fn names(model: &Model, rows: &[usize]) -> Vec<&'static str> {
    rows.iter()
        .filter_map(|&i| Some(model.rows.get(i)?.name))
        .collect()
}
