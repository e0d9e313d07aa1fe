//! Stops of a position.

use super::action::Action;
use crate::model::elements::force::{Load, Stop};
use crate::symbolic::Graph;

/// The energy of the depths, and the damping force.
pub(super) fn action(graph: &mut Graph, stop: &Stop) -> Action {
    let (mut energies, mut loads) = (Vec::new(), Vec::new());
    for side in &stop.sides {
        let (depths, deepening) = stop.depth(graph, side);
        energies.push(stop.energy(graph, depths));
        if graph.is_zero(stop.dissipation) {
            continue;
        }
        let elastic = stop.elastic(graph, depths);
        let share = stop.share(graph, deepening);
        let one = graph.one();
        let factor = graph.sub(share, one);
        let force = graph.mul(elastic, factor);
        loads.push(Load {
            rate: deepening,
            force: graph.neg(force),
        });
    }
    let energy = graph.sum(energies);
    Action {
        potential: Some(energy.into()),
        loads,
    }
}
