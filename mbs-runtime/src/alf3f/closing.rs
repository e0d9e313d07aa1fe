//! The iteration that solves the rows of a step: residual, factor, correction, and the decision on the residual.
//!
//! It is the same for kicks with dense and with sparse factors, with nonholonomic rows, for the implicit step and for
//! the baselines that iterate on rows; they differ in residual, factor and correction.

#[cfg(not(feature = "std"))]
use crate::elementary::Elementary as _;
use crate::fault::Fault;
use crate::linear::entries;
use crate::singular::{STAGNATED, STALLED};
use nalgebra::SVector;

/// Rows that are solved by corrections with a factor.
pub(crate) trait Closing {
    /// The number of corrections with the present factor that cost less than a new factor.
    const PATIENCE: i32 = 1;
    /// Whether velocities are unknowns besides the multipliers: then [`Self::solve`] decides on the end of the
    /// iteration.
    const VELOCITIES: bool = false;
    /// The number of corrections from which on the residuals tell how fast they decrease.
    const TELLING: usize = 1;

    /// Evaluates the rows at the present unknowns: Σ (φ_i/tolerance_i)².
    fn residual(&mut self) -> Result<f64, Fault>;
    /// Factors the matrix of the corrections there; false if a row has lost its direction, so that another form of the
    /// step is needed.
    fn factor(&mut self) -> Result<bool, Fault>;
    /// One correction; returns whether the velocities have converged.
    fn solve(&mut self) -> bool;
    /// Whether the last correction itself was round-off: a residual that is small by chance in one iteration, and larger
    /// in the next, has not stalled.
    fn is_settled(&self) -> bool {
        false
    }
    /// The residual to be reached, at most 1.
    fn enough(&self) -> f64 {
        1.0
    }
    /// The residual that is accepted if a new factor does not reduce it: round-off, or a row without a direction.
    fn round_off(&self) -> f64 {
        STAGNATED
    }
    /// Whether the factor has to be renewed in any case.
    fn is_stale(&self) -> bool {
        false
    }
    /// The failure to report. (Inlined, and with copies of unknowns: values whose address is passed on do not stay in
    /// registers.)
    fn fault(&self, iterations: usize) -> Fault;
}

/// The limits of the iteration.
#[derive(Clone, Copy)]
pub(crate) struct Limits {
    pub(crate) most: usize,
    /// Exactly this number of corrections, with one factor.
    pub(crate) fixed: Option<usize>,
}

/// The result of the iteration.
pub(crate) struct Closed {
    /// Residual.
    pub(crate) left: f64,
    pub(crate) iterations: usize,
}

/// Corrects the unknowns until the rows are satisfied; `None` if a row has lost its direction.
///
/// `factored`: whether there is a factor at the beginning.
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
        // A new factor is needed if the corrections that cost as much as it would not be enough at the present rate.
        let slow = !(residual.powi(C::PATIENCE + 1) <= last.powi(C::PATIENCE) || residual <= 1.0);
        let slow =
            slow && iterations >= C::TELLING && (limits.fixed.is_none() || !residual.is_finite());
        // Powers of a residual that diverges overflow, and tell no rate.
        let spent = iterations >= limits.most && limits.fixed.is_none();
        if !factored || slow || spent || rows.is_stale() {
            if fresh && !C::VELOCITIES && has_stalled(rows, residual, last) {
                return Ok(Some(closed));
            }
            if spent || !residual.is_finite() {
                return Err(rows.fault(iterations));
            }
            if !rows.factor()? {
                return Ok(None);
            }
            (factored, fresh) = (true, true);
        } else {
            fresh = false;
        }
        let converged = rows.solve();
        let stalled = has_stalled(rows, residual, last) && rows.is_settled();
        if C::VELOCITIES && ((converged && residual <= 1.0) || stalled) {
            return Ok(Some(closed));
        }
        last = residual;
        iterations += 1;
    }
}

/// Whether the residual has stalled, and is small enough to be round-off.
#[inline(always)]
fn has_stalled(rows: &impl Closing, residual: f64, last: f64) -> bool {
    residual > STALLED * last && residual < rows.round_off()
}

/// Velocity rows for which corrections with a nearly singular factor are repeated.
pub(crate) trait Refining {
    /// Σ ((A v + b)_i/tolerance_i)².
    fn residual(&mut self) -> f64;
    /// One correction of v and its multipliers.
    fn correct(&mut self);
}

/// Iterates on the residual A v + b of a nearly singular solve: the proximal solve leaves a part in nearly dependent
/// directions, and elimination loses digits. Ends at `enough`, or if a correction does not halve the residual.
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

/// Σ φ_i² / tolerance_i²: if it is at most 1, every row is within its tolerance; NaN if any row is.
#[inline(always)]
pub(crate) fn residual_of<const R: usize>(phi: &SVector<f64, R>, weights: &SVector<f64, R>) -> f64 {
    let (phi, weights) = (entries(phi), entries(weights));
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
