//! An elastic joint: springs and dampers in all six directions.

use super::{Action, Force, Load};
use crate::model::{Arguments, JointFrames, Point, Tensor, Vector};
use crate::symbolic::{Expr, Function, Graph};

#[derive(Debug)]
struct Bushing {
    frames: JointFrames,
    /// Angular velocity of the child against the parent, in the ground's axes.
    spin: Vector,
    stiffness: Tensor,
    damping: Tensor,
    torsion_stiffness: Tensor,
    torsion_damping: Tensor,
    cross_stiffness: Tensor,
}

pub(super) fn read(arguments: &mut Arguments) -> Option<Box<dyn Force>> {
    let frames = arguments.own_frames()?;
    let fields = [
        "stiffness",
        "damping",
        "torsion_stiffness",
        "torsion_damping",
        "cross_stiffness",
    ];
    if fields.iter().all(|field| !arguments.has(field)) {
        return arguments.fail(
            "",
            "this bushing does nothing; give it a `stiffness`, `damping`, `torsion_stiffness` or `torsion_damping`",
        );
    }
    let mut gains = Vec::new();
    for field in fields {
        gains.push(arguments.gains(field)?);
    }
    let [
        stiffness,
        damping,
        torsion_stiffness,
        torsion_damping,
        cross_stiffness,
    ] = gains.try_into().ok()?;
    let spins = [frames.child.point.owner, frames.parent.point.owner]
        .map(|owner| arguments.frame(owner).spin);
    Some(Box::new(Bushing {
        frames,
        spin: arguments.graph().vector_sub(spins[0], spins[1]),
        stiffness,
        damping,
        torsion_stiffness,
        torsion_damping,
        cross_stiffness,
    }))
}

impl Force for Bushing {
    /// V = ½ u·K u + ½ e·K_r e + u·C e with the displacement u and the turning e = 2 n sin(ψ/2), both in the parent's axes.
    fn action(&self, graph: &mut Graph) -> Action {
        let (parent, child) = (self.frames.parent.axes, self.frames.child.axes);
        let gap = graph.vector_sub(
            self.frames.child.point.position,
            self.frames.parent.point.position,
        );
        let displacement = graph.components(&parent, gap);
        let mut potential = quadratic(graph, &self.stiffness, displacement, displacement, 0.5);
        if needed(graph, &self.torsion_stiffness) || needed(graph, &self.cross_stiffness) {
            let turning = turning(graph, &parent, &child);
            let torsion = quadratic(graph, &self.torsion_stiffness, turning, turning, 0.5);
            let cross = quadratic(graph, &self.cross_stiffness, displacement, turning, 1.0);
            potential = graph.sum([potential, torsion, cross]);
        }
        let mut loads = Vec::new();
        let rates = graph.vector_rate(displacement);
        let spins = graph.components(&parent, self.spin);
        for (gain, rates) in [(&self.damping, rates), (&self.torsion_damping, spins)] {
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

    fn points(&self) -> Vec<&Point> {
        vec![&self.frames.parent.point, &self.frames.child.point]
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
fn turning(graph: &mut Graph, parent: &[Vector; 3], child: &[Vector; 3]) -> Vector {
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
