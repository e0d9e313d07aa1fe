//! Generalized forces: of gravity, springs and loads.

use super::inertia::center_of;
use crate::model::Model;
use crate::model::elements::force::Load;
use crate::symbolic::{Expr, Graph, Symbol};

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

/// f_j = −∂V/∂q_j + Σ force · ∂rate/∂v_j.
pub(super) fn applied_forces(
    graph: &mut Graph,
    size: usize,
    potential: Expr,
    loads: &[Load],
) -> Vec<Expr> {
    (0..size as u32)
        .map(|j| {
            let slope = graph.derivative(potential, Symbol::Coordinate(j));
            let mut terms = vec![graph.neg(slope)];
            for load in loads {
                let lever = graph.derivative(load.rate, Symbol::Velocity(j));
                terms.push(graph.mul(load.force, lever));
            }
            graph.sum(terms)
        })
        .collect()
}

/// The same by gradients, whose cost does not grow with the number of coordinates: f = loads − ∂V/∂q.
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
        loads: &[Load],
    ) -> ForceParts {
        let mut potential_slopes = vec![graph.zero(); size];
        for (symbol, slope) in graph.gradient(potential) {
            if let Symbol::Coordinate(j) = symbol {
                potential_slopes[j as usize] = slope;
            }
        }
        let mut terms: Vec<Vec<Expr>> = vec![Vec::new(); size];
        for load in loads {
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

    pub(super) fn total(&self, graph: &mut Graph) -> Vec<Expr> {
        let pairs = self.loads.iter().zip(&self.potential_slopes);
        pairs
            .map(|(&load, &slope)| graph.sub(load, slope))
            .collect()
    }
}

/// Σ force · rate.
pub(super) fn power(graph: &mut Graph, loads: &[Load]) -> Expr {
    let terms: Vec<Expr> = loads
        .iter()
        .map(|load| graph.mul(load.force, load.rate))
        .collect();
    graph.sum(terms)
}
