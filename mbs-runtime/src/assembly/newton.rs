//! The nearest pose that satisfies the rows, and the nearest velocity.

use super::continuation;
use crate::System;
use crate::alf3f::residual_of;
use crate::constraint_geometry::ConstraintGeometry;
#[cfg(not(feature = "std"))]
use crate::elementary::Elementary as _;
use crate::fault::Fault;
use crate::linear::{DelassusFactor, accumulate, negative};
use crate::memory::Box;
use crate::row_scale::RowScale;
use crate::singular::Thresholds;
use core::f64::consts::TAU;
use nalgebra::SVector;

/// Newton steps of the position problem; each is damped until it reduces the residual.
pub(super) const MAX_ITERATIONS: usize = 60;
/// Violation of a row, as a displacement relative to the size of the mechanism, above which a guess counts as not assembled.
pub(super) const ASSEMBLED: f64 = 1e-9;

/// Whether the rows are closed: within the tolerance of the settings, and of assembly, which may be the smaller one.
pub(super) fn is_closed<const R: usize>(phi: &SVector<f64, R>, scale: &RowScale<R>) -> bool {
    let of_assembly = (ASSEMBLED / scale.tolerance).powi(2);
    residual_of(phi, &scale.weights) <= of_assembly.min(1.0)
}

/// The pose that satisfies the rows, from the guess: its angles without full turns that no row asks for.
pub(super) fn close<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    t: f64,
    geometry: &mut ConstraintGeometry<S, Q, N, R>,
    q: &mut SVector<f64, Q>,
    phi: &mut SVector<f64, R>,
    scale: &RowScale<R>,
) -> Result<(), Fault> {
    let guess = *q;
    approach(system, t, geometry, q, phi, scale)?;
    if is_closed(phi, scale) && unwind(system, t, &guess, q, scale) {
        geometry.evaluate(system, t, q, phi)?;
    }
    Ok(())
}

/// Takes back full turns by which angles differ from the guess, where the rows stay closed without them: they depend on these angles
/// through sine and cosine. Whether there were any.
pub(super) fn unwind<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    t: f64,
    guess: &SVector<f64, Q>,
    q: &mut SVector<f64, Q>,
    scale: &RowScale<R>,
) -> bool {
    let mut changed = false;
    for (slot, coordinate) in S::MODEL.coordinates.iter().enumerate().take(Q) {
        let turns = ((q[slot] - guess[slot]) / TAU).round();
        if coordinate.unit != "rad" || turns == 0.0 {
            continue;
        }
        let mut trial = *q;
        trial[slot] -= turns * TAU;
        let mut phi = SVector::zeros();
        system.holonomic(t, &trial, &mut phi);
        if is_closed(&phi, scale) {
            *q = trial;
            changed = true;
        }
    }
    changed
}

/// Newton's method from the guess, or where it does not close the rows, after they have been closed little by little.
fn approach<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    t: f64,
    geometry: &mut ConstraintGeometry<S, Q, N, R>,
    q: &mut SVector<f64, Q>,
    phi: &mut SVector<f64, R>,
    scale: &RowScale<R>,
) -> Result<(), Fault> {
    let guess = *q;
    newton(system, t, geometry, q, phi, scale)?;
    if is_closed(phi, scale) {
        return Ok(());
    }
    let mut moved = guess;
    let arrives = continuation::follow(system, t, geometry, &mut moved, scale, 1.0)?;
    if arrives {
        *q = moved;
    }
    geometry.evaluate(system, t, q, phi)?;
    match arrives {
        true => newton(system, t, geometry, q, phi, scale),
        false => Ok(()),
    }
}

/// Damped Newton in the metric of M: q ← q ⊕ −M⁻¹Aᵀ(A M⁻¹ Aᵀ)⁻¹φ, with the proximal solve where rows are dependent.
fn newton<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    t: f64,
    geometry: &mut ConstraintGeometry<S, Q, N, R>,
    q: &mut SVector<f64, Q>,
    phi: &mut SVector<f64, R>,
    scale: &RowScale<R>,
) -> Result<(), Fault> {
    let mut solver = Box::new(DelassusFactor::new());
    for _ in 0..MAX_ITERATIONS {
        if is_closed(phi, scale) {
            return Ok(());
        }
        let before = residual_of(phi, &scale.weights);
        solver.factor(&geometry.holonomic_delassus());
        let mut multiplier = negative(phi);
        solver.solve(&mut multiplier);
        let mut factor = 1.0;
        loop {
            let mut way = SVector::zeros();
            accumulate(&mut way, &geometry.w, &multiplier);
            let trial = system.advance(q, &way, factor);
            let mut residual = SVector::zeros();
            system.holonomic(t, &trial, &mut residual);
            if residual_of(&residual, &scale.weights) < before {
                *q = trial;
                break;
            }
            factor *= 0.5;
            if factor < 1e-6 {
                // No step reduces the residual: it is round-off, or the rows contradict each other.
                return Ok(());
            }
        }
        geometry.evaluate(system, t, q, phi)?;
    }
    Ok(())
}

/// v ← v − M⁻¹Aᵀ(A M⁻¹ Aᵀ)⁻¹(A v + b): the nearest velocity that satisfies the rows, also beside a singular pose, where the
/// proximal solve would leave a part of A v in the direction that is nearly lost.
pub(super) fn project<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    geometry: &ConstraintGeometry<S, Q, N, R>,
    v: &mut SVector<f64, N>,
    scale: &RowScale<R>,
    speed: f64,
) {
    let open =
        |rates: &SVector<f64, R>| !(residual_of(rates, &scale.weights) <= scale.round_off(speed));
    // Velocities that satisfy the rows are left as they are, and nothing is factored for them.
    let mut rates = geometry.velocity_rows(system, v);
    if !open(&rates) {
        return;
    }
    let mut solver = Box::new(DelassusFactor::new());
    solver.thresholds = Thresholds::ELIMINATED;
    solver.expect_redundancy(&geometry.delassus);
    for _ in 0..3 {
        let mut multiplier = negative(&rates);
        solver.solve(&mut multiplier);
        accumulate(v, &geometry.w, &multiplier);
        rates = geometry.velocity_rows(system, v);
        if !open(&rates) {
            return;
        }
    }
}
