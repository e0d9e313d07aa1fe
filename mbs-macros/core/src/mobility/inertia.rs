//! Whether a description has an inertia for each of its coordinates: in joint coordinates a part without mass may be the last of its
//! branch.

use crate::equations::System;
use crate::model::{Outline, Part};
use crate::symbolic::{Evaluator, Symbol};

/// In larger mechanisms the factors of M are left to the runtime; only entries that are not there are noticed.
const MOST: usize = 100;
/// A pivot of M below this part of its diagonal entry is round-off.
const ROUND_OFF: f64 = 1e-9;
/// Coordinates are moved from the guess, each by another part of this: there M may be singular by chance.
const MOVED: f64 = 0.1;

/// The name of a coordinate that moves no mass by itself; `None` where M is positive definite, or where every part has mass and inertia.
pub fn massless(outline: &Outline, system: &System) -> Option<String> {
    let is_light = |part: &Part| {
        let entries = [part.mass, part.inertia[2][2]];
        entries.iter().any(|&entry| system.graph.is_zero(entry))
    };
    let is_suspect = !outline.tree.joints.is_empty() && outline.parts.iter().any(is_light);
    if !is_suspect {
        return None;
    }
    let pivot = match system.size > MOST {
        true => (0..system.size).find(|&i| !system.mass.contains_key(&(i, i)))?,
        false => vanishing_pivot(mass_matrix(outline, system))?,
    };
    let slot = system.layout.slots.get(pivot)?;
    Some(system.layout.coordinates.get(*slot)?.name.clone())
}

/// M near the guess, with the defaults of parameters and inputs; those that are zero are taken as one, so that masses that a program
/// gives later are not missed.
fn mass_matrix(outline: &Outline, system: &System) -> Vec<Vec<f64>> {
    let layout = &system.layout;
    let or_one = |value: f64| if value == 0.0 { 1.0 } else { value };
    let parameter = |i: u32| or_one(outline.parameters[i as usize].default);
    let no_laws = |_: u32, _: &[f64]| (0.0, Vec::new());
    let constants = |symbol: Symbol| match symbol {
        Symbol::Parameter(i) => parameter(i),
        _ => 0.0,
    };
    let mut guesses = Evaluator::new(&system.graph, &constants, &no_laws);
    let mut pose = Vec::with_capacity(layout.coordinates.len());
    for (i, stored) in layout.coordinates.iter().enumerate() {
        let golden = (0.618 * (i + 1) as f64).fract();
        let by = if stored.unit.is_empty() {
            0.0
        } else {
            MOVED * golden
        };
        pose.push(guesses.value(stored.guess) + by);
    }
    let symbols = |symbol: Symbol| match symbol {
        Symbol::Parameter(i) => parameter(i),
        Symbol::Input(i) => or_one(outline.inputs[i as usize].default),
        other => layout.value(other, &pose).unwrap_or(0.0),
    };
    let mut evaluator = Evaluator::new(&system.graph, &symbols, &no_laws);
    let mut matrix = vec![vec![0.0; system.size]; system.size];
    for (&(i, j), &entry) in &system.mass {
        let value = evaluator.value(entry);
        (matrix[i][j], matrix[j][i]) = (value, value);
    }
    matrix
}

/// The first pivot of a symmetric matrix that is no more than round-off; none if one is not a number.
fn vanishing_pivot(mut matrix: Vec<Vec<f64>>) -> Option<usize> {
    let size = matrix.len();
    let diagonal: Vec<f64> = (0..size).map(|i| matrix[i][i]).collect();
    for k in 0..size {
        let pivot = matrix[k][k];
        if pivot.is_nan() {
            return None;
        }
        if pivot <= ROUND_OFF * diagonal[k] {
            return Some(k);
        }
        let row = matrix[k].clone();
        for i in k + 1..size {
            let factor = row[i] / pivot;
            if factor != 0.0 {
                for j in k + 1..size {
                    matrix[i][j] -= factor * row[j];
                }
            }
        }
    }
    None
}
