//! An elastic joint: springs and dampers in all six directions.

use super::action::{Action, Potential};
use super::observer::Observer;
use crate::model::elements::bushing::{
    linear_in_rotation, quadratic, relative_rotation, trace, twice_axial,
};
use crate::model::elements::force::{Bushing, Load};
use crate::model::{Model, Tensor, Vector};
use crate::symbolic::{Expr, Function, Graph};

/// Its potential energy, as [`bushing`](crate::model::elements::bushing) has it, and its dampers.
pub(super) fn action(graph: &mut Graph, model: &Model, bushing: &Bushing) -> Action {
    let Bushing { parent, child, .. } = bushing;
    let observer = Observer::new(model, parent.point.owner);
    let [place, from] = [child, parent].map(|frame| observer.place(graph, &frame.point));
    let gap = graph.vector_sub(place, from);
    let displacement = graph.components(&parent.local, gap);
    let translation = quadratic(graph, &bushing.stiffness, displacement, displacement, 0.5);
    let mut potential = Potential::from(translation);
    if needed(graph, &bushing.torsion_stiffness) || needed(graph, &bushing.cross_stiffness) {
        let relative = relative_rotation(graph, &parent.axes, &child.axes);
        let twice = twice_axial(graph, &relative);
        let linear = linear_in_rotation(graph, &bushing.torsion_stiffness, &relative, 1.0);
        let torsion = torsion_energy(graph, bushing, &relative, (twice, linear));
        let cross = quadratic(graph, &bushing.cross_stiffness, displacement, twice, 0.5);
        potential = Potential {
            energy: graph.sum([translation, torsion, cross]),
            generator: graph.sum([translation, linear, cross]),
        };
    }
    let mut loads = Vec::new();
    let rates = observer.rate(graph, &child.point, place);
    let rates = graph.components(&parent.local, rates);
    let [spin, back] = [child, parent].map(|frame| observer.spin(graph, frame.point.owner));
    let spins = graph.vector_sub(spin, back);
    let spins = graph.components(&parent.local, spins);
    for (gain, rates) in [(&bushing.damping, rates), (&bushing.torsion_damping, spins)] {
        if !needed(graph, gain) {
            continue;
        }
        for (row, rate) in gain.iter().zip(rates) {
            let drag = graph.dot(*row, rates);
            let force = graph.neg(drag);
            if !graph.is_zero(force) {
                loads.push(Load { rate, force });
            }
        }
    }
    Action {
        potential: (!graph.is_zero(potential.energy)).then_some(potential),
        loads,
    }
}

fn needed(graph: &Graph, gain: &Tensor) -> bool {
    gain.as_flattened().iter().any(|&x| !graph.is_zero(x))
}

/// ½ e·K e. Up to a turn of 120° e = 2 n sin(ψ/2) is the axial vector n sin ψ over cos(ψ/2) = ½ √(1 + trace), which vanishes at
/// half a turn; beyond, the value is `linear`, that of [`linear_in_rotation`], which has no digits to lose there. (Near zero
/// `linear` is a small difference of large terms, but its derivatives are not.)
fn torsion_energy(
    graph: &mut Graph,
    bushing: &Bushing,
    relative: &Tensor,
    (twice, linear): (Vector, Expr),
) -> Expr {
    let one = graph.one();
    let trace = trace(graph, relative, 0.0, 1.0);
    let square = graph.add(one, trace);
    let square = graph.larger(square, one);
    let energy = quadratic(graph, &bushing.torsion_stiffness, twice, twice, 0.5);
    let energy = graph.div(energy, square);
    let is_near = graph.function(Function::Step, trace);
    let is_far = graph.sub(one, is_near);
    let parts = [graph.mul(is_near, energy), graph.mul(is_far, linear)];
    graph.sum(parts)
}
