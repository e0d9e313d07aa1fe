//! Elimination without zeros as Rust: one loop for each stretch of columns that repeats.
//!
//! Every index is a number in the functions; in a loop it is a number within a moving window.

mod columns;
mod windows;

use self::columns::{
    backward, forward, pair_column, symmetric_backward, symmetric_column, symmetric_forward,
};
use self::windows::{Column, stretches};
use super::body::Body;
use super::parts::LongFunctions;
use crate::contract::Method;
use crate::dag::{Elimination, Function, Output, Place, Program, Sparse};
use crate::symbolic::Graph;
use std::fmt::Write;

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
        let slots = sparse.mass_entries.iter().map(|&(i, j)| {
            let slot = elimination.slot_of(i, j);
            format!("({i}, {j}, {slot})")
        });
        slots.collect::<Vec<_>>().join(", ")
    };
    let jacobian = (0..r).map(|row| {
        let entries = sparse.jacobian.iter().filter(|entry| entry.0 == row);
        let entries = entries.map(|&(_, j)| format!("[{j}, {}]", rows.slot_of(n + row, j)));
        format!("&[{}]", entries.collect::<Vec<_>>().join(", "))
    });
    let pivots: Vec<usize> = rows.positions[n..]
        .iter()
        .map(|&position| rows.columns[position].pivot)
        .collect();
    let constant = format!(
        "const ELIMINATION: ::core::option::Option<&'static ::mbs_runtime::generated::Elimination<{n}, {r}>> = ::core::option::Option::Some(&::mbs_runtime::generated::Elimination {{
            unknowns: {}, slots: {}, mass_slots: {}, mass: &[{}], mass_alone: &[{}], jacobian: &[{}], positions: &{:?}, mass_positions: &{:?}, pivots: &{pivots:?}, forces_vary: {},
            factor: Self::sparse_factor, solve: Self::sparse_solve, factor_pair: Self::sparse_factor_pair,
            solve_pair: Self::sparse_solve_pair, factor_mass: Self::sparse_factor_mass, solve_mass: Self::sparse_solve_mass }});\n",
        rows.columns.len(),
        rows.slots,
        mass.slots,
        entries(rows),
        entries(mass),
        jacobian.collect::<Vec<_>>().join(", "),
        rows.positions,
        mass.positions,
        sparse.forces_vary
    );
    let mut out = String::new();
    factor(&mut out, "sparse_factor", rows);
    factor(&mut out, "sparse_factor_mass", mass);
    factor_pair(&mut out, rows);
    solve(&mut out, "sparse_solve", rows);
    solve_pair(&mut out, rows);
    solve(&mut out, "sparse_solve_mass", mass);
    (constant, out)
}

/// x ← K⁻¹x from the factor of a symmetric K.
fn solve(out: &mut String, name: &str, e: &Elimination) {
    let _ = writeln!(
        out,
        "fn {name}(f: &[f64], x: &mut [f64]) {{
            let (Some(f), Some(x)) = (f.first_chunk::<{}>(), x.first_chunk_mut::<{}>()) else {{ return }};
            {} }}",
        e.slots,
        e.columns.len(),
        passes(e, &["f"], symmetric_forward, symmetric_backward)
    );
}

/// The same from both factors of K.
fn solve_pair(out: &mut String, e: &Elimination) {
    let _ = writeln!(
        out,
        "fn sparse_solve_pair(f: &[f64], g: &[f64], x: &mut [f64]) {{
            let (Some(f), Some(g), Some(x)) = (f.first_chunk::<{0}>(), g.first_chunk::<{0}>(), x.first_chunk_mut::<{1}>()) else {{ return }};
            {2} }}",
        e.slots,
        e.columns.len(),
        passes(e, &["f", "g"], forward, backward)
    );
}

fn passes(e: &Elimination, arrays: &[&str], forward: Column, backward: Column) -> String {
    stretches(e, arrays, &["x"], &["x"], false, "return", forward)
        + &stretches(e, arrays, &["x"], &["x"], true, "return", backward)
}

/// K = U ᵀD⁻¹U in place of its lower triangle: inverse pivots, and below them the columns of D U.
fn factor(out: &mut String, name: &str, e: &Elimination) {
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
