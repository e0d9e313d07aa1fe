//! Momentum, kinetic energy, and the affinities of the connection that M defines (paper, section 2).

use super::matrix::Matrix;
use crate::model::Rotation;
use crate::symbolic::{Expr, Graph, Length, Symbol};
use std::collections::BTreeMap;

/// Entries (i, j, k) that are not zero.
pub type Affinities = BTreeMap<(usize, usize, usize), Expr>;

/// Deriving affinities stops where their expressions have more operations than this: there are as many affinities as the
/// cube of the number of velocities. A function with more than half of it is not generated (`dag::functions`); the count
/// of expressions is coarser than that of the program that they become.
const LONGEST: usize = 5000;

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

/// All affinities; `None` where they are long. The derivation stops as soon as they are too long.
pub(super) fn affinities(
    graph: &mut Graph,
    rotations: &[Rotation],
    mass: &Matrix,
) -> Option<Affinities> {
    let mut length = Length::default();
    let slopes = slopes(graph, mass, &mut length)?;
    let mut affinities = christoffel(graph, &slopes);
    gyroscopic(graph, rotations, mass, &mut affinities);
    for &value in affinities.values() {
        length.add(graph, value);
        if length.operations() > LONGEST {
            return None;
        }
    }
    Some(affinities)
}

/// ∂M_ij/∂q_k, upper triangle; nothing at all where M is constant, and `None` where they are long.
fn slopes(graph: &mut Graph, mass: &Matrix, length: &mut Length) -> Option<Affinities> {
    let mut slopes = Affinities::new();
    for (&(i, j), &entry) in mass {
        for symbol in graph.directions([entry]) {
            if let Symbol::Coordinate(k) = symbol {
                let slope = graph.derivative(entry, symbol);
                slopes.insert((i, j, k as usize), slope);
                length.add(graph, slope);
                if length.operations() > LONGEST {
                    return None;
                }
            }
        }
    }
    Some(slopes)
}

/// Γ_ijk = ½ (∂M_ij/∂q_k + ∂M_ik/∂q_j − ∂M_jk/∂q_i): summed over the slopes of M, because few of them are not zero.
fn christoffel(graph: &mut Graph, slopes: &Affinities) -> Affinities {
    let mut terms: BTreeMap<(usize, usize, usize), Vec<(Expr, f64)>> = BTreeMap::new();
    for (&(row, column, k), &slope) in slopes {
        let both = [(row, column), (column, row)];
        for &(i, j) in &both[..if row == column { 1 } else { 2 }] {
            for (place, factor) in [((i, j, k), 0.5), ((i, k, j), 0.5), ((k, i, j), -0.5)] {
                terms.entry(place).or_default().push((slope, factor));
            }
        }
    }
    let mut affinities = Affinities::new();
    for (place, terms) in terms {
        let value = graph.linear(0.0, &terms);
        if !graph.is_zero(value) {
            affinities.insert(place, value);
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

/// p × ω of each rotation: the rate of the momentum in body axes due to the rotation of the axes (Boltzmann–Hamel
/// equations); zero for other velocities.
pub(super) fn turning_momentum(
    graph: &mut Graph,
    rotations: &[Rotation],
    momentum: &[Expr],
) -> Vec<Expr> {
    let mut turning = vec![graph.zero(); momentum.len()];
    for rotation in rotations {
        let first = rotation.velocity;
        for (a, b, c, sign) in PERMUTATIONS {
            let omega = graph.symbol(Symbol::Velocity((first + c) as u32));
            let term = graph.mul(momentum[first + b], omega);
            let term = graph.scale(sign, term);
            turning[first + a] = graph.add(turning[first + a], term);
        }
    }
    turning
}

/// Adds the structure constants of the rotations: ω × p = Γ_ijk v_j v_k, symmetric in j and k.
fn gyroscopic(
    graph: &mut Graph,
    rotations: &[Rotation],
    mass: &Matrix,
    affinities: &mut Affinities,
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
