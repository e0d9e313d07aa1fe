//! Momentum, kinetic energy, and the affinities of the connection that M defines (paper, section 2).

use super::Matrix;
use crate::model::Rotation;
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

/// T = Σ v_i (½ M_ii v_i + Σ_{j>i} M_ij v_j): each entry of M once, so that slopes of T have each of its slopes once.
pub(super) fn kinetic(graph: &mut Graph, size: usize, mass: &Matrix) -> Expr {
    let mut terms: Vec<Vec<Expr>> = vec![Vec::new(); size];
    for (&(i, j), &entry) in mass {
        let velocity = graph.symbol(Symbol::Velocity(j as u32));
        let term = graph.mul(entry, velocity);
        terms[i].push(graph.scale(if i == j { 0.5 } else { 1.0 }, term));
    }
    let mut rows = Vec::new();
    for (i, terms) in terms.into_iter().enumerate() {
        let velocity = graph.symbol(Symbol::Velocity(i as u32));
        let sum = graph.sum(terms);
        rows.push(graph.mul(velocity, sum));
    }
    graph.sum(rows)
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
        for symbol in graph.directions([entry]) {
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

/// ε_abc as (a, b, c, sign).
const PERMUTATIONS: [(usize, usize, usize, f64); 6] = [
    (0, 1, 2, 1.0),
    (1, 2, 0, 1.0),
    (2, 0, 1, 1.0),
    (0, 2, 1, -1.0),
    (2, 1, 0, -1.0),
    (1, 0, 2, -1.0),
];

/// Adds p × ω to the generalized inertial forces of each rotation: what the momentum in body axes changes by because the
/// axes turn (Boltzmann–Hamel equations).
pub(super) fn turning_momentum(
    graph: &mut Graph,
    rotations: &[Rotation],
    momentum: &[Expr],
    inertial: &mut [Expr],
) {
    for rotation in rotations {
        let first = rotation.velocity;
        for (a, b, c, sign) in PERMUTATIONS {
            let omega = graph.symbol(Symbol::Velocity((first + c) as u32));
            let term = graph.mul(momentum[first + b], omega);
            let term = graph.scale(sign, term);
            inertial[first + a] = graph.add(inertial[first + a], term);
        }
    }
}

/// Adds the structure constants of the rotations: ω × p = Γ_ijk v_j v_k, symmetric in j and k.
pub(super) fn gyroscopic(
    graph: &mut Graph,
    rotations: &[Rotation],
    mass: &Matrix,
    affinities: &mut BTreeMap<(usize, usize, usize), Expr>,
) {
    for rotation in rotations {
        let first = rotation.velocity;
        for (a, b, c, sign) in PERMUTATIONS {
            // −ε_abc p_b ω_c with p_b = Σ M_bj v_j
            let (row, turn) = (first + b, first + c);
            let entries: Vec<(usize, Expr)> = mass
                .iter()
                .filter_map(|(&(i, j), &entry)| match (i == row, j == row) {
                    (true, _) => Some((j, entry)),
                    (_, true) => Some((i, entry)),
                    _ => None,
                })
                .collect();
            for (column, entry) in entries {
                let half = graph.scale(-0.5 * sign, entry);
                for (j, k) in [(column, turn), (turn, column)] {
                    let slot = (first + a, j, k);
                    let value = match affinities.get(&slot) {
                        Some(&before) => graph.add(before, half),
                        None => half,
                    };
                    affinities.insert(slot, value);
                }
            }
        }
    }
    affinities.retain(|_, value| !graph.is_zero(*value));
}
