//! The proximal solution with a planned elimination, where rows are nearly dependent:
//!
//! ```text
//! [ M   Aᵀ ] [ δv  ]   [ 0 ]
//! [ A  −δD ] [ −δκ ] = [ r ],    D: a M⁻¹aᵀ of each row,    r: what is left of the rows
//! ```
//!
//! On rows of unit length a pass leaves the part δ/(s + δ) of r in a direction with the eigenvalue s of S = A M⁻¹Aᵀ. In a
//! direction that is lost, s ≪ δ, this is nearly all, and every pass changes κ by the same r/δ: the last change, taken back
//! from each pass, removes what was added there, and next to nothing elsewhere. With two passes the solution then is that
//! with (s/(s + δ))²/s in place of 1/s. The dense arrays have s/(s² + δ²) (`linear/proximal.rs`), with the same δ.

use crate::alf3f::sparse::{Bordered, Slots};
use crate::generated::Elimination;
use crate::linear::vector;
use crate::singular::{PASSED, PASSES, PROXIMAL, SHRINKS};
use nalgebra::SVector;

/// Passes before those that no longer shrink r count as repeated: with this number the part of r that is left in a
/// direction with s > 4 δ is less than the δ²/s² that a pass with dense arrays leaves.
const LEAST: usize = 4;

/// A v + `demand` = 0, with the entries of K.
pub(super) struct Equations<'a, const N: usize, const R: usize> {
    pub(super) plan: &'a Elimination<N, R>,
    pub(super) entries: &'a [f64],
    pub(super) demand: &'a SVector<f64, R>,
}

/// K − δD, factored.
#[derive(Clone)]
pub(super) struct PlannedProximal<const N: usize, const R: usize> {
    factor: Slots,
    /// Room for what the elimination writes beside the factor; not used.
    lengths: Slots,
    /// 1/√(a M⁻¹aᵀ), row by row.
    scale: SVector<f64, R>,
}

impl<const N: usize, const R: usize> PlannedProximal<N, R> {
    pub(super) fn new(plan: &Elimination<N, R>) -> Self {
        PlannedProximal {
            factor: vec![0.0; plan.slots].into_boxed_slice(),
            lengths: vec![0.0; plan.unknowns].into_boxed_slice(),
            scale: SVector::zeros(),
        }
    }

    /// Factors K of a matrix that has been factored without −δD, so that the lengths of its rows are known.
    #[cold]
    #[inline(never)]
    pub(super) fn factor(&mut self, plan: &Elimination<N, R>, matrix: &Bordered) {
        self.factor.copy_from_slice(&matrix.entries);
        for (&(position, slot), scale) in plan.pivots.iter().zip(self.scale.iter_mut()) {
            let length = matrix.length(position);
            let vanishes = !(length > f64::MIN_POSITIVE);
            // A row that vanishes altogether gets no multiplier: its right-hand side counts as zero.
            *scale = if vanishes { 0.0 } else { 1.0 / length.sqrt() };
            self.factor[slot] = match vanishes {
                true => -1.0,
                false => -PROXIMAL.sqrt() * length,
            };
        }
        (plan.factor)(&mut self.factor, &mut self.lengths);
    }

    /// F − ṗ|_v becomes v̇ with A v̇ + `demand` = 0, and λ.
    #[cold]
    #[inline(never)]
    pub(super) fn accelerate(
        &self,
        equations: &Equations<N, R>,
        x: &mut [f64],
        v: &mut SVector<f64, N>,
        lambda: &mut SVector<f64, R>,
    ) {
        *lambda = self.without_direction(&-equations.demand);
        (equations.plan.accelerate)(&self.factor, x, v, lambda);
        let enough = PASSED * self.size(equations.demand);
        self.iterate(equations, x, (v, lambda), enough);
    }

    /// Moves v along M⁻¹Aᵀ towards A v + `demand` = 0; adds the multipliers to κ.
    #[cold]
    #[inline(never)]
    pub(super) fn correct(
        &self,
        equations: &Equations<N, R>,
        x: &mut [f64],
        v: &mut SVector<f64, N>,
        kappa: &mut SVector<f64, R>,
    ) {
        let rest = self.rest(equations, v);
        let enough = PASSED * self.size(&rest);
        (equations.plan.solve)(&self.factor, &rest, x, v, kappa);
        self.iterate(equations, x, (v, kappa), enough);
    }

    /// The passes after the first one.
    fn iterate(
        &self,
        equations: &Equations<N, R>,
        x: &mut [f64],
        (v, kappa): (&mut SVector<f64, N>, &mut SVector<f64, R>),
        enough: f64,
    ) {
        let solve = equations.plan.solve;
        let mut last = f64::INFINITY;
        for pass in 2..=PASSES {
            let rest = self.rest(equations, v);
            let size = self.size(&rest);
            if size <= enough {
                return;
            }
            let (mut change, mut multipliers) = (SVector::zeros(), SVector::zeros());
            solve(&self.factor, &rest, x, &mut change, &mut multipliers);
            let repeats = pass >= LEAST && !(size < SHRINKS * last);
            // The last pass is itself one of those that it is taken back from.
            let part = match repeats || pass == PASSES {
                true => 1.0 - pass as f64,
                false => 1.0,
            };
            v.axpy(part, &change, 1.0);
            kappa.axpy(part, &multipliers, 1.0);
            if repeats {
                return;
            }
            last = size;
        }
    }

    /// −(A v + `demand`).
    fn rest(&self, equations: &Equations<N, R>, v: &SVector<f64, N>) -> SVector<f64, R> {
        let mut rates = SVector::zeros();
        (equations.plan.rates)(equations.entries, v, &mut rates);
        self.without_direction(&vector(|i| -(rates[i] + equations.demand[i])))
    }

    fn without_direction(&self, rest: &SVector<f64, R>) -> SVector<f64, R> {
        vector(|i| if self.scale[i] > 0.0 { rest[i] } else { 0.0 })
    }

    /// The largest entry on rows of unit length.
    fn size(&self, rest: &SVector<f64, R>) -> f64 {
        (0..R).fold(0.0, |most, i| most.max((self.scale[i] * rest[i]).abs()))
    }
}
