//! Generalized forces: of gravity, springs and loads.

use super::forces::Potential;
use super::inertia::center_of;
use crate::model::Model;
use crate::model::elements::force::Load;
use crate::symbolic::{Expr, Function, Graph, Symbol};

/// V = −Σ m g · c.
pub(super) fn gravity_potential(graph: &mut Graph, model: &Model) -> Expr {
    let mut terms = Vec::new();
    for part in &model.outline.parts {
        let offset = graph.turn(&part.frame.axes, part.center);
        let center = center_of(graph, part, offset);
        let along = graph.dot(model.gravity, center);
        let energy = graph.mul(part.mass, along);
        terms.push(graph.neg(energy));
    }
    graph.sum(terms)
}

/// More force elements keep their sums apart: equal ones have the same code then, which is written once.
const MANY: usize = 8;

/// The force elements: potentials and loads of each, in generalized coordinates.
pub(super) struct Elements {
    pub potentials: Vec<Potential>,
    pub loads: Vec<Vec<Load>>,
}

/// A load by its element.
#[derive(Clone, Copy)]
struct Along {
    element: usize,
    at: usize,
}

impl Elements {
    /// A sum of one element.
    fn own(&self, graph: &mut Graph, sum: Expr) -> Expr {
        match self.loads.len() > MANY {
            true => graph.function(Function::Apart, sum),
            false => sum,
        }
    }

    /// For each velocity the loads whose rates change along it, in order: all derivatives together take time in proportion
    /// to the loads.
    fn loads_along(&self, graph: &Graph, size: usize) -> Vec<Vec<Along>> {
        let mut along = vec![Vec::new(); size];
        for (element, loads) in self.loads.iter().enumerate() {
            for (at, load) in loads.iter().enumerate() {
                for symbol in graph.directions([load.rate]) {
                    if let Symbol::Velocity(j) = symbol {
                        along[j as usize].push(Along { element, at });
                    }
                }
            }
        }
        along
    }

    /// V in one of its forms, where that of gravity is known.
    pub(super) fn potential(
        &self,
        graph: &mut Graph,
        gravity: Expr,
        form: fn(&Potential) -> Expr,
    ) -> Expr {
        let own = self.potentials.iter().map(form);
        let mut terms: Vec<Expr> = own.map(|energy| self.own(graph, energy)).collect();
        terms.insert(0, gravity);
        graph.sum(terms)
    }
}

/// Applied forces f = loads − ∂V/∂q.
#[derive(Debug)]
pub struct ForceParts {
    /// ∂V/∂q.
    pub potential_slopes: Vec<Expr>,
    /// Σ force · ∂rate/∂v.
    pub loads: Vec<Expr>,
}

impl ForceParts {
    pub(super) fn new(
        graph: &mut Graph,
        size: usize,
        potential: Expr,
        elements: &Elements,
    ) -> ForceParts {
        let velocities = 0..size as u32;
        let along = elements.loads_along(graph, size);
        let load = |graph: &mut Graph, j: u32| {
            let loads = along[j as usize].chunk_by(|a, b| a.element == b.element);
            let sums = loads.map(|own| {
                let terms = own.iter().map(|&Along { element, at }| {
                    let load = &elements.loads[element][at];
                    let lever = graph.derivative(load.rate, Symbol::Velocity(j));
                    graph.mul(load.force, lever)
                });
                let terms: Vec<Expr> = terms.collect();
                let sum = graph.sum(terms);
                elements.own(graph, sum)
            });
            let sums: Vec<Expr> = sums.collect();
            graph.sum(sums)
        };
        ForceParts {
            potential_slopes: velocities
                .clone()
                .map(|j| graph.derivative(potential, Symbol::Coordinate(j)))
                .collect(),
            loads: velocities.map(|j| load(graph, j)).collect(),
        }
    }

    /// The same by gradients, whose cost does not grow with the number of coordinates.
    pub(super) fn by_gradients(
        graph: &mut Graph,
        size: usize,
        potential: Expr,
        elements: &Elements,
    ) -> ForceParts {
        let mut potential_slopes = vec![graph.zero(); size];
        for (symbol, slope) in graph.gradient(potential) {
            if let Symbol::Coordinate(j) = symbol {
                potential_slopes[j as usize] = slope;
            }
        }
        let mut terms: Vec<Vec<Expr>> = vec![Vec::new(); size];
        for load in elements.loads.iter().flatten() {
            for (symbol, lever) in graph.gradient(load.rate) {
                if let Symbol::Velocity(j) = symbol {
                    terms[j as usize].push(graph.mul(load.force, lever));
                }
            }
        }
        ForceParts {
            potential_slopes,
            loads: terms.into_iter().map(|terms| graph.sum(terms)).collect(),
        }
    }

    /// f.
    pub(super) fn total(&self, graph: &mut Graph) -> Vec<Expr> {
        let pairs = self.loads.iter().zip(&self.potential_slopes);
        pairs
            .map(|(&load, &slope)| graph.sub(load, slope))
            .collect()
    }
}

/// Σ force · rate.
pub(super) fn power(graph: &mut Graph, elements: &Elements) -> Expr {
    let loads = elements.loads.iter().flatten();
    let terms: Vec<Expr> = loads.map(|load| graph.mul(load.force, load.rate)).collect();
    graph.sum(terms)
}
