//! Elimination without zeros as Rust: one loop for each stretch of columns that repeats.
//!
//! Every index is a number in the functions; in a loop it is a number within a moving window.

mod columns;
mod elimination;
mod kicks;
mod table;
mod windows;

use self::elimination::{
    ROWS, collect, factor, mass_entries, places, room, spread, symmetric_passes,
};
use super::body::Body;
use super::parts::LongFunctions;
use super::progressions::folded;
use crate::contract::Method;
use crate::dag::{Function, Output, Place, Program, Sparse};
use crate::symbolic::Graph;
use std::fmt::Write;

/// Functions of stage 5 that write A, or one triangle of M, into the array of K.
const INTO_ARRAY: [(&str, &str); 2] = [
    ("sparse_constraints", "constraints"),
    ("sparse_mass", "mass_matrix"),
];

/// An output of such a function, with its matrix in the array of K.
fn in_array(sparse: &Sparse, output: &Output) -> Option<Output> {
    let (i, j) = match (output.sink, output.place) {
        ("a", Place::Entry(row, column)) => (sparse.size + row, column),
        ("mass", Place::Entry(i, j)) if i > j => return None,
        ("mass", Place::Entry(i, j)) => (i, j),
        _ => return Some(*output),
    };
    Some(Output {
        sink: "k",
        place: Place::Element(sparse.rows.slot_of(i, j)),
        ..*output
    })
}

/// The constant of `System`, and the functions it refers to; nothing for small systems.
pub(super) fn emit(program: &Program) -> (String, String) {
    let Some(sparse) = &program.sparse else {
        return (String::new(), String::new());
    };
    let rows = &sparse.rows;
    let (n, r) = (sparse.size, sparse.row_count);
    let pivots = rows.positions[n..].iter();
    let pivots = pivots.map(|&position| [position, rows.columns[position].pivot]);
    let pivots = places(pivots.collect());
    let (kicks, kicking) = kicks::emit(sparse);
    let constant = format!(
        "const ELIMINATION: ::core::option::Option<&'static ::mbs_runtime::generated::Elimination<{n}, {r}>> = ::core::option::Option::Some(&::mbs_runtime::generated::Elimination {{
            unknowns: {}, slots: {}, mass: {}, pivots: {pivots}, redundant: {}, operations: {:?},
            rates: Self::sparse_rates, impulse: Self::sparse_impulse, factor: Self::sparse_factor, solve: Self::sparse_solve, accelerate: Self::sparse_accelerate, kicks: {kicks} }});\n",
        rows.columns.len(),
        room(rows),
        mass_entries(sparse, rows),
        sparse.redundant,
        rows.operations(),
    );
    let mut out = String::new();
    if rows.is_tabled() {
        table::emit(&mut out, ROWS, rows);
    }
    rates(&mut out, sparse);
    impulse(&mut out, sparse);
    factor(&mut out, "sparse_factor", rows, ROWS);
    solve(&mut out, sparse);
    accelerate(&mut out, sparse);
    (constant, out + &kicking)
}

/// x ← K⁻¹x, and the solution where the right-hand sides of the velocities are zero.
fn solve(out: &mut String, sparse: &Sparse) {
    let (rows, n, r) = (&sparse.rows, sparse.size, sparse.row_count);
    let (slots, unknowns) = (rows.slots, rows.columns.len());
    let _ = writeln!(
        out,
        "#[inline]
        fn sparse_substitute(f: &[f64; {slots}], x: &mut [f64; {unknowns}]) {{ {} }}
        fn sparse_solve(f: &[f64], rows: &SVector<f64, {r}>, x: &mut [f64], v: &mut SVector<f64, {n}>, kappa: &mut SVector<f64, {r}>) {{
            let (Some(f), Some(x)) = (f.first_chunk::<{slots}>(), x.first_chunk_mut::<{unknowns}>()) else {{ return }};
            let (rows, v, kappa) = (entries(rows), entries_mut(v), entries_mut(kappa));
            {} Self::sparse_substitute(f, x); {} }}",
        symmetric_passes(rows, ROWS),
        spread(rows, n, r),
        collect(rows, n, r)
    );
}

/// f becomes v̇, and −γ becomes λ.
fn accelerate(out: &mut String, sparse: &Sparse) {
    let (e, n, r) = (&sparse.rows, sparse.size, sparse.row_count);
    let both = (0..n).map(|i| (e.positions[i], "v", i, ""));
    let both = both.chain((0..r).map(|i| (e.positions[n + i], "lambda", i, "-")));
    let into = both
        .clone()
        .map(|(position, vector, i, _)| format!("x[{position}] = {vector}[{i}];"));
    let back =
        both.map(|(position, vector, i, sign)| format!("{vector}[{i}] = {sign}x[{position}];"));
    let _ = writeln!(
        out,
        "fn sparse_accelerate(f: &[f64], x: &mut [f64], v: &mut SVector<f64, {n}>, lambda: &mut SVector<f64, {r}>) {{
            let (Some(f), Some(x)) = (f.first_chunk::<{}>(), x.first_chunk_mut::<{}>()) else {{ return }};
            let (v, lambda) = (entries_mut(v), entries_mut(lambda));
            {} Self::sparse_substitute(f, x); {} }}",
        e.slots,
        e.columns.len(),
        folded(into.collect()),
        folded(back.collect())
    );
}

/// A v.
fn rates(out: &mut String, sparse: &Sparse) {
    let (n, r, slots) = (sparse.size, sparse.row_count, sparse.rows.slots);
    let mut sums: Vec<Vec<String>> = vec![Vec::new(); r];
    for &(row, j) in &sparse.jacobian {
        sums[row].push(format!("k[{}] * v[{j}]", sparse.rows.slot_of(n + row, j)));
    }
    let body = assigned("rates", sums);
    let _ = writeln!(
        out,
        "fn sparse_rates(k: &[f64], v: &SVector<f64, {n}>, rates: &mut SVector<f64, {r}>) {{
            let (v, rates) = (entries(v), entries_mut(rates));
            let Some(k) = k.first_chunk::<{slots}>() else {{ return }}; {body} }}"
    );
}

/// Aᵀκ.
fn impulse(out: &mut String, sparse: &Sparse) {
    let (n, r, slots) = (sparse.size, sparse.row_count, sparse.rows.slots);
    let mut sums: Vec<Vec<String>> = vec![Vec::new(); n];
    for &(i, column) in &sparse.jacobian {
        let slot = sparse.rows.slot_of(n + i, column);
        sums[column].push(format!("k[{slot}] * kappa[{i}]"));
    }
    let body = assigned("p", sums);
    let _ = writeln!(
        out,
        "fn sparse_impulse(k: &[f64], kappa: &SVector<f64, {r}>, p: &mut SVector<f64, {n}>) {{
            let (kappa, p) = (entries(kappa), entries_mut(p));
            let Some(k) = k.first_chunk::<{slots}>() else {{ return }}; {body} }}"
    );
}

/// Each element of a vector as its sum.
fn assigned(vector: &str, sums: Vec<Vec<String>>) -> String {
    let sums = sums.into_iter().enumerate();
    let sums = sums.filter(|(_, terms)| !terms.is_empty());
    let lines = sums.map(|(i, terms)| format!("{vector}[{i}] = {};", terms.join(" + ")));
    folded(lines.collect())
}

/// Writes the functions that are others in large mechanisms: A, and M where it varies, into the array of K, and M⁻¹f where
/// its symbolic form, which is as full as M⁻¹, would be long. Tells whether it has.
pub(super) fn replaces(
    out: &mut String,
    graph: &Graph,
    program: &Program,
    long: &LongFunctions,
    method: &Method,
) -> bool {
    let Some(sparse) = &program.sparse else {
        return false;
    };
    let signature = method.signature(program);
    if method.name == "acceleration" {
        let forces_vary = sparse.kicks.as_ref().is_some_and(|kicks| kicks.forces_vary);
        if forces_vary {
            let _ = writeln!(
                out,
                "fn acceleration{signature} {{
                    self.applied_forces(t, q, &SVector::zeros(), acceleration);
                    ::mbs_runtime::generated::multiply(&self.inverse_mass, acceleration); }}"
            );
        }
        return forces_vary;
    }
    let mut pairs = INTO_ARRAY.iter();
    let Some((name, source)) = pairs.find(|(name, _)| *name == method.name) else {
        return false;
    };
    // A constant M is in the array from the start.
    let is_kept = method.name == "sparse_mass" && program.constant_mass.is_some();
    let Some(function) = program.function(source).filter(|_| !is_kept) else {
        return false;
    };
    let place = |output: &Output| in_array(sparse, output);
    let text = long
        .body_with(graph, function, method, place)
        .unwrap_or_else(|| {
            let zero = crate::dag::Operand::number(0.0);
            let outputs = function.outputs.iter();
            let kept = outputs.filter(|output| output.sink != "a" || output.value != zero);
            let function = Function {
                name,
                outputs: kept.filter_map(place).collect(),
                ..function.clone()
            };
            let body = Body::of_method(graph, &function);
            body.statements() + &body.writes()
        });
    let _ = writeln!(
        out,
        "#[inline]\nfn {name}{signature} {{
            let Some(k) = k.first_chunk_mut::<{}>() else {{ return }};
            {}{text} }}",
        sparse.rows.slots,
        super::methods::arrays(method, &text),
    );
    true
}
