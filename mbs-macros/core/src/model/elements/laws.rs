//! The forces of elements as functions of deflection, depth and rate.

use super::force::{Characteristic, Damping, Side, Stop};
use crate::model::geometry::Vector;
use crate::symbolic::{Expr, Function, Graph};

impl Characteristic {
    /// The force or torque that opposes a growing deflection.
    pub fn tension(&self, graph: &mut Graph, deflection: Expr, rate: Expr) -> Expr {
        let (elastic, damping) = match self {
            Characteristic::Linear {
                stiffness,
                damping,
                free,
            } => {
                let stretch = graph.sub(deflection, *free);
                (graph.mul(*stiffness, stretch), damping)
            }
            Characteristic::Table {
                table,
                damping,
                free,
            } => {
                let stretch = graph.sub(deflection, *free);
                (graph.table(table, 0, stretch), damping)
            }
            Characteristic::Law(law, others) => {
                let mut arguments = vec![deflection, rate];
                arguments.extend(others);
                return graph.law(*law, &arguments);
            }
        };
        let drag = damping.drag(graph, rate);
        graph.add(elastic, drag)
    }
}

impl Damping {
    /// The force of the damper.
    pub fn drag(&self, graph: &mut Graph, rate: Expr) -> Expr {
        match self {
            Damping::Linear(damping) => graph.mul(*damping, rate),
            Damping::Table(table) => graph.table(table, 0, rate),
        }
    }
}

/// The distance of two points, and its rate.
pub fn distance(graph: &mut Graph, from: Vector, to: Vector) -> [Expr; 2] {
    let difference = graph.vector_sub(to, from);
    let length = graph.norm(difference);
    [length, graph.rate(length)]
}

/// Depths in a stop from where it begins, and from where its stiffness is constant.
pub type Depths = [Expr; 2];

/// The stiffness grows from 0 to k over the onset δ, so that the energy of the depth d is k/(6δ) (d³ − (d − δ)³) and the
/// force k/(2δ) (d² − (d − δ)²), where d and d − δ count while they are positive. The damping force is the elastic one
/// times the dissipation and ḋ, and never pulls.
impl Stop {
    /// How deep the target is in the stop of this side, and the rate of that.
    pub fn depth(&self, graph: &mut Graph, side: &Side) -> (Depths, Expr) {
        let (depth, deepening) = match side.is_upper {
            true => (graph.sub(self.target, side.begin), self.rate),
            false => (graph.sub(side.begin, self.target), graph.neg(self.rate)),
        };
        ([depth, graph.sub(depth, self.onset)], deepening)
    }

    /// The energy of these depths.
    pub fn energy(&self, graph: &mut Graph, depths: Depths) -> Expr {
        let scale = graph.div(self.stiffness, self.onset);
        grown(graph, scale, depths, 3)
    }

    /// The elastic force at these depths.
    pub fn elastic(&self, graph: &mut Graph, depths: Depths) -> Expr {
        let scale = graph.div(self.stiffness, self.onset);
        grown(graph, scale, depths, 2)
    }

    /// The share of the elastic force that is left while the depth grows at this rate, max(c ḋ, −1) + 1, which is
    /// (c ḋ + 1) step(c ḋ + 1).
    pub fn share(&self, graph: &mut Graph, deepening: Expr) -> Expr {
        let damping = graph.mul(self.dissipation, deepening);
        let one = graph.one();
        let pushing = graph.add(damping, one);
        let positive = graph.function(Function::Step, pushing);
        graph.mul(pushing, positive)
    }

    /// The force along the target, positive from the stop below.
    pub fn force(&self, graph: &mut Graph) -> Expr {
        let mut forces = Vec::new();
        for side in &self.sides {
            let (depths, deepening) = self.depth(graph, side);
            let (elastic, share) = (self.elastic(graph, depths), self.share(graph, deepening));
            let push = graph.mul(elastic, share);
            forces.push(if side.is_upper { graph.neg(push) } else { push });
        }
        graph.sum(forces)
    }
}

/// scale/n! (d₁ⁿ − d₂ⁿ) of depths that count while they are positive.
fn grown(graph: &mut Graph, scale: Expr, depths: Depths, power: i32) -> Expr {
    let [near, far] = depths.map(|depth| {
        let inside = graph.function(Function::Step, depth);
        graph.product(&[(depth, power), (inside, 1)])
    });
    let difference = graph.sub(near, far);
    let product = graph.mul(scale, difference);
    graph.scale(if power == 3 { 1.0 / 6.0 } else { 0.5 }, product)
}
