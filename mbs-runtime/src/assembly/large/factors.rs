//! The factors of a start: of the elimination that was planned when the mechanism was compiled, or of [M −Aᵀ; A εD].

use crate::alf3f::sparse::{Bordered, Rows, Slots};
use crate::generated::Elimination;
#[cfg(feature = "sparse")]
use crate::linear::sparse::Saddle;
use crate::linear::sparse::{Entries, SparseRows};
use crate::linear::{finite, vector, zeros};
use crate::singular::Thresholds;
use nalgebra::SVector;

pub(super) enum Factors<const N: usize, const R: usize> {
    Planned {
        plan: &'static Elimination<N, R>,
        matrix: Box<Bordered>,
        x: Slots,
    },
    #[cfg(feature = "sparse")]
    Saddle { saddle: Box<Saddle>, x: Vec<f64> },
}

impl<const N: usize, const R: usize> Factors<N, R> {
    pub(super) fn planned(plan: &'static Elimination<N, R>, mass: &SparseRows) -> Self {
        Factors::Planned {
            plan,
            matrix: Box::new(Bordered::new(plan, mass, Thresholds::SECOND_ORDER)),
            x: vec![0.0; plan.unknowns].into_boxed_slice(),
        }
    }

    /// `None` if the pattern is singular.
    #[cfg(feature = "sparse")]
    pub(super) fn new(mass: &Entries, a: &Entries) -> Option<Self> {
        Some(Factors::Saddle {
            saddle: Box::new(Saddle::new([N, R], mass, a, std::iter::empty())?),
            x: vec![0.0; N + R],
        })
    }

    /// None, whatever the mechanism.
    #[cfg(not(feature = "sparse"))]
    pub(super) fn new(_: &Entries, _: &Entries) -> Option<Self> {
        None
    }

    /// The array of K, where A has to be written, too.
    pub(super) fn planned_entries(&mut self) -> Option<&mut [f64]> {
        match self {
            Factors::Planned { matrix, .. } => Some(&mut matrix.entries),
            #[cfg(feature = "sparse")]
            Factors::Saddle { .. } => None,
        }
    }

    /// Factors the matrix with the first `rows` rows; the multipliers of the others are zero. (A start is planned
    /// only where all rows are holonomic, and no caller leaves one out.) False if it is singular, or where rows are nearly
    /// dependent.
    pub(super) fn factor(&mut self, _entries: (&Entries, &Entries), _rows: usize) -> bool {
        match self {
            Factors::Planned { plan, matrix, .. } => {
                matrix.factor(plan);
                matrix.rows(plan) != Rows::Lost
            }
            #[cfg(feature = "sparse")]
            Factors::Saddle { saddle, .. } => {
                let (mass, a) = _entries;
                saddle.begin(mass, a);
                saddle.add_rows(a, 0.._rows);
                saddle.lu.factor()
            }
        }
    }

    /// The change of least kinetic energy that changes the rows by these values; `None` if it is not finite.
    pub(super) fn way(&mut self, rows: impl Fn(usize) -> f64) -> Option<SVector<f64, N>> {
        match self {
            Factors::Planned { plan, matrix, x } => {
                let mut way = zeros();
                matrix.solve(plan, &vector(rows), x, (&mut way, &mut zeros()));
                finite(&way).then_some(way)
            }
            #[cfg(feature = "sparse")]
            Factors::Saddle { saddle, x } => {
                let (velocities, multipliers) = x.split_at_mut(N);
                velocities.fill(0.0);
                for (i, x) in multipliers.iter_mut().enumerate() {
                    *x = rows(i);
                }
                let solved = saddle.lu.solve(x);
                solved.then(|| SVector::from_column_slice(&x[..N]))
            }
        }
    }
}
