//! An elastic joint: springs and dampers in all six directions.

use super::action::Action;
use crate::model::elements::force::{Bushing, Load};
use crate::model::{Tensor, Vector};
use crate::symbolic::{Expr, Function, Graph};

/// V = ½ u·K u + ½ e·K_r e + u·C e with the displacement u and the turning e = 2 n sin(ψ/2), both in the parent's axes.
pub(super) fn action(graph: &mut Graph, bushing: &Bushing) -> Action {
    let [parent, child] = bushing.axes;
    let gap = graph.vector_sub(bushing.origins[1], bushing.origins[0]);
    let displacement = graph.components(&parent, gap);
    let mut potential = quadratic(graph, &bushing.stiffness, displacement, displacement, 0.5);
    if needed(graph, &bushing.torsion_stiffness) || needed(graph, &bushing.cross_stiffness) {
        let turning = relative_rotation(graph, &parent, &child);
        let torsion = quadratic(graph, &bushing.torsion_stiffness, turning, turning, 0.5);
        let cross = quadratic(graph, &bushing.cross_stiffness, displacement, turning, 1.0);
        potential = graph.sum([potential, torsion, cross]);
    }
    let mut loads = Vec::new();
    let rates = graph.vector_rate(displacement);
    let spins = graph.components(&parent, bushing.spin);
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
        potential: (!graph.is_zero(potential)).then_some(potential),
        loads,
    }
}

fn needed(graph: &Graph, gain: &Tensor) -> bool {
    gain.as_flattened().iter().any(|&x| !graph.is_zero(x))
}

/// factor · a·K b.
fn quadratic(graph: &mut Graph, gain: &Tensor, a: Vector, b: Vector, factor: f64) -> Expr {
    let image = gain.map(|row| graph.dot(row, b));
    let energy = graph.dot(a, image);
    graph.scale(factor, energy)
}

/// 2 n sin(ψ/2) in the parent's axes: the axial vector n sin ψ of the relative rotation over cos(ψ/2) = ½ √(1 + trace).
fn relative_rotation(graph: &mut Graph, parent: &[Vector; 3], child: &[Vector; 3]) -> Vector {
    let relative: [[Expr; 3]; 3] =
        std::array::from_fn(|i| std::array::from_fn(|j| graph.dot(parent[i], child[j])));
    let trace: Vec<_> = (0..3).map(|k| (relative[k][k], 1.0)).collect();
    let trace = graph.linear(1.0, &trace);
    let root = graph.function(Function::Sqrt, trace);
    let one = graph.one();
    let inverse = graph.div(one, root);
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let twice = graph.sub(relative[j][i], relative[i][j]);
        graph.mul(inverse, twice)
    })
}
