//! Stops of a position.

use super::action::Action;
use crate::model::elements::force::{Load, Side, Stop};
use crate::symbolic::{Expr, Function, Graph};

/// The stiffness grows from 0 to k over the onset δ, so that the energy of the depth d is k/(6δ) (d³ − (d − δ)³) and the
/// force k/(2δ) (d² − (d − δ)²), where d and d − δ count while they are positive. The damping force is the elastic one
/// times the dissipation and ḋ, and never pulls.
pub(super) fn action(graph: &mut Graph, stop: &Stop) -> Action {
    let (mut energies, mut loads) = (Vec::new(), Vec::new());
    for side in &stop.sides {
        let (depth, deepening) = depth(graph, stop, side);
        let depths = [depth, graph.sub(depth, stop.onset)];
        let scale = graph.div(stop.stiffness, stop.onset);
        energies.push(grown(graph, scale, depths, 3));
        if graph.is_zero(stop.dissipation) {
            continue;
        }
        let elastic = grown(graph, scale, depths, 2);
        // max(c ḋ, −1) = (c ḋ + 1) step(c ḋ + 1) − 1
        let damping = graph.mul(stop.dissipation, deepening);
        let one = graph.one();
        let pushing = graph.add(damping, one);
        let positive = graph.function(Function::Step, pushing);
        let pushing = graph.mul(pushing, positive);
        let factor = graph.sub(pushing, one);
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

/// How deep the target is in the stop, and the rate of that.
fn depth(graph: &mut Graph, stop: &Stop, side: &Side) -> (Expr, Expr) {
    match side.is_upper {
        true => (graph.sub(stop.target, side.begin), stop.rate),
        false => (graph.sub(side.begin, stop.target), graph.neg(stop.rate)),
    }
}

/// scale/n! (d₁ⁿ − d₂ⁿ) of depths that count while they are positive.
fn grown(graph: &mut Graph, scale: Expr, depths: [Expr; 2], power: i32) -> Expr {
    let [near, far] = depths.map(|depth| {
        let inside = graph.function(Function::Step, depth);
        graph.product(&[(depth, power), (inside, 1)])
    });
    let difference = graph.sub(near, far);
    let product = graph.mul(scale, difference);
    graph.scale(if power == 3 { 1.0 / 6.0 } else { 0.5 }, product)
}
