//! What each turn of the elimination does to its column, and a solution to its unknown.

use super::windows::Window;
use crate::dag::Elimination;
use std::fmt::Write;

/// Eliminates an unknown from the lower triangle of a symmetric matrix, and leaves a column of L below its inverse pivot; in
/// `c` the lengths of its rows add up.
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
        let _ = writeln!(out, "f[{}] = l;", entry(a));
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

/// x ← L⁻¹x.
pub(super) fn forward(out: &mut String, e: &Elimination, k: usize, window: &Window) {
    let _ = writeln!(out, "let y = x[{}];", k - window.position);
    let column = &e.columns[k];
    for (place, &(i, _)) in column.below.iter().enumerate() {
        let slot = column.pivot + 1 + place - window.slot;
        let _ = writeln!(out, "x[{}] -= y * f[{slot}];", i - window.position);
    }
}

/// x ← L⁻ᵀD⁻¹x.
pub(super) fn symmetric_backward(out: &mut String, e: &Elimination, k: usize, window: &Window) {
    let (at, pivot) = (k - window.position, e.columns[k].pivot - window.slot);
    let terms = terms(e, k, window, "f");
    let _ = writeln!(out, "x[{at}] = x[{at}] * f[{pivot}]{terms};");
}

/// x ← (D U)⁻¹x, where D U has an array of its own.
pub(super) fn backward(out: &mut String, e: &Elimination, k: usize, window: &Window) {
    let (at, pivot) = (k - window.position, e.columns[k].pivot - window.slot);
    let terms = terms(e, k, window, "g");
    let _ = writeln!(out, "x[{at}] = (x[{at}]{terms}) * f[{pivot}];");
}

/// What the unknowns behind one take from it. The next ones are the last to be known, so that their terms are the last:
/// nothing else waits for them.
fn terms(e: &Elimination, k: usize, window: &Window, array: &str) -> String {
    let column = &e.columns[k];
    let below = column.below.iter().enumerate().rev();
    below.fold(String::new(), |mut text, (place, &(i, _))| {
        let slot = column.pivot + 1 + place - window.slot;
        let _ = write!(text, " - {array}[{slot}] * x[{}]", i - window.position);
        text
    })
}
