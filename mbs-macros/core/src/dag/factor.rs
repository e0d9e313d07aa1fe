//! A varying mass matrix: its factor and solutions, without its zeros. M = L D Lᵀ, stored as D⁻¹ and the nonzero
//! entries of L.

use super::elimination::{Factor, Rank, Sparse, Upper};
use super::kernels::{LONGEST, rows};
use super::lower::{Hoisted, Lowering};
use super::{Function, Operand, Place};
use crate::derivatives::Derived;
use crate::symbolic::{Graph, Symbol};

/// The kernels of M in straight-line code; none where that is long.
pub(super) fn kernels(
    graph: &mut Graph,
    hoisted: &mut Hoisted,
    derived: &Derived,
) -> Vec<Function> {
    // Known without lowering: a square number of operations is no trifle.
    if derived.system.mass.len() > LONGEST {
        return Vec::new();
    }
    let mut code = Lowering::new(graph, hoisted);
    let factor = factor(&mut code, derived);
    let mut list = vec![code.finish("factor_mass")];
    let mut code = Lowering::new(graph, hoisted);
    solve(&mut code, derived.system.size, &factor);
    list.push(code.finish("solve_mass"));
    if list.iter().any(|kernel| kernel.operations.len() > LONGEST) {
        return Vec::new();
    }
    // A row needs less than a full solution and its products with the others.
    let expected = list[1].operations.len() * derived.system.rows.len();
    if (1..=2 * LONGEST).contains(&expected) {
        let mut code = Lowering::new(graph, hoisted);
        metric(&mut code, derived, &factor);
        list.push(code.finish("metric"));
    }
    list
}

/// D⁻¹ and L at q, and the ratio of each diagonal entry to its pivot.
fn factor(code: &mut Lowering, derived: &Derived) -> Factor {
    let mass: Upper = derived
        .system
        .mass
        .iter()
        .map(|(&place, &entry)| (place, code.operand(entry)))
        .collect();
    let size = derived.system.size;
    let factor = Factor::new(code, size, mass, Rank::Full, "mass_pivot");
    for (place, value) in factor.entries().into_iter().enumerate() {
        code.write("factor", Place::Element(place), value);
    }
    for k in 0..size {
        let pivot_loss = factor.pivot_loss(code, k);
        code.write("pivot_loss", Place::Element(k), pivot_loss);
    }
    factor.stored()
}

/// x ← M⁻¹ x.
fn solve(code: &mut Lowering, size: usize, factor: &Factor) {
    let argument = |i: usize| (i, Operand::Symbol(Symbol::VectorEntry(i as u32)));
    let mut x: Sparse = (0..size).map(argument).collect();
    factor.solve(code, &mut x);
    for (i, value) in x {
        code.write("x", Place::Element(i), value);
    }
}

/// W = M⁻¹Aᵀ and S = A M⁻¹Aᵀ = Σ y yᵀ/d with y = L⁻¹Aᵀ.
fn metric(code: &mut Lowering, derived: &Derived, factor: &Factor) {
    let mut halves: Vec<[Sparse; 2]> = Vec::new();
    for (r, row) in rows(derived).iter().enumerate() {
        let argument = |j: usize| Operand::Symbol(Symbol::RowEntry(r as u32, j as u32));
        let row: Sparse = row.iter().map(|&(j, _)| (j, argument(j))).collect();
        halves.push(factor.halves(code, row));
    }
    for (r, [_, scaled]) in halves.iter().enumerate() {
        for (s, [other, _]) in halves.iter().enumerate().skip(r) {
            let entry = code.dot(scaled, other).unwrap_or(Operand::number(0.0));
            code.write("delassus", Place::Entry(r, s), entry);
            if s > r {
                code.write("delassus", Place::Entry(s, r), entry);
            }
        }
        let mut w = scaled.clone();
        factor.backward(code, &mut w);
        for (i, value) in w {
            code.write("w", Place::Entry(r, i), value);
        }
    }
}
