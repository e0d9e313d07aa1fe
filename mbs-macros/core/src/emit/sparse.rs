//! Elimination without zeros as Rust: one loop for each stretch of columns that repeats.
//!
//! Every index is a number in the functions; in a loop it is a number within a moving window.

mod columns;
mod table;
mod windows;

use self::columns::{
    backward, forward, pair_column, symmetric_backward, symmetric_column, symmetric_forward,
};
use self::windows::{Column, stretches};
use super::body::Body;
use super::parts::{LongFunctions, words_of_u32};
use super::progressions::folded;
use crate::contract::Method;
use crate::dag::{Elimination, Function, Output, Place, Program, Sparse};
use crate::symbolic::Graph;
use std::fmt::Write;

/// Longer lists of places are written as one text.
const MOST_PLACES: usize = 250;

/// A function of stage 5 that writes A into the array of K.
pub(super) fn constraints(sparse: &Sparse, function: &Function) -> Function {
    let place = |output: &Output| in_array(sparse, output);
    let zero = crate::dag::Operand::number(0.0);
    let kept = |output: &&Output| output.sink != "a" || output.value != zero;
    Function {
        name: "sparse_constraints",
        outputs: function.outputs.iter().filter(kept).map(place).collect(),
        ..function.clone()
    }
}

/// An output of the function of A, with A in the array of K.
fn in_array(sparse: &Sparse, output: &Output) -> Output {
    match output.place {
        Place::Entry(row, column) if output.sink == "a" => Output {
            sink: "k",
            place: Place::Element(sparse.rows.slot_of(sparse.size + row, column)),
            ..*output
        },
        _ => *output,
    }
}

/// The constant of `System`, and the functions it refers to; nothing for small systems.
pub(super) fn emit(program: &Program) -> (String, String) {
    let Some(sparse) = &program.sparse else {
        return (String::new(), String::new());
    };
    let (rows, mass) = (&sparse.rows, &sparse.mass);
    let (n, r) = (sparse.size, sparse.row_count);
    let entries = |elimination: &Elimination| {
        let slot = |&(i, j): &(usize, usize)| [i, j, elimination.slot_of(i, j)];
        places("triples_of", sparse.mass_entries.iter().map(slot).collect())
    };
    let pivots = rows.positions[n..].iter();
    let pivots = pivots.map(|&position| [position, rows.columns[position].pivot]);
    let pivots = places("pairs_of", pivots.collect());
    let constant = format!(
        "const ELIMINATION: ::core::option::Option<&'static ::mbs_runtime::generated::Elimination<{n}, {r}>> = ::core::option::Option::Some(&::mbs_runtime::generated::Elimination {{
            unknowns: {}, slots: {}, mass_slots: {}, mass: {}, mass_alone: {}, pivots: {pivots}, forces_vary: {},
            rates: Self::sparse_rates, impulse: Self::sparse_impulse, factor: Self::sparse_factor, solve: Self::sparse_solve,
            factor_pair: Self::sparse_factor_pair, solve_pair: Self::sparse_solve_pair, factor_mass: Self::sparse_factor_mass, solve_mass: Self::sparse_solve_mass }});\n",
        rows.columns.len(),
        room(rows),
        room(mass),
        entries(rows),
        entries(mass),
        sparse.forces_vary
    );
    let mut out = String::new();
    for (name, elimination) in [("sparse_rows", rows), ("sparse_mass", mass)] {
        if elimination.is_tabled() {
            table::emit(&mut out, name, elimination);
        }
    }
    rates(&mut out, sparse);
    impulse(&mut out, sparse);
    factor(&mut out, "sparse_factor", rows, "sparse_rows");
    factor(&mut out, "sparse_factor_mass", mass, "sparse_mass");
    factor_pair(&mut out, rows);
    let rows_in = spread(rows, n, |row| format!("rows[{row}]"), r);
    let rows_out = collect(rows, n, r);
    let _ = writeln!(
        out,
        "fn sparse_solve(f: &[f64], rows: &SVector<f64, {r}>, x: &mut [f64], v: &mut SVector<f64, {n}>, kappa: &mut SVector<f64, {r}>) {{
            let (Some(f), Some(x)) = (f.first_chunk::<{}>(), x.first_chunk_mut::<{}>()) else {{ return }};
            let (rows, v, kappa) = (entries(rows), entries_mut(v), entries_mut(kappa));
            {rows_in} {} {rows_out} }}",
        rows.slots,
        rows.columns.len(),
        symmetric_passes(rows, "sparse_rows")
    );
    let _ = writeln!(
        out,
        "fn sparse_solve_pair(f: &[f64], g: &[f64], rows: &SVector<f64, {r}>, x: &mut [f64], v: &mut SVector<f64, {n}>, kappa: &mut SVector<f64, {r}>) {{
            let (Some(f), Some(g), Some(x)) = (f.first_chunk::<{0}>(), g.first_chunk::<{0}>(), x.first_chunk_mut::<{1}>()) else {{ return }};
            let (rows, v, kappa) = (entries(rows), entries_mut(v), entries_mut(kappa));
            {rows_in} {2} {rows_out} }}",
        rows.slots,
        rows.columns.len(),
        pair_passes(rows)
    );
    let positions = mass.positions.iter().enumerate();
    let into = positions
        .clone()
        .map(|(i, position)| format!("x[{position}] = v[{i}];"));
    let back = positions.map(|(i, position)| format!("v[{i}] = x[{position}];"));
    let [into, back] = [folded(into.collect()), folded(back.collect())];
    let _ = writeln!(
        out,
        "fn sparse_solve_mass(f: &[f64], x: &mut [f64], v: &mut SVector<f64, {n}>) {{
            let v = entries_mut(v);
            let (Some(f), Some(x)) = (f.first_chunk::<{}>(), x.first_chunk_mut::<{n}>()) else {{ return }};
            {into} {} {back} }}",
        mass.slots,
        symmetric_passes(mass, "sparse_mass")
    );
    (constant, out)
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

/// A vector in the order of elimination: zero for the velocities, and the right-hand sides of the rows.
fn spread(e: &Elimination, n: usize, row: impl Fn(usize) -> String, r: usize) -> String {
    let velocities = (0..n).map(|i| format!("x[{}] = 0.0;", e.positions[i]));
    let rows = (0..r).map(|i| format!("x[{}] = {};", e.positions[n + i], row(i)));
    folded(velocities.chain(rows).collect())
}

/// Adds the solution.
fn collect(e: &Elimination, n: usize, r: usize) -> String {
    let velocities = (0..n).map(|i| format!("v[{i}] += x[{}];", e.positions[i]));
    let rows = (0..r).map(|i| format!("kappa[{i}] -= x[{}];", e.positions[n + i]));
    folded(velocities.chain(rows).collect())
}

/// A list of places as an expression.
fn places<const WIDTH: usize>(reader: &str, list: Vec<[usize; WIDTH]>) -> String {
    if list.len() > MOST_PLACES {
        let words: Vec<usize> = list.iter().flatten().copied().collect();
        let (count, words) = (list.len(), words_of_u32(&words));
        return format!("&::mbs_runtime::generated::{reader}::<{count}>({words})");
    }
    let places = list.iter().map(|place| {
        let numbers: Vec<String> = place.iter().map(usize::to_string).collect();
        format!("({})", numbers.join(", "))
    });
    format!("&[{}]", places.collect::<Vec<_>>().join(", "))
}

/// The length of an array: with room for a spread column where a table needs it.
fn room(e: &Elimination) -> usize {
    match e.is_tabled() {
        true => e.slots + e.columns.len(),
        false => e.slots,
    }
}

/// A solution with a symmetric matrix.
fn symmetric_passes(e: &Elimination, pattern: &str) -> String {
    match e.is_tabled() {
        true => format!("::mbs_runtime::generated::pattern::solve(Self::{pattern}(), f, x);"),
        false => passes(e, &["f"], symmetric_forward, symmetric_backward),
    }
}

/// The same with two triangles.
fn pair_passes(e: &Elimination) -> String {
    match e.is_tabled() {
        true => "::mbs_runtime::generated::pattern::solve_pair(Self::sparse_rows(), f, g, x);"
            .to_owned(),
        false => passes(e, &["f", "g"], forward, backward),
    }
}

fn passes(e: &Elimination, arrays: &[&str], forward: Column, backward: Column) -> String {
    stretches(e, arrays, &["x"], &["x"], false, "return", forward)
        + &stretches(e, arrays, &["x"], &["x"], true, "return", backward)
}

/// K = U ᵀD⁻¹U in place of its lower triangle: inverse pivots, and below them the columns of D U.
fn factor(out: &mut String, name: &str, e: &Elimination, pattern: &str) {
    if e.is_tabled() {
        let _ = writeln!(
            out,
            "fn {name}(f: &mut [f64], c: &mut [f64]) -> f64 {{
                ::mbs_runtime::generated::pattern::factor(Self::{pattern}(), f, c) }}"
        );
        return;
    }
    let body = stretches(
        e,
        &["f"],
        &["c"],
        &["f", "c"],
        false,
        "return f64::INFINITY",
        symmetric_column,
    );
    let _ = writeln!(
        out,
        "fn {name}(f: &mut [f64], c: &mut [f64]) -> f64 {{
            let (Some(f), Some(c)) = (f.first_chunk_mut::<{}>(), c.first_chunk_mut::<{}>()) else {{ return f64::INFINITY }};
            let mut most = 0.0; c.fill(0.0); {body} most }}",
        e.slots,
        e.columns.len()
    );
}

/// K = L D U in place: in `f` inverse pivots and L, in `g` the rows of D U.
fn factor_pair(out: &mut String, e: &Elimination) {
    if e.is_tabled() {
        let _ = writeln!(
            out,
            "fn sparse_factor_pair(f: &mut [f64], g: &mut [f64], c: &[f64]) -> f64 {{
                ::mbs_runtime::generated::pattern::factor_pair(Self::sparse_rows(), f, g, c) }}"
        );
        return;
    }
    let body = stretches(
        e,
        &["f", "g"],
        &["c"],
        &["f", "g"],
        false,
        "return f64::INFINITY",
        pair_column,
    );
    let _ = writeln!(
        out,
        "fn sparse_factor_pair(f: &mut [f64], g: &mut [f64], c: &[f64]) -> f64 {{
            let (Some(f), Some(g), Some(c)) = (f.first_chunk_mut::<{0}>(), g.first_chunk_mut::<{0}>(), c.first_chunk::<{1}>()) else {{ return f64::INFINITY }};
            let mut most = 0.0; {body} most }}",
        e.slots,
        e.columns.len()
    );
}

/// Writes the functions that are others in large mechanisms: A into the array of K, and M⁻¹f where its symbolic form,
/// which is as full as M⁻¹, would be long. Tells whether it has.
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
    match (method.name, program.function("constraints")) {
        ("acceleration", _) if sparse.forces_vary => {
            let _ = writeln!(
                out,
                "fn acceleration{signature} {{
                    self.applied_forces(t, q, &SVector::zeros(), acceleration);
                    ::mbs_runtime::generated::multiply(&self.inverse_mass, acceleration); }}"
            );
            true
        }
        ("sparse_constraints", Some(function)) => {
            let place = |output: &Output| Some(in_array(sparse, output));
            let parts = long.body_with(graph, function, method, place);
            let text = parts.unwrap_or_else(|| {
                let function = constraints(sparse, function);
                let body = Body::of_method(graph, &function);
                body.statements() + &body.writes()
            });
            let _ = writeln!(
                out,
                "#[inline]\nfn sparse_constraints{signature} {{
                    let Some(k) = k.first_chunk_mut::<{}>() else {{ return }};
                    {}{text} }}",
                sparse.rows.slots,
                super::methods::arrays(method, &text),
            );
            true
        }
        _ => false,
    }
}
