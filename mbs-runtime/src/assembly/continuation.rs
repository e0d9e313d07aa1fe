//! From a guess that is far from closed, or after a long jump of an input: the rows are closed little by little.
//!
//! ```text
//! φ(q) = (1 − s) φ(guess),    s from 0 to 1
//! ```
//!
//! Newton's method from the guess itself can turn a long chain into knots; here all rows that hold are held on the way, as
//! if the mechanism were moved by hand.

use crate::System;
use crate::alf3f::residual_of;
use crate::constraint_geometry::ConstraintGeometry;
use crate::fault::Fault;
use crate::linear::{DelassusFactor, accumulate};
use crate::memory::Box;
use crate::row_scale::RowScale;
use nalgebra::SVector;

/// The first part of the way that is tried at once, and the least.
const FIRST: f64 = 0.05;
const LEAST: f64 = 1e-5;
/// The most parts.
const MOST: usize = 1000;
/// A part of at most this displacement, in lengths of the mechanism or radians, ends on the branch on which it began.
const NEAR: f64 = 0.2;
/// Newton's corrections of a part of the way: it is halved if they are not enough.
const CORRECTIONS: usize = 8;
/// A part of the way has come to its end within this part of φ(guess).
const REACHED: f64 = 1e-3;

/// Moves `q` to where the rows are nearly closed, if they are far from that, on its branch; whether it has moved.
pub(super) fn follow_branch<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    t: f64,
    geometry: &mut ConstraintGeometry<S, Q, N, R>,
    (q, phi): (&mut SVector<f64, Q>, &SVector<f64, R>),
    scale: &RowScale<R>,
) -> Result<bool, Fault> {
    if !is_far(phi, scale) {
        return Ok(false);
    }
    let longest = (NEAR / scale.displacement(phi)).max(2.0 / MOST as f64);
    let mut moved = *q;
    let arrives = follow(system, t, geometry, &mut moved, scale, longest)?;
    if arrives {
        *q = moved;
    }
    Ok(arrives)
}

/// Whether rows are so far from closed that the near pose may be that of another branch; not of rows that are no numbers.
pub(super) fn is_far<const R: usize>(phi: &SVector<f64, R>, scale: &RowScale<R>) -> bool {
    scale.displacement(phi) > NEAR
}

/// Moves `q` from the guess to where the rows are nearly closed, in parts up to the `longest`; whether it came there.
pub(super) fn follow<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    t: f64,
    geometry: &mut ConstraintGeometry<S, Q, N, R>,
    q: &mut SVector<f64, Q>,
    scale: &RowScale<R>,
    longest: f64,
) -> Result<bool, Fault> {
    let mut open = SVector::zeros();
    geometry.evaluate(system, t, q, &mut open)?;
    let enough = REACHED * REACHED * residual_of(&open, &scale.weights);
    let mut solver = Box::new(DelassusFactor::new());
    let (mut left, mut part) = (1.0_f64, FIRST.min(longest));
    for _ in 0..MOST {
        if left == 0.0 {
            return Ok(true);
        }
        let next = (left - part).max(0.0);
        let mut trial = *q;
        let mut phi = SVector::zeros();
        let mut reached = false;
        for _ in 0..CORRECTIONS {
            // Where the equations have no value this part of the way was too long.
            if geometry.evaluate(system, t, &trial, &mut phi).is_err() {
                break;
            }
            let mut missing: SVector<f64, R> = open * next - phi;
            reached = residual_of(&missing, &scale.weights) <= enough;
            if reached {
                break;
            }
            solver.factor(&geometry.holonomic_delassus());
            solver.solve(&mut missing);
            let mut way = SVector::zeros();
            accumulate(&mut way, &geometry.w, &missing);
            trial = system.advance(&trial, &way, 1.0);
        }
        if reached {
            (*q, left) = (trial, next);
            part = (1.5 * part).min(longest);
        } else if part > LEAST {
            part *= 0.5;
        } else {
            return Ok(false);
        }
    }
    Ok(left == 0.0)
}
