//! States: velocities with a mass of 1, which T and the power of the forces leave out.

use super::generalized_forces::ForceParts;
use super::kinetic::Kinetic;
use crate::model::{Model, ScalarState};
use crate::symbolic::{Expr, Graph, Substitution, Symbol};
use std::collections::BTreeMap;

/// The velocities that are states, each with its rate.
pub(super) struct States(Vec<(usize, Expr)>);

impl States {
    pub(super) fn new(graph: &mut Graph, reduction: &mut Substitution, model: &Model) -> States {
        let velocities = model.layout.states.iter().copied();
        let rates = model.outline.states.iter().map(|state| state.rate);
        let rates = rates.map(|rate| graph.substitute(rate, reduction));
        States(velocities.zip(rates).collect())
    }

    /// Adds their rates to the forces, and their masses to M and to p.
    pub(super) fn join(
        &self,
        graph: &mut Graph,
        forces: &mut ForceParts,
        mass: &mut BTreeMap<(usize, usize), Expr>,
        kinetic: Option<&mut Kinetic>,
    ) {
        for &(velocity, rate) in &self.0 {
            forces.loads[velocity] = rate;
            mass.insert((velocity, velocity), graph.one());
        }
        if let Some(kinetic) = kinetic {
            for &(velocity, _) in &self.0 {
                kinetic.momentum[velocity] = graph.symbol(Symbol::Velocity(velocity as u32));
            }
        }
    }
}

/// The values whose sizes are the scales of the states, if one of them depends on parameters.
pub(super) fn scales(graph: &Graph, states: &[ScalarState]) -> Vec<Expr> {
    let is_parameter = |symbol: Symbol| matches!(symbol, Symbol::Parameter(_));
    let values: Vec<Expr> = states.iter().map(|state| state.scaled_by).collect();
    let follow = (values.iter()).any(|&value| graph.depends_on(value, is_parameter));
    if follow { values } else { Vec::new() }
}
