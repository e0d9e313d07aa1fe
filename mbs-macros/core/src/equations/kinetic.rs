//! The kinetic energy of joint coordinates, body by body.

use super::inertia::local_mass;
use crate::model::Model;
use crate::symbolic::{Expr, Graph, Length, Substitution, Symbol};
use std::collections::{BTreeMap, BTreeSet};

/// T for joint coordinates: ½ (m v·v + ω·Jω) of each part of the tree, and ½ ṡ·M ṡ of all other parts, also of those that follow parts
/// of the tree.
pub(super) fn energy(
    graph: &mut Graph,
    reduction: &mut Substitution,
    model: &Model,
) -> Option<Expr> {
    if model.twists.is_empty() {
        return None;
    }
    let mut terms = Vec::new();
    let mut carried: BTreeSet<usize> = BTreeSet::new();
    for twist in &model.twists {
        let part = &model.outline.parts[twist.part];
        carried.insert(twist.part);
        let square = graph.dot(twist.velocity, twist.velocity);
        terms.push(graph.mul(part.mass, square));
        let spin = twist.inertia.map(|row| graph.dot(row, twist.omega));
        terms.push(graph.dot(twist.omega, spin));
    }
    let parts = model.outline.parts.iter().enumerate();
    let others = parts.filter(|(index, _)| !carried.contains(index));
    let mass = local_mass(graph, others.map(|(_, part)| part));
    for ((i, k), mass) in mass {
        let rates = [i, k].map(|local| {
            let rate = graph.symbol(Symbol::LocalVelocity(local));
            graph.substitute(rate, reduction)
        });
        let mass = graph.substitute(mass, reduction);
        let rates = graph.mul(rates[0], rates[1]);
        terms.push(graph.mul(mass, rates));
    }
    let sum = graph.sum(terms);
    Some(graph.scale(0.5, sum))
}

/// Entries of M.
type Mass = BTreeMap<(usize, usize), Expr>;

/// T with its slopes, from one pass backwards through it.
#[derive(Debug)]
pub struct Kinetic {
    /// T.
    pub energy: Expr,
    /// p = ∂T/∂v.
    pub momentum: Vec<Expr>,
    /// ∂T/∂q.
    pub slopes: Vec<Expr>,
}

impl Kinetic {
    pub(super) fn new(graph: &mut Graph, size: usize, energy: Expr) -> Kinetic {
        let zero = graph.zero();
        let mut kinetic = Kinetic {
            energy,
            momentum: vec![zero; size],
            slopes: vec![zero; size],
        };
        for (symbol, slope) in graph.gradient(energy) {
            match symbol {
                Symbol::Velocity(i) => kinetic.momentum[i as usize] = slope,
                Symbol::Coordinate(i) => kinetic.slopes[i as usize] = slope,
                _ => {}
            }
        }
        kinetic
    }

    /// The upper triangle of M, from momenta or from composite bodies: the shorter.
    pub(super) fn mass(&self, graph: &mut Graph) -> Mass {
        let by_momenta = self.mass_by_momenta(graph);
        let by_composite_bodies = self.mass_by_composite_bodies(graph);
        let operations = |mass: &Mass| Length::of(graph, mass.values());
        match by_composite_bodies {
            Some(other) if operations(&other) < operations(&by_momenta) => other,
            _ => by_momenta,
        }
    }

    /// ∂p/∂v. Of the two equal entries that of the later momentum is taken: fewer bodies contribute to it.
    fn mass_by_momenta(&self, graph: &mut Graph) -> Mass {
        let mut mass = BTreeMap::new();
        for (j, &p) in self.momentum.iter().enumerate() {
            for i in 0..=j {
                let entry = graph.derivative(p, Symbol::Velocity(i as u32));
                if !graph.is_zero(entry) {
                    mass.insert((i, j), entry);
                }
            }
        }
        mass
    }

    /// ∂²T/∂v² by one pass backwards.
    fn mass_by_composite_bodies(&self, graph: &mut Graph) -> Option<Mass> {
        let is_velocity = |symbol| matches!(symbol, Symbol::Velocity(_));
        let hessian = graph.hessian(self.energy, is_velocity)?;
        let entries = hessian.into_iter().map(|(pair, entry)| match pair {
            (Symbol::Velocity(i), Symbol::Velocity(j)) => Some(((i as usize, j as usize), entry)),
            _ => None,
        });
        entries.collect()
    }
}
