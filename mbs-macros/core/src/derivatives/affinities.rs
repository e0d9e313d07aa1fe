//! Momentum, kinetic energy, and the affinities of the connection that M defines (paper, section 2).

use super::Matrix;
use crate::symbolic::{Expr, Graph, Symbol};
use std::collections::BTreeMap;

/// p = M v.
pub(super) fn momentum(graph: &mut Graph, size: usize, mass: &Matrix) -> Vec<Expr> {
    let mut terms: Vec<Vec<Expr>> = vec![Vec::new(); size];
    for (&(i, j), &entry) in mass {
        for (row, column) in if i == j {
            vec![(i, j)]
        } else {
            vec![(i, j), (j, i)]
        } {
            let velocity = graph.symbol(Symbol::Velocity(column as u32));
            terms[row].push(graph.mul(entry, velocity));
        }
    }
    terms.into_iter().map(|terms| graph.sum(terms)).collect()
}

/// T = ½ p·v.
pub(super) fn kinetic(graph: &mut Graph, momentum: &[Expr]) -> Expr {
    let terms: Vec<Expr> = momentum
        .iter()
        .enumerate()
        .map(|(i, &p)| {
            let velocity = graph.symbol(Symbol::Velocity(i as u32));
            graph.mul(velocity, p)
        })
        .collect();
    let sum = graph.sum(terms);
    graph.scale(0.5, sum)
}

/// Γ_ijk = ½ (∂M_ij/∂q_k + ∂M_ik/∂q_j − ∂M_jk/∂q_i).
pub(super) fn christoffel(
    graph: &mut Graph,
    size: usize,
    mass: &Matrix,
) -> BTreeMap<(usize, usize, usize), Expr> {
    // ∂M_ij/∂q_k, upper triangle; nothing at all where M is constant.
    let mut slopes: BTreeMap<(usize, usize, usize), Expr> = BTreeMap::new();
    for (&(i, j), &entry) in mass {
        for symbol in graph.symbols([entry]) {
            if let Symbol::Coordinate(k) = symbol {
                slopes.insert((i, j, k as usize), graph.derivative(entry, symbol));
            }
        }
    }
    let mut affinities = BTreeMap::new();
    if slopes.is_empty() {
        return affinities;
    }
    let slope = |i: usize, j: usize, k: usize| slopes.get(&(i.min(j), i.max(j), k)).copied();
    for i in 0..size {
        for j in 0..size {
            for k in 0..size {
                let terms: Vec<(Expr, f64)> = [
                    (slope(i, j, k), 0.5),
                    (slope(i, k, j), 0.5),
                    (slope(j, k, i), -0.5),
                ]
                .into_iter()
                .filter_map(|(term, sign)| Some((term?, sign)))
                .collect();
                let value = graph.linear(0.0, &terms);
                if !graph.is_zero(value) {
                    affinities.insert((i, j, k), value);
                }
            }
        }
    }
    affinities
}
