//! The lengths that rows have in most poses.
//!
//! In joint coordinates a row can vanish at a singular pose. A mechanism that is declared beside such a pose has rows there
//! that are shorter than elsewhere, and with their lengths as the measure no singular pose would be noticed.

use crate::System;
use crate::constraint_geometry::ConstraintGeometry;
#[cfg(not(feature = "std"))]
use crate::elementary::Elementary as _;
use crate::fault::Fault;
use crate::linear::{larger, vector, zeros};
use crate::yardstick::Yardstick;
use nalgebra::SVector;

/// A row whose squared length at the guess is less than this part of that in other poses is shorter than usual.
const SHORT: f64 = 0.01;
/// How far the other poses are turned from the guess, rad. They need not satisfy the rows.
const AWAY: f64 = 0.3;
/// Multiples of the golden angle, rad: directions that have nothing in common with those of a mechanism.
const TURNS: [f64; 3] = [2.4, 4.8, 7.2];

/// |a_i|² in the units of the yardstick, and a M⁻¹aᵀ of the holonomic rows, 0 of the others (and of all of them if not
/// `weighed`): at the declared guess, but of a row that is much shorter there than elsewhere enlarged in the ratio of |a_i|².
pub(super) fn lengths<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    yardstick: &Yardstick<Q, N>,
    weighed: bool,
) -> Result<[SVector<f64, R>; 2], Fault> {
    let (guess, _) = system.guess();
    let mut geometry = ConstraintGeometry::new(system, &guess)?;
    let mut lengths_squared_at = |q: &SVector<f64, Q>| -> SVector<f64, R> {
        let ConstraintGeometry { a, b, .. } = &mut *geometry;
        system.constraints(0.0, q, &mut zeros(), a, b);
        vector(|i| yardstick.row_length_squared(&a[i]))
    };
    let mut elsewhere: SVector<f64, R> = zeros();
    for turn in TURNS {
        let way = vector(|i| match S::MODEL.velocities.get(i) {
            Some(velocity) if velocity.unit == "rad/s" => AWAY * (turn * (i + 1) as f64).cos(),
            // A displacement would stretch bars, and their rows with them.
            _ => 0.0,
        });
        let there = lengths_squared_at(&system.advance(&guess, &way, 1.0));
        elsewhere = vector(|i| larger(elsewhere[i], there[i]));
    }
    let at_guess = lengths_squared_at(&guess);
    let usual: SVector<f64, R> = vector(|i| match at_guess[i] < SHORT * elsewhere[i] {
        true => elsewhere[i],
        false => at_guess[i],
    });
    if !weighed {
        return Ok([usual, zeros()]);
    }
    geometry.metric(system, 0.0, &guess)?;
    let weighed = vector(
        |i| match i < S::STRUCTURE.holonomic_rows && at_guess[i] > 0.0 {
            true => geometry.delassus[i][i] * (usual[i] / at_guess[i]),
            false => 0.0,
        },
    );
    Ok([usual, weighed])
}
