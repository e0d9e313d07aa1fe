//! The iteration that closes the rows of a step: residual, factor, solve, and the verdict on what is left.
//!
//! It is the same for kicks with dense and with sparse factors, with nonholonomic rows, for the implicit step and for the
//! baselines that close rows; they differ in what a residual, a factor and a correction are.

use crate::fault::Fault;
use crate::singular::{STAGNATED, STALLED};
use nalgebra::SVector;

/// Equations of rows that corrections through a factor satisfy.
pub(crate) trait Closing {
    /// Corrections by a factor at hand that are cheaper than another factor.
    const PATIENCE: i32 = 1;
    /// Whether velocities are sought with the multipliers: then the last word is that of [`Self::solve`].
    const VELOCITIES: bool = false;

    /// Evaluates the rows where the unknowns are: Σ (φ_i/tolerance_i)².
    fn residual(&mut self) -> Result<f64, Fault>;
    /// Factors the matrix of the corrections there; false where a row has lost its direction, and others have to do the step.
    fn factor(&mut self) -> Result<bool, Fault>;
    /// One correction. Whether velocities have settled.
    fn solve(&mut self) -> bool;
    /// What `residual` to ask for, 1 at most.
    fn enough(&self) -> f64 {
        1.0
    }
    /// The residual that is taken when a new factor does not reduce it: round-off, or a row without a direction.
    fn round_off(&self) -> f64 {
        STAGNATED
    }
    /// Whether the factor has to be renewed in any case.
    fn is_stale(&self) -> bool {
        false
    }
    /// The failure to report. (Inline, and with copies of unknowns: those whose address is known elsewhere do not stay in
    /// registers.)
    fn fault(&self, iterations: usize) -> Fault;
}

/// How long to iterate.
#[derive(Clone, Copy)]
pub(crate) struct Limits {
    pub(crate) most: usize,
    /// Exactly so many corrections, through one factor.
    pub(crate) fixed: Option<usize>,
}

/// Where the iteration ended.
pub(crate) struct Closed {
    /// Residual.
    pub(crate) left: f64,
    pub(crate) iterations: usize,
}

/// Corrects the unknowns until the rows are closed; `None` where a row has lost its direction.
///
/// `factored`: whether there is a factor to begin with.
#[inline(always)]
pub(crate) fn close<C: Closing>(
    rows: &mut C,
    limits: Limits,
    mut factored: bool,
) -> Result<Option<Closed>, Fault> {
    let mut last = f64::INFINITY;
    let mut iterations = 0;
    let mut fresh = false;
    loop {
        let residual = rows.residual()?;
        let closed = Closed {
            left: residual,
            iterations,
        };
        match limits.fixed {
            None if !C::VELOCITIES
                && residual <= 1.0
                && (residual <= rows.enough()
                    || residual >= STALLED * last
                    || iterations >= limits.most) =>
            {
                return Ok(Some(closed));
            }
            Some(count) if iterations == count && residual.is_finite() => return Ok(Some(closed)),
            _ => {}
        }
        // Where the corrections that another factor costs would not do at the present rate.
        let slow = !(residual.powi(C::PATIENCE + 1) <= last.powi(C::PATIENCE) || residual <= 1.0);
        let slow = slow && iterations > 0 && (limits.fixed.is_none() || !residual.is_finite());
        if !factored || slow || rows.is_stale() {
            if fresh && !C::VELOCITIES && has_stalled(rows, residual, last) {
                return Ok(Some(closed));
            }
            if (iterations >= limits.most && limits.fixed.is_none()) || !residual.is_finite() {
                return Err(rows.fault(iterations));
            }
            if !rows.factor()? {
                return Ok(None);
            }
            (factored, fresh) = (true, true);
        } else {
            fresh = false;
        }
        if rows.solve() && C::VELOCITIES && (residual <= 1.0 || has_stalled(rows, residual, last)) {
            return Ok(Some(closed));
        }
        last = residual;
        iterations += 1;
    }
}

/// Whether a correction has left what is round-off.
#[inline(always)]
fn has_stalled(rows: &impl Closing, residual: f64, last: f64) -> bool {
    residual > STALLED * last && residual < rows.round_off()
}

/// Velocity rows on which corrections through a nearly singular factor are repeated.
pub(crate) trait Refining {
    /// Σ ((A v + b)_i/tolerance_i)².
    fn residual(&mut self) -> f64;
    /// One correction of v and its multipliers.
    fn correct(&mut self);
}

/// Iterates on what a solve leaves of A v + b: the proximal one leaves a part of all that lies in nearly lost directions,
/// elimination some digits. Ends at `enough`, or where a correction no longer helps.
#[inline(always)]
pub(crate) fn refine(rows: &mut impl Refining, passes: usize, enough: f64) {
    let mut last = f64::INFINITY;
    for _ in 0..passes {
        let residual = rows.residual();
        if residual <= enough || residual > STALLED * last {
            return;
        }
        last = residual;
        rows.correct();
    }
}

/// Σ φ_i² / tolerance_i²: one at most where every row is within its tolerance and their sum is; NaN if any row is.
#[inline(always)]
pub(crate) fn residual_of<const R: usize>(phi: &SVector<f64, R>, weights: &SVector<f64, R>) -> f64 {
    let mut sum = 0.0;
    for i in 0..R {
        sum += phi[i] * phi[i] * weights[i];
    }
    sum
}

#[cold]
#[inline(never)]
pub(crate) fn not_converged<const R: usize>(
    phi: &SVector<f64, R>,
    weights: &SVector<f64, R>,
    iterations: usize,
) -> Fault {
    let mut row = 0;
    for i in 0..R {
        let size = |i: usize| phi[i] * phi[i] * weights[i];
        if !(size(i) <= size(row)) {
            row = i;
        }
    }
    match phi.get(row) {
        Some(residual) if !residual.is_finite() => Fault::NonFinite("constraint rows"),
        residual => Fault::Row {
            row,
            residual: residual.copied().unwrap_or(0.0),
            iterations,
        },
    }
}
