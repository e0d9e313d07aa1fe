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
pub(super) const SHORT: f64 = 0.01;
/// How far the other poses are turned from the guess, rad. They need not satisfy the rows.
const AWAY: f64 = 0.3;
/// Multiples of the golden angle, rad: directions that have nothing in common with those of a mechanism.
const TURNS: [f64; 3] = [2.4, 4.8, 7.2];

/// |a_i|² in the units of the yardstick, and a M⁻¹aᵀ of the holonomic rows, 0 of the others (and of all of them if not
/// `weighed`): at the declared guess, but of a row that is much shorter there than elsewhere enlarged in the ratio of |a_i|².
/// Where rows vanish at the guess the latter is zero for them, and the third has their lengths elsewhere, too.
pub(super) fn lengths<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    yardstick: &Yardstick<Q, N>,
    weighed: bool,
) -> Result<(SVector<f64, R>, SVector<f64, R>, Option<SVector<f64, R>>), Fault> {
    let (guess, _) = system.guess();
    let mut geometry = ConstraintGeometry::new(system, &guess)?;
    let others = TURNS.map(|turn| {
        let way = vector(|i| match S::MODEL.velocities.get(i) {
            Some(velocity) if velocity.unit == "rad/s" => AWAY * (turn * (i + 1) as f64).cos(),
            // A displacement would stretch bars, and their rows with them.
            _ => 0.0,
        });
        system.advance(&guess, &way, 1.0)
    });
    let mut elsewhere: SVector<f64, R> = zeros();
    for q in &others {
        let there = squares(system, yardstick, q, &mut geometry);
        elsewhere = vector(|i| larger(elsewhere[i], there[i]));
    }
    let at_guess = squares(system, yardstick, &guess, &mut geometry);
    let usual: SVector<f64, R> = vector(|i| match at_guess[i] < SHORT * elsewhere[i] {
        true => elsewhere[i],
        false => at_guess[i],
    });
    if !weighed {
        return Ok((usual, zeros(), None));
    }
    geometry.metric(system, 0.0, &guess)?;
    let is_position = |i: usize| i < S::STRUCTURE.holonomic_rows;
    let vanishes = |i: usize| is_position(i) && at_guess[i] == 0.0;
    let weighed: SVector<f64, R> = vector(|i| match is_position(i) && !vanishes(i) {
        true => geometry.delassus[i][i] * (usual[i] / at_guess[i]),
        false => 0.0,
    });
    if !(0..R).any(vanishes) {
        return Ok((usual, weighed, None));
    }
    let mut later = weighed;
    for q in &others {
        squares(system, yardstick, q, &mut geometry);
        if geometry.metric(system, 0.0, q).is_ok() {
            later = vector(|i| match vanishes(i) {
                true => larger(later[i], geometry.delassus[i][i]),
                false => later[i],
            });
        }
    }
    Ok((usual, weighed, Some(later)))
}

/// |a_i|² of the rows in this pose, which are those of `geometry` afterwards.
fn squares<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    yardstick: &Yardstick<Q, N>,
    q: &SVector<f64, Q>,
    geometry: &mut ConstraintGeometry<S, Q, N, R>,
) -> SVector<f64, R> {
    let ConstraintGeometry { a, b, .. } = geometry;
    system.constraints(0.0, q, &mut zeros(), a.entries_mut(), b);
    vector(|i| yardstick.row_length_squared(&a[i]))
}
