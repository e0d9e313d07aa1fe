//! Small dense kernels on fixed-size arrays, and elimination without zeros. None allocates; all accept size 0.

mod delassus_factor;
mod pivoted;
mod projection_lu;
mod proximal;
mod rank;
mod rank_margin;
mod sparse;
mod thresholds;
mod vector;

pub(crate) use delassus_factor::DelassusFactor;
pub(crate) use pivoted::Pivoted;
pub(crate) use projection_lu::ProjectionLu;
pub(crate) use rank::{Dependence, dependence};
pub(crate) use rank_margin::RankMargin;
pub(crate) use sparse::{Bordered, Pair, Rows, Slots, SparseMass, constant_mass};
pub(crate) use thresholds::Thresholds;
pub(crate) use vector::{accumulate, dot, finite, largest};

/// A matrix of fixed size on the heap: large systems are built on small stacks.
pub(crate) type Matrix<const ROWS: usize, const COLUMNS: usize> = Box<[[f64; COLUMNS]; ROWS]>;

/// A matrix of zeros, which never was on the stack.
pub(crate) fn clear<const ROWS: usize, const COLUMNS: usize>() -> Matrix<ROWS, COLUMNS> {
    match vec![[0.0; COLUMNS]; ROWS].into_boxed_slice().try_into() {
        Ok(matrix) => matrix,
        Err(_) => unreachable!("the vector has as many rows as the array"),
    }
}

/// ε of the proximal solve on rows of unit length: 1/ξ² for the penalty ξ = 1e7 of the augmented Lagrangian.
const PROXIMAL: f64 = 1e-14;

/// A pivot below this fraction calls for an iteration on the residual.
const WEAK_PIVOT: f64 = 1e-3;

/// From this size on, a branch that skips a zero is cheaper than the row operation it saves.
const SPARSE_FROM: usize = 16;
