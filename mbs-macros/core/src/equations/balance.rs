//! What acts on the parts, in their own coordinates, and what they need from joints.

use super::forces::Action;
use super::inertia::{LocalMass, center_of};
use super::system::Row;
use crate::model::{Model, Part, Representation, Vector};
use crate::symbolic::{Expr, Graph, Symbol};
use std::collections::BTreeMap;

/// Everything that acts on the parts, in their own coordinates.
pub(super) struct Balance<'a> {
    pub inertia: &'a LocalMass,
    /// Entries of it that depend on positions.
    pub varying: Vec<((u32, u32), Expr)>,
    pub potential: Expr,
    /// What the force elements contribute.
    pub actions: &'a [Action],
    pub rows: &'a [Row],
    /// Those that change along a coordinate.
    pub rows_along: BTreeMap<Symbol, Vec<usize>>,
    /// Rows that were solved, in local coordinates.
    pub solved: &'a [Expr],
    pub model: &'a Model,
}

/// The entries of the mass matrix that depend on positions.
pub(super) fn varying(graph: &Graph, inertia: &LocalMass) -> Vec<((u32, u32), Expr)> {
    let entries = inertia.iter().map(|(&place, &mass)| (place, mass));
    let varies = |mass: Expr| graph.depends_on(mass, Symbol::is_local_position);
    entries.filter(|&(_, mass)| varies(mass)).collect()
}

/// The rows that change along each symbol, in order.
pub(super) fn rows_along(graph: &Graph, rows: &[Row]) -> BTreeMap<Symbol, Vec<usize>> {
    let mut along: BTreeMap<Symbol, Vec<usize>> = BTreeMap::new();
    for (index, row) in rows.iter().enumerate() {
        for symbol in graph.directions([row.local]) {
            along.entry(symbol).or_default().push(index);
        }
    }
    along
}

impl Balance<'_> {
    /// The force that local coordinate `local` needs from joints without rows: M s̈ + ∂V/∂s − Q − Aᵀλ.
    pub fn needed(&self, graph: &mut Graph, local: u32) -> Expr {
        let mut terms = vec![self.unsolved(graph, local)];
        for (index, &row) in self.solved.iter().enumerate() {
            let slope = graph.derivative(row, Symbol::LocalPosition(local));
            let multiplier = graph.symbol(self.multiplier(index));
            let force = graph.mul(slope, multiplier);
            terms.push(graph.neg(force));
        }
        graph.sum(terms)
    }

    /// The multiplier of an eliminated row; its index comes after those of all other rows.
    pub fn multiplier(&self, solved: usize) -> Symbol {
        Symbol::Multiplier((self.rows.len() + solved) as u32)
    }

    /// The same, and what it needs from rows that were solved.
    fn unsolved(&self, graph: &mut Graph, local: u32) -> Expr {
        let mut terms = vec![self.convective(graph, local)];
        for (&(_, other), &mass) in self.inertia.range((local, 0)..=(local, u32::MAX)) {
            let acceleration = graph.symbol(Symbol::LocalAcceleration(other));
            terms.push(graph.mul(mass, acceleration));
        }
        terms.push(graph.derivative(self.potential, Symbol::LocalPosition(local)));
        for load in self.actions.iter().flat_map(|action| &action.loads) {
            let lever = graph.derivative(load.rate, Symbol::LocalVelocity(local));
            if graph.is_zero(lever) {
                continue;
            }
            let force = graph.mul(load.force, lever);
            terms.push(graph.neg(force));
        }
        let along = [Symbol::LocalPosition(local), Symbol::LocalVelocity(local)];
        let touched = along.map(|symbol| self.rows_along.get(&symbol));
        let mut touched: Vec<usize> = touched.into_iter().flatten().flatten().copied().collect();
        touched.sort_unstable();
        touched.dedup();
        for index in touched {
            let row = &self.rows[index];
            let by = match row.kind.is_holonomic() {
                true => Symbol::LocalPosition(local),
                false => Symbol::LocalVelocity(local),
            };
            let slope = graph.derivative(row.local, by);
            if graph.is_zero(slope) {
                continue;
            }
            let multiplier = graph.symbol(Symbol::Multiplier(index as u32));
            let force = graph.mul(slope, multiplier);
            terms.push(graph.neg(force));
        }
        graph.sum(terms)
    }

    /// Ṁ ṡ − ∂T/∂s, where mass depends on position.
    fn convective(&self, graph: &mut Graph, local: u32) -> Expr {
        let speed = |graph: &mut Graph, local| graph.symbol(Symbol::LocalVelocity(local));
        let mut terms = Vec::new();
        for &((i, j), mass) in &self.varying {
            let slope = graph.derivative(mass, Symbol::LocalPosition(local));
            if !graph.is_zero(slope) {
                let speeds = [i, j].map(|local| speed(graph, local));
                let square = graph.mul(speeds[0], speeds[1]);
                let energy = graph.mul(slope, square);
                terms.push(graph.scale(-0.5, energy));
            }
            if i == local {
                let (rate, speed) = (graph.rate(mass), speed(graph, j));
                terms.push(graph.mul(rate, speed));
            }
        }
        graph.sum(terms)
    }

    /// ω × ∂T/∂ω of a part that turns in space, in its axes: of its own J ω, and of parts that follow it.
    fn gyroscopic_torque(&self, graph: &mut Graph, first: u32) -> Vector {
        let omega = [0, 1, 2].map(|k| graph.symbol(Symbol::LocalVelocity(first + k)));
        let spin = [0, 1, 2].map(|k| {
            let row = self.inertia.range((first + k, 0)..=(first + k, u32::MAX));
            let terms = row.map(|(&(_, other), &mass)| {
                let speed = graph.symbol(Symbol::LocalVelocity(other));
                graph.mul(mass, speed)
            });
            let terms: Vec<Expr> = terms.collect();
            graph.sum(terms)
        });
        graph.cross(omega, spin)
    }

    /// The multipliers of the eliminated rows, λ_r = Σ_c (∂c/∂r) f_c: f_c is the force that solved coordinate c
    /// needs, and ∂c/∂r by how much c moves where row r is off by one.
    pub fn recovered(&self, graph: &mut Graph) -> Vec<Expr> {
        let coordinates = &self.model.solved.coordinates;
        let mut sums: Vec<Vec<Expr>> = vec![Vec::new(); coordinates.len()];
        for coordinate in coordinates {
            let needed = self.needed_along(graph, coordinate.local);
            for (terms, &answer) in sums.iter_mut().zip(&coordinate.answers) {
                terms.push(graph.mul(answer, needed));
            }
        }
        sums.into_iter().map(|terms| graph.sum(terms)).collect()
    }

    /// The force that an eliminated coordinate, with all local coordinates that it stands for, needs from the
    /// eliminated rows.
    fn needed_along(&self, graph: &mut Graph, coordinate: u32) -> Expr {
        let along = Symbol::LocalVelocity(coordinate);
        let mut terms = Vec::new();
        for part in &self.model.outline.parts {
            let gyroscopic = part.rotation().map(|first| {
                let gyroscopic = self.gyroscopic_torque(graph, first);
                (first, gyroscopic)
            });
            for &local in &part.locals {
                let own = Symbol::LocalVelocity(local);
                let rate = match self.model.solved.merged.get(own) {
                    Some(rate) => rate,
                    None => graph.symbol(own),
                };
                let slope = graph.derivative(rate, along);
                if graph.is_zero(slope) {
                    continue;
                }
                let mut needed = self.unsolved(graph, local);
                if let Some((first, gyroscopic)) = gyroscopic
                    && local >= first
                {
                    needed = graph.add(needed, gyroscopic[(local - first) as usize]);
                }
                terms.push(graph.mul(slope, needed));
            }
        }
        graph.sum(terms)
    }

    /// Force and torque about a point that a part needs from joints, in the ground's axes.
    pub fn wrench(&self, graph: &mut Graph, part: &Part, about: Vector) -> [Vector; 2] {
        let zero = graph.zero();
        let mut force = graph.zero_vector();
        for (k, &local) in part.locals[..self.model.outline.world.dimension()]
            .iter()
            .enumerate()
        {
            force[k] = self.needed(graph, local);
        }
        let torque = match (part.rotation(), part.representation) {
            (Some(first), _) => {
                let own = [0, 1, 2].map(|k| self.needed(graph, first + k));
                // … and ω × J ω, because the axes turn.
                let gyroscopic = self.gyroscopic_torque(graph, first);
                let own = graph.vector_add(own, gyroscopic);
                graph.turn(&part.frame.axes, own)
            }
            (None, Representation::Reference) => [zero, zero, self.needed(graph, part.locals[2])],
            _ => [zero; 3],
        };
        let offset = graph.turn(&part.frame.axes, part.center);
        let center = center_of(graph, part, offset);
        let arm = graph.vector_sub(center, about);
        let lever = graph.cross(arm, force);
        [force, graph.vector_add(torque, lever)]
    }
}
