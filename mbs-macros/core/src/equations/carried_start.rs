//! The start of parts that the tree carries, where their declared velocities contradict its joints.
//!
//! Of the velocities that the joints allow, v = T q̇' + c, the nearest to the guess g of all parts (weighted by mass) is the one
//! that rows would give: q̇' = ġ' + M'⁻¹ Tᵀ M (g − T ġ' − c), in the pose of the guess. Nothing changes where the guess fulfils
//! the joints.

use super::inertia::{LocalMass, slopes};
use crate::model::{Layout, Model, vanishes};
use crate::symbolic::{Expr, Graph, Substitution, Symbol};
use std::collections::BTreeMap;

/// A velocity that is smaller than this, relative to the largest one of its unit, is round-off.
const ROUNDING: f64 = 1e-11;

/// The upper triangle of M.
type Mass = BTreeMap<(usize, usize), Expr>;

/// Moves the guessed velocities to the nearest ones that the joints allow.
pub(super) fn move_guesses(
    graph: &mut Graph,
    reduction: &mut Substitution,
    (model, inertia, mass): (&Model, &LocalMass, &Mass),
    layout: &mut Layout,
) {
    let gaps = gaps(graph, reduction, model);
    if gaps.is_empty() {
        return;
    }
    let mut at_guess = at_guess(graph, model);
    let mut pull = vec![Vec::new(); layout.velocities.len()];
    for (&(i, k), &mass) in inertia {
        let Some(&(_, gap)) = gaps.iter().find(|(local, _)| *local == k) else {
            continue;
        };
        let mass = graph.substitute(mass, reduction);
        let mass = graph.substitute(mass, &mut at_guess);
        for (j, slope) in slopes(graph, reduction, i) {
            let slope = graph.substitute(slope, &mut at_guess);
            pull[j].push(graph.product(&[(mass, 1), (slope, 1), (gap, 1)]));
        }
    }
    let pull: Vec<Expr> = pull.into_iter().map(|terms| graph.sum(terms)).collect();
    let moved = coupled(graph, mass, &pull);
    let entries = mass.iter();
    let entries = entries.filter(|((i, _), _)| moved.contains(i));
    let entries: Mass = entries
        .map(|(&slot, &entry)| (slot, graph.substitute(entry, &mut at_guess)))
        .collect();
    let right = moved.iter().map(|&i| (i, pull[i])).collect();
    for (i, change) in solve(graph, entries, &moved, right) {
        let guess = &mut layout.velocities[i].guess;
        *guess = graph.add(*guess, change);
    }
}

/// By how much the guessed velocity of each coordinate that the tree dropped exceeds the one that follows from its joints; empty
/// where all are as the joints demand.
fn gaps(graph: &mut Graph, reduction: &mut Substitution, model: &Model) -> Vec<(u32, Expr)> {
    let parameters = &model.outline.parameters;
    let mut at_guess = at_guess(graph, model);
    for (index, velocity) in (0..).zip(&model.layout.velocities) {
        at_guess.insert(Symbol::Velocity(index), velocity.guess);
    }
    let mut gaps = Vec::new();
    for &(local, guess) in &model.carried_velocities {
        let own = graph.symbol(Symbol::LocalVelocity(local));
        let follows = graph.substitute(own, reduction);
        let follows = graph.substitute(follows, &mut at_guess);
        let gap = graph.sub(guess, follows);
        let size = model.sizes.of(&model.outline.locals[local as usize].unit);
        let rounding = size.rates.map(|largest| ROUNDING * largest);
        if !vanishes(graph, parameters, gap, rounding) {
            gaps.push((local, gap));
        }
    }
    gaps
}

/// Positions and orientations at the guess, the inputs at their defaults, and t = 0.
fn at_guess(graph: &mut Graph, model: &Model) -> Substitution {
    let (layout, outline) = (&model.layout, &model.outline);
    let mut values = Substitution::nameless();
    values.insert(Symbol::Time, graph.zero());
    for (index, input) in (0..).zip(&outline.inputs) {
        values.insert(Symbol::Input(index), graph.constant(input.default));
    }
    for (index, &slot) in (0..).zip(&layout.slots) {
        values.insert(Symbol::Coordinate(index), layout.coordinates[slot].guess);
    }
    for (index, &(slot, _)) in (0..).zip(&layout.unwrapped_angles) {
        let guess = layout.coordinates[slot].guess;
        values.insert(Symbol::UnwrappedAngle(index), guess);
    }
    for rotation in &layout.rotations {
        let mut parts = outline.parts.iter();
        let home = parts.find_map(|part| part.home.filter(|_| part.name == rotation.part));
        for (entry, (row, column)) in (0..9u8).map(|entry| (entry, (entry / 3, entry % 3))) {
            let symbol = Symbol::Rotation(rotation.velocity as u32, entry);
            if let Some(home) = &home {
                values.insert(symbol, home.axes[usize::from(column)][usize::from(row)]);
            }
        }
    }
    values
}

/// The velocities that change where these are pulled: those that M couples with them.
fn coupled(graph: &Graph, mass: &Mass, pull: &[Expr]) -> Vec<usize> {
    let mut coupled: Vec<bool> = pull.iter().map(|&pull| !graph.is_zero(pull)).collect();
    let mut grown = true;
    while grown {
        grown = false;
        for &(i, j) in mass.keys() {
            if coupled[i] != coupled[j] {
                (coupled[i], coupled[j]) = (true, true);
                grown = true;
            }
        }
    }
    (0..pull.len()).filter(|&i| coupled[i]).collect()
}

/// M⁻¹ x by M = Lᵀ D L, where L has no more entries than the tree has branches: velocities of children are eliminated before those of
/// their parents.
fn solve(
    graph: &mut Graph,
    mut mass: Mass,
    order: &[usize],
    mut x: BTreeMap<usize, Expr>,
) -> BTreeMap<usize, Expr> {
    let mut factors: Vec<(usize, usize, Expr)> = Vec::new();
    for (place, &k) in order.iter().enumerate().rev() {
        let Some(&pivot) = mass.get(&(k, k)) else {
            continue;
        };
        let before = order[..place].iter();
        let column: Vec<(usize, Expr)> = before
            .filter_map(|&i| Some((i, *mass.get(&(i, k))?)))
            .collect();
        for (at, &(i, entry)) in column.iter().enumerate() {
            let factor = graph.div(entry, pivot);
            factors.push((i, k, factor));
            for &(j, other) in &column[at..] {
                let removed = graph.mul(factor, other);
                let left = mass.get(&(i, j)).copied();
                let left = left.unwrap_or_else(|| graph.zero());
                mass.insert((i, j), graph.sub(left, removed));
            }
            let removed = graph.mul(factor, x[&k]);
            x.insert(i, graph.sub(x[&i], removed));
        }
        x.insert(k, graph.div(x[&k], pivot));
    }
    for (i, k, factor) in factors.into_iter().rev() {
        let removed = graph.mul(factor, x[&i]);
        x.insert(k, graph.sub(x[&k], removed));
    }
    x
}
