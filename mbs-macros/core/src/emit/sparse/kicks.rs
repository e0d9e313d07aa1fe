//! What kicks need beside K: its elimination with rows of two instants, and M by itself.

use super::columns::{backward, forward, pair_column};
use super::elimination::{
    MASS, collect, factor, mass_entries, passes, room, spread, symmetric_passes,
};
use super::table;
use super::windows::{Arrays, stretches};
use crate::dag::{Elimination, Sparse};
use crate::emit::progressions::folded;
use std::fmt::Write;

/// The expression of the field, and the functions it refers to.
pub(super) fn emit(sparse: &Sparse) -> (String, String) {
    let Some(kicks) = &sparse.kicks else {
        return ("::core::option::Option::None".to_owned(), String::new());
    };
    let (mass, rows) = (&kicks.mass, &sparse.rows);
    let (n, r) = (sparse.size, sparse.row_count);
    let field = format!(
        "::core::option::Option::Some(::mbs_runtime::generated::Kicks {{ mass_slots: {}, mass: {}, forces_vary: {},
            factor_pair: Self::sparse_factor_pair, solve_pair: Self::sparse_solve_pair, factor_mass: Self::sparse_factor_mass, solve_mass: Self::sparse_solve_mass }})",
        room(mass),
        mass_entries(sparse, mass),
        kicks.forces_vary
    );
    let mut out = String::new();
    if mass.is_tabled() {
        table::emit(&mut out, MASS, mass);
    }
    factor(&mut out, "sparse_factor_mass", mass, MASS);
    factor_pair(&mut out, rows);
    let _ = writeln!(
        out,
        "fn sparse_solve_pair(f: &[f64], g: &[f64], rows: &SVector<f64, {r}>, x: &mut [f64], v: &mut SVector<f64, {n}>, kappa: &mut SVector<f64, {r}>) {{
            let (Some(f), Some(g), Some(x)) = (f.first_chunk::<{0}>(), g.first_chunk::<{0}>(), x.first_chunk_mut::<{1}>()) else {{ return }};
            let (rows, v, kappa) = (entries(rows), entries_mut(v), entries_mut(kappa));
            {2} {3} {4} }}",
        rows.slots,
        rows.columns.len(),
        spread(rows, n, r),
        pair_passes(rows),
        collect(rows, n, r)
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
        symmetric_passes(mass, MASS)
    );
    (field, out)
}

/// A solution with two triangles.
fn pair_passes(e: &Elimination) -> String {
    match e.is_tabled() {
        true => "::mbs_runtime::generated::pattern::solve_pair(Self::sparse_rows(), f, g, x);"
            .to_owned(),
        false => passes(e, &["f", "g"], forward, backward),
    }
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
    let arrays = Arrays {
        slots: &["f", "g"],
        vectors: &["c"],
        changed: &["f", "g"],
        give_up: "return f64::INFINITY",
    };
    let body = stretches(e, &arrays, false, pair_column);
    let _ = writeln!(
        out,
        "fn sparse_factor_pair(f: &mut [f64], g: &mut [f64], c: &[f64]) -> f64 {{
            let (Some(f), Some(g), Some(c)) = (f.first_chunk_mut::<{0}>(), g.first_chunk_mut::<{0}>(), c.first_chunk::<{1}>()) else {{ return f64::INFINITY }};
            let mut most = 0.0; {body} most }}",
        e.slots,
        e.columns.len()
    );
}
