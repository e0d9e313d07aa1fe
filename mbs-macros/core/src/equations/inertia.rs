//! Mass matrices: of each part in its own coordinates, and of the mechanism.

use crate::model::{Part, Representation, Vector};
use crate::symbolic::{Expr, Graph, Substitution, Symbol};
use std::collections::BTreeMap;

/// Entries of the parts' own mass matrices (both triangles), summed over parts.
pub(super) type LocalMass = BTreeMap<(u32, u32), Expr>;

/// The centre of mass of a part; `offset` is where it lies from the frame's origin.
pub(super) fn center_of(graph: &mut Graph, part: &Part, offset: Vector) -> Vector {
    match part.representation {
        // Exactly the coordinates, rather than origin + offset, which would not cancel where the origin has the offset.
        Representation::Reference => components(graph, &part.locals[..2]),
        Representation::Rigid => components(graph, &part.locals[..3]),
        Representation::Natural => {
            let (a, b) = part.locals.split_at(part.locals.len() / 2);
            let (a, b) = (components(graph, a), components(graph, b));
            std::array::from_fn(|k| graph.linear(0.0, &[(a[k], 0.5), (b[k], 0.5)]))
        }
        _ => graph.vector_add(part.frame.origin, offset),
    }
}

/// The point whose components are these locals.
fn components(graph: &mut Graph, locals: &[u32]) -> Vector {
    let mut point = graph.zero_vector();
    for (x, &local) in point.iter_mut().zip(locals) {
        *x = graph.symbol(Symbol::LocalPosition(local));
    }
    point
}

pub(super) fn local_mass<'p>(
    graph: &mut Graph,
    parts: impl IntoIterator<Item = &'p Part>,
) -> LocalMass {
    let mut mass = LocalMass::new();
    for part in parts {
        match part.representation {
            // A uniform rod between its ends: m/3 on the diagonal, m/6 across.
            Representation::Natural => {
                let (third, sixth) = (
                    graph.scale(1.0 / 3.0, part.mass),
                    graph.scale(1.0 / 6.0, part.mass),
                );
                let dimension = part.locals.len() / 2;
                for axis in 0..dimension {
                    let (a, b) = (part.locals[axis], part.locals[axis + dimension]);
                    for (i, k, value) in
                        [(a, a, third), (a, b, sixth), (b, a, sixth), (b, b, third)]
                    {
                        add(graph, &mut mass, (i, k), value);
                    }
                }
            }
            Representation::FreePoint => {
                part.locals
                    .iter()
                    .for_each(|&local| add(graph, &mut mass, (local, local), part.mass));
            }
            Representation::Reference => {
                let inertia = part.inertia[2][2];
                for (&local, value) in part.locals.iter().zip([part.mass, part.mass, inertia]) {
                    add(graph, &mut mass, (local, local), value);
                }
            }
            // m in space axes, J in body axes: constant, because the velocities are quasi-velocities.
            Representation::Rigid => {
                let (place, turns) = part.locals.split_at(3);
                for &local in place {
                    add(graph, &mut mass, (local, local), part.mass);
                }
                for (&i, row) in turns.iter().zip(&part.inertia) {
                    for (&k, &value) in turns.iter().zip(row) {
                        add(graph, &mut mass, (i, k), value);
                    }
                }
            }
            Representation::Prescribed => prescribed(graph, part, &mut mass),
            Representation::Coordinate | Representation::State => {}
        }
    }
    mass
}

/// m ∂c/∂sᵢ · ∂c/∂sₖ + J ∂θ/∂sᵢ ∂θ/∂sₖ over the coordinates that the part follows.
fn prescribed(graph: &mut Graph, part: &Part, mass: &mut LocalMass) {
    let offset = graph.turn(&part.frame.axes, part.center);
    let center = center_of(graph, part, offset);
    let angle = part.frame.angle.unwrap_or_else(|| graph.zero());
    let followed: Vec<u32> = graph
        .directions(center.into_iter().chain([angle]))
        .into_iter()
        .filter_map(|symbol| match symbol {
            Symbol::LocalPosition(local) => Some(local),
            _ => None,
        })
        .collect();
    let slopes: Vec<(Vector, Expr)> = followed
        .iter()
        .map(|&local| {
            let by = Symbol::LocalPosition(local);
            let slope = center.map(|x| graph.derivative(x, by));
            (slope, graph.derivative(angle, by))
        })
        .collect();
    for (i, a) in followed.iter().zip(&slopes) {
        for (k, b) in followed.iter().zip(&slopes) {
            let square = graph.planar_dot(a.0, b.0);
            let translation = graph.mul(part.mass, square);
            let rotation = graph.product(&[(part.inertia[2][2], 1), (a.1, 1), (b.1, 1)]);
            let value = graph.add(translation, rotation);
            add(graph, mass, (*i, *k), value);
        }
    }
}

fn add(graph: &mut Graph, mass: &mut LocalMass, slot: (u32, u32), value: Expr) {
    if graph.is_zero(value) {
        return;
    }
    let sum = match mass.get(&slot) {
        Some(&before) => graph.add(before, value),
        None => value,
    };
    mass.insert(slot, sum);
}

/// The upper triangle of M: entries of merged coordinates are added, those of constants are omitted, and those of
/// coordinates that depend on others are multiplied by their slopes.
pub(super) fn global_mass(
    graph: &mut Graph,
    reduction: &mut Substitution,
    local: &LocalMass,
) -> BTreeMap<(usize, usize), Expr> {
    let mut terms: BTreeMap<(usize, usize), Vec<Expr>> = BTreeMap::new();
    for (&(i, k), &value) in local {
        let [rows, columns] = [i, k].map(|local| slopes(graph, reduction, local));
        let value = graph.substitute(value, reduction);
        for &(row, by_row) in &rows {
            for &(column, by_column) in columns.iter().filter(|(column, _)| row <= *column) {
                let value = graph.product(&[(value, 1), (by_row, 1), (by_column, 1)]);
                terms.entry((row, column)).or_default().push(value);
            }
        }
    }
    let entries: Vec<_> = terms
        .into_iter()
        .map(|(slot, terms)| (slot, graph.sum(terms)))
        .collect();
    entries
        .into_iter()
        .filter(|&(_, value)| !graph.is_zero(value))
        .collect()
}

/// The generalized velocities on which that of a local coordinate depends, with its slopes.
pub(super) fn slopes(
    graph: &mut Graph,
    reduction: &Substitution,
    local: u32,
) -> Vec<(usize, Expr)> {
    let Some(rate) = reduction.get(Symbol::LocalVelocity(local)) else {
        return Vec::new();
    };
    let symbols = graph.symbols([rate]).into_iter();
    let velocities = symbols.filter_map(|symbol| match symbol {
        Symbol::Velocity(index) => Some((index as usize, graph.derivative(rate, symbol))),
        _ => None,
    });
    velocities.collect()
}
