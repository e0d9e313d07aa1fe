//! What each turn of the elimination does to its column, and a solution to its unknown.

use super::windows::Window;
use crate::dag::Elimination;
use std::fmt::Write;

/// Eliminates an unknown from the lower triangle of a symmetric matrix, and leaves a column of L below its inverse pivot; in
/// `c` the lengths of its rows add up.
pub(super) fn symmetric_column(out: &mut String, e: &Elimination, k: usize, window: &Window) {
    let part = window.part;
    let (column, at) = (&e.columns[k], k - window.position);
    let pivot = column.pivot - window.slot;
    let entry = |place: usize| pivot + 1 + place;
    if column.is_row {
        let _ = writeln!(
            out,
            "let inverse = if -f{part}[{pivot}] > ::mbs_runtime::generated::DEPENDENT * c{part}[{at}] {{ 1.0 / f{part}[{pivot}] }} else {{ most = f64::INFINITY; 0.0 }};
            if -c{part}[{at}] * inverse > most {{ most = -c{part}[{at}] * inverse; }}"
        );
    } else {
        let _ = writeln!(out, "let inverse = 1.0 / f{part}[{pivot}];");
    }
    let _ = writeln!(out, "f{part}[{pivot}] = inverse;");
    for (a, &(j, is_row)) in column.below.iter().enumerate() {
        let _ = writeln!(out, "let l = f{part}[{}] * inverse;", entry(a));
        for (b, &(i, _)) in column.below.iter().enumerate().skip(a) {
            let target = e.slot(i, j) - window.slot;
            if a == b && is_row && !column.is_row {
                let _ = writeln!(
                    out,
                    "let s = l * f{part}[{0}]; f{part}[{target}] -= s; c{part}[{1}] += s;",
                    entry(b),
                    j - window.position
                );
            } else {
                let _ = writeln!(out, "f{part}[{target}] -= l * f{part}[{}];", entry(b));
            }
        }
        let _ = writeln!(out, "f{part}[{}] = l;", entry(a));
    }
}

/// Eliminates an unknown from a lower and an upper triangle.
pub(super) fn pair_column(out: &mut String, e: &Elimination, k: usize, window: &Window) {
    let part = window.part;
    let (column, at) = (&e.columns[k], k - window.position);
    let pivot = column.pivot - window.slot;
    let entry = |place: usize| pivot + 1 + place;
    if column.is_row {
        let _ = writeln!(
            out,
            "let inverse = if f{part}[{pivot}].abs() > ::mbs_runtime::generated::DEPENDENT * c{part}[{at}] {{ 1.0 / f{part}[{pivot}] }} else {{ most = f64::INFINITY; 0.0 }};
            if c{part}[{at}] * inverse.abs() > most {{ most = c{part}[{at}] * inverse.abs(); }}"
        );
    } else {
        let _ = writeln!(out, "let inverse = 1.0 / f{part}[{pivot}];");
    }
    let _ = writeln!(out, "f{part}[{pivot}] = inverse;");
    for (a, &(i, _)) in column.below.iter().enumerate() {
        let _ = writeln!(
            out,
            "let l = f{part}[{0}] * inverse; f{part}[{0}] = l;",
            entry(a)
        );
        for (b, &(j, _)) in column.below.iter().enumerate() {
            let target = e.slot(i, j) - window.slot;
            let array = if i >= j { "f" } else { "g" };
            let _ = writeln!(out, "{array}{part}[{target}] -= l * g{part}[{}];", entry(b));
        }
    }
}

/// x ← L⁻¹x.
pub(super) fn forward(out: &mut String, e: &Elimination, k: usize, window: &Window) {
    let part = window.part;
    let _ = writeln!(out, "let y = x{part}[{}];", k - window.position);
    let column = &e.columns[k];
    for (place, &(i, _)) in column.below.iter().enumerate() {
        let slot = column.pivot + 1 + place - window.slot;
        let _ = writeln!(
            out,
            "x{part}[{}] -= y * f{part}[{slot}];",
            i - window.position
        );
    }
}

/// x ← L⁻ᵀD⁻¹x.
pub(super) fn symmetric_backward(out: &mut String, e: &Elimination, k: usize, window: &Window) {
    let part = window.part;
    let (at, pivot) = (k - window.position, e.columns[k].pivot - window.slot);
    let terms = terms(e, k, window, "f");
    let _ = writeln!(
        out,
        "x{part}[{at}] = x{part}[{at}] * f{part}[{pivot}]{terms};"
    );
}

/// x ← (D U)⁻¹x, where D U has an array of its own.
pub(super) fn backward(out: &mut String, e: &Elimination, k: usize, window: &Window) {
    let part = window.part;
    let (at, pivot) = (k - window.position, e.columns[k].pivot - window.slot);
    let terms = terms(e, k, window, "g");
    let _ = writeln!(
        out,
        "x{part}[{at}] = (x{part}[{at}]{terms}) * f{part}[{pivot}];"
    );
}

/// What the unknowns behind one take from it. The next ones are the last to be known, so that their terms are the last:
/// nothing else waits for them.
fn terms(e: &Elimination, k: usize, window: &Window, array: &str) -> String {
    let part = window.part;
    let column = &e.columns[k];
    let below = column.below.iter().enumerate().rev();
    below.fold(String::new(), |mut text, (place, &(i, _))| {
        let slot = column.pivot + 1 + place - window.slot;
        let _ = write!(
            text,
            " - {array}{part}[{slot}] * x{part}[{}]",
            i - window.position
        );
        text
    })
}
