//! The start where declared guesses contradict a row that was solved.
//!
//! Of all states that satisfy the rows, the one nearest to the guess (weighted by mass) is also nearest to the
//! projection of the guess onto the states that satisfy the eliminated rows. With q = T q' + c and the guess g of all
//! coordinates this projection is q' = g' + M'⁻¹ Tᵀ M (g − T g' − c): nothing changes where the guess fulfils these
//! rows.

use super::inertia::{LocalMass, slopes};
use super::inverse_mass::InverseMass;
use crate::model::{Layout, Model};
use crate::symbolic::{Expr, Graph, Substitution, Symbol};
use std::collections::BTreeMap;

/// Tᵀ M δ of positions and of velocities, δ = g − T g' − c; `None` where the guess fulfils all solved rows. For a constant M.
pub(super) fn pull(
    graph: &mut Graph,
    reduction: &mut Substitution,
    model: &Model,
    inertia: &LocalMass,
) -> Option<[Vec<Expr>; 2]> {
    let solved = &model.solved;
    let gaps: Vec<[Expr; 2]> = solved.coordinates.iter().map(|c| c.gap).collect();
    if gaps.iter().flatten().all(|&gap| graph.is_zero(gap)) {
        return None;
    }
    let size = model.layout.velocities.len();
    let mut terms = [0, 1].map(|_| vec![Vec::new(); size]);
    for (&(i, k), &mass) in inertia {
        let own = Symbol::LocalVelocity(k);
        let rate = solved.merged.get(own);
        let rate = rate.unwrap_or_else(|| graph.symbol(own));
        for (coordinate, gap) in solved.coordinates.iter().zip(&gaps) {
            let by = graph.derivative(rate, Symbol::LocalVelocity(coordinate.local));
            if graph.is_zero(by) {
                continue;
            }
            let mass = graph.substitute(mass, reduction);
            for (j, slope) in slopes(graph, reduction, i) {
                for (terms, &gap) in terms.iter_mut().zip(gap) {
                    terms[j].push(graph.product(&[(mass, 1), (slope, 1), (by, 1), (gap, 1)]));
                }
            }
        }
    }
    Some(terms.map(|list| list.into_iter().map(|terms| graph.sum(terms)).collect()))
}

/// Moves the guesses by M'⁻¹ times what pulls them.
pub(super) fn move_guesses(
    graph: &mut Graph,
    mass: &BTreeMap<(usize, usize), Expr>,
    layout: &mut Layout,
    pull: [Vec<Expr>; 2],
) {
    let inverse = InverseMass::new(layout.velocities.len(), mass);
    let [positions, velocities] = pull.map(|pull| inverse.apply(graph, &pull));
    for (i, (position, velocity)) in positions.into_iter().zip(velocities).enumerate() {
        let guess = &mut layout.coordinates[layout.slots[i]].guess;
        *guess = graph.add(*guess, position);
        let guess = &mut layout.velocities[i].guess;
        *guess = graph.add(*guess, velocity);
    }
}
