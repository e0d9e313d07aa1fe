//! What the eliminations of K and of M have in common: places, factors, solutions.

use super::columns::{forward, symmetric_backward, symmetric_column};
use super::windows::{Arrays, Column, stretches};
use crate::dag::{Elimination, Sparse};
use crate::emit::progressions::folded;
use std::fmt::Write;

/// The names of the tables of K and of M, where eliminations are by tables.
pub(super) const ROWS: &str = "sparse_rows";
pub(super) const MASS: &str = "sparse_mass_alone";

/// The entries of M and their slots in the array of an elimination.
pub(super) fn mass_entries(sparse: &Sparse, elimination: &Elimination) -> String {
    let slot = |&(i, j): &(usize, usize)| [i, j, elimination.slot_of(i, j)];
    places(sparse.mass_entries.iter().map(slot).collect())
}

/// A vector in the order of elimination: zero for the velocities, and the right-hand sides of the rows.
pub(super) fn spread(e: &Elimination, n: usize, r: usize) -> String {
    let velocities = (0..n).map(|i| format!("x[{}] = 0.0;", e.positions[i]));
    let rows = (0..r).map(|i| format!("x[{}] = rows[{i}];", e.positions[n + i]));
    folded(velocities.chain(rows).collect())
}

/// Adds the solution.
pub(super) fn collect(e: &Elimination, n: usize, r: usize) -> String {
    let velocities = (0..n).map(|i| format!("v[{i}] += x[{}];", e.positions[i]));
    let rows = (0..r).map(|i| format!("kappa[{i}] -= x[{}];", e.positions[n + i]));
    folded(velocities.chain(rows).collect())
}

/// A list of places as an expression.
pub(super) fn places<const WIDTH: usize>(list: Vec<[usize; WIDTH]>) -> String {
    let places = list.iter().map(|place| {
        let numbers: Vec<String> = place.iter().map(usize::to_string).collect();
        format!("({})", numbers.join(", "))
    });
    format!("&[{}]", places.collect::<Vec<_>>().join(", "))
}

/// The length of an array: with room for a spread column where a table needs it.
pub(super) fn room(e: &Elimination) -> usize {
    match e.is_tabled() {
        true => e.slots + e.columns.len(),
        false => e.slots,
    }
}

/// A solution with a symmetric matrix.
pub(super) fn symmetric_passes(e: &Elimination, pattern: &str) -> String {
    match e.is_tabled() {
        true => format!("::mbs_runtime::generated::pattern::solve(Self::{pattern}(), f, x);"),
        false => passes(e, &["f"], forward, symmetric_backward),
    }
}

pub(super) fn passes(e: &Elimination, slots: &[&str], forward: Column, backward: Column) -> String {
    let arrays = Arrays {
        slots,
        vectors: &["x"],
        changed: &["x"],
        give_up: "return",
    };
    stretches(e, &arrays, false, forward) + &stretches(e, &arrays, true, backward)
}

/// K = L D Lᵀ in place of its lower triangle: inverse pivots, and below them the columns of L.
pub(super) fn factor(out: &mut String, name: &str, e: &Elimination, pattern: &str) {
    if e.is_tabled() {
        let _ = writeln!(
            out,
            "fn {name}(f: &mut [f64], c: &mut [f64]) -> f64 {{
                ::mbs_runtime::generated::pattern::factor(Self::{pattern}(), f, c) }}"
        );
        return;
    }
    let arrays = Arrays {
        slots: &["f"],
        vectors: &["c"],
        changed: &["f", "c"],
        give_up: "return f64::INFINITY",
    };
    let body = stretches(e, &arrays, false, symmetric_column);
    let _ = writeln!(
        out,
        "fn {name}(f: &mut [f64], c: &mut [f64]) -> f64 {{
            let (Some(f), Some(c)) = (f.first_chunk_mut::<{}>(), c.first_chunk_mut::<{}>()) else {{ return f64::INFINITY }};
            let mut most = 0.0; c.fill(0.0); {body} most }}",
        e.slots,
        e.columns.len()
    );
}
