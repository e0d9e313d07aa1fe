//! What each turn of the elimination does to its column, and a solution to its unknown.

use super::windows::Window;
use crate::dag::Elimination;
use std::fmt::Write;

/// Eliminates an unknown from the lower triangle of a symmetric matrix; in `c` the lengths of its rows add up.
pub(super) fn symmetric_column(out: &mut String, e: &Elimination, k: usize, window: &Window) {
    let (column, at) = (&e.columns[k], k - window.position);
    let pivot = column.pivot - window.slot;
    let entry = |place: usize| pivot + 1 + place;
    if column.is_row {
        let _ = writeln!(
            out,
            "let inverse = if -f[{pivot}] > ::mbs_runtime::generated::DEPENDENT * c[{at}] {{ 1.0 / f[{pivot}] }} else {{ most = f64::INFINITY; 0.0 }};
            if -c[{at}] * inverse > most {{ most = -c[{at}] * inverse; }}"
        );
    } else {
        let _ = writeln!(out, "let inverse = 1.0 / f[{pivot}];");
    }
    let _ = writeln!(out, "f[{pivot}] = inverse;");
    for (a, &(j, is_row)) in column.below.iter().enumerate() {
        let _ = writeln!(out, "let l = f[{}] * inverse;", entry(a));
        for (b, &(i, _)) in column.below.iter().enumerate().skip(a) {
            let target = e.slot(i, j) - window.slot;
            if a == b && is_row && !column.is_row {
                let _ = writeln!(
                    out,
                    "let s = l * f[{0}]; f[{target}] -= s; c[{1}] += s;",
                    entry(b),
                    j - window.position
                );
            } else {
                let _ = writeln!(out, "f[{target}] -= l * f[{}];", entry(b));
            }
        }
    }
}

/// Eliminates an unknown from a lower and an upper triangle.
pub(super) fn pair_column(out: &mut String, e: &Elimination, k: usize, window: &Window) {
    let (column, at) = (&e.columns[k], k - window.position);
    let pivot = column.pivot - window.slot;
    let entry = |place: usize| pivot + 1 + place;
    if column.is_row {
        let _ = writeln!(
            out,
            "let inverse = if f[{pivot}].abs() > ::mbs_runtime::generated::DEPENDENT * c[{at}] {{ 1.0 / f[{pivot}] }} else {{ most = f64::INFINITY; 0.0 }};
            if c[{at}] * inverse.abs() > most {{ most = c[{at}] * inverse.abs(); }}"
        );
    } else {
        let _ = writeln!(out, "let inverse = 1.0 / f[{pivot}];");
    }
    let _ = writeln!(out, "f[{pivot}] = inverse;");
    for (a, &(i, _)) in column.below.iter().enumerate() {
        let _ = writeln!(out, "let l = f[{0}] * inverse; f[{0}] = l;", entry(a));
        for (b, &(j, _)) in column.below.iter().enumerate() {
            let target = e.slot(i, j) - window.slot;
            let array = if i >= j { "f" } else { "g" };
            let _ = writeln!(out, "{array}[{target}] -= l * g[{}];", entry(b));
        }
    }
}

/// Forward substitution with U.
pub(super) fn symmetric_forward(out: &mut String, e: &Elimination, k: usize, window: &Window) {
    let pivot = e.columns[k].pivot - window.slot;
    let _ = writeln!(out, "let y = x[{}] * f[{pivot}];", k - window.position);
    subtract(out, e, k, window);
}

/// Back substitution with U.
pub(super) fn symmetric_backward(out: &mut String, e: &Elimination, k: usize, window: &Window) {
    upward(out, e, k, window, "f");
}

/// Forward substitution with L.
pub(super) fn forward(out: &mut String, e: &Elimination, k: usize, window: &Window) {
    let _ = writeln!(out, "let y = x[{}];", k - window.position);
    subtract(out, e, k, window);
}

/// Back substitution with U, where it has an array of its own.
pub(super) fn backward(out: &mut String, e: &Elimination, k: usize, window: &Window) {
    upward(out, e, k, window, "g");
}

/// x ← x − y · column.
fn subtract(out: &mut String, e: &Elimination, k: usize, window: &Window) {
    let column = &e.columns[k];
    for (place, &(i, _)) in column.below.iter().enumerate() {
        let slot = column.pivot + 1 + place - window.slot;
        let _ = writeln!(out, "x[{}] -= y * f[{slot}];", i - window.position);
    }
}

/// x_k ← (x_k − row · x) / pivot.
fn upward(out: &mut String, e: &Elimination, k: usize, window: &Window, array: &str) {
    let column = &e.columns[k];
    let (at, pivot) = (k - window.position, column.pivot - window.slot);
    let _ = write!(out, "x[{at}] = (x[{at}]");
    for (place, &(i, _)) in column.below.iter().enumerate() {
        let _ = write!(
            out,
            " - {array}[{}] * x[{}]",
            pivot + 1 + place,
            i - window.position
        );
    }
    let _ = writeln!(out, ") * f[{pivot}];");
}
