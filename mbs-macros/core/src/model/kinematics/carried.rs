//! Joints of space that carry the orientation of the child: turns about their axes.

use super::{Rates, State, Walk};
use crate::model::alignment::aligned;
use crate::model::geometry::{Axes, Vector};
use crate::model::mobilizer::{Freedom, transposed};
use crate::model::tree::{Tree, TreeJoint};
use crate::symbolic::{Expr, Function, Symbol};

/// What a joint makes of the state of its parent.
pub(super) struct Carried {
    /// As in [`State`].
    pub axes: Axes,
    /// As in [`State`].
    pub fixed: Axes,
    /// Angular velocity and acceleration of the child.
    pub turn: Rates,
    /// Of the joint.
    pub rates: Rates,
}

impl Walk<'_> {
    /// A child that turns about axes of the joint at most; `outer` are the axes of the joint in those of the parent's
    /// state, `rates` the joint's velocity and acceleration.
    pub(super) fn carried(
        &mut self,
        tree: &Tree,
        joint: &TreeJoint,
        parent: &State,
        outer: &Axes,
        rates: Rates,
    ) -> Carried {
        let inner = joint.mobilizer.child.local;
        let mut turns = joint
            .freedoms()
            .filter(|(freedom, _)| freedom.turns())
            .peekable();
        if turns.peek().is_none() {
            // The child keeps the axes of the parent's state.
            let fixed = self
                .graph
                .composed_constants(&transposed(&inner), &transposed(outer));
            return Carried {
                axes: parent.axes,
                fixed,
                turn: [parent.omega, parent.alpha],
                rates,
            };
        }
        let mut axes = self.graph.compose(&parent.axes, outer);
        let vectors = [parent.omega, parent.alpha, rates[0], rates[1]];
        let mut vectors = vectors.map(|v| self.graph.components(outer, v));
        let mut fixed = inner;
        let mut place = 0;
        while let Some((freedom, local)) = turns.next() {
            if let Freedom::Turn(Some(between)) = freedom {
                axes = self.graph.compose(&axes, between);
                vectors = vectors.map(|v| self.graph.components(between, v));
            }
            let name = match place {
                0 => joint.joint.clone(),
                _ => format!("{}_second", joint.joint),
            };
            place += 1;
            let is_last = turns.peek().is_none();
            let aligned = is_last.then(|| {
                let part = &self.parts[joint.child];
                aligned(self.graph, tree, joint, part, &inner)
            });
            let mut angle = self.motion(joint, Symbol::LocalPosition(local));
            let rates = [
                self.motion(joint, Symbol::LocalVelocity(local)),
                self.motion(joint, Symbol::LocalAcceleration(local)),
            ];
            if let Some((offset, turned)) = aligned.flatten() {
                angle = self.graph.add(angle, offset);
                fixed = turned;
            }
            (axes, vectors) = self.turned(&name, (angle, rates), axes, vectors);
        }
        if fixed.iter().any(|&axis| self.graph.numbers(axis).is_none()) {
            // Axes that depend on parameters have entries that no number folds with: those of the part are as short.
            let own = transposed(&fixed);
            axes = self.graph.compose(&axes, &own);
            vectors = vectors.map(|v| self.graph.turn(&fixed, v));
            fixed = self.graph.ground_axes();
        }
        let [omega, alpha, velocity, acceleration] = vectors;
        Carried {
            axes,
            fixed,
            turn: [omega, alpha],
            rates: [velocity, acceleration],
        }
    }

    /// Axes turned about their z by an angle, and vectors in components of the former in those of the latter: ω, α, to which
    /// the turn adds its own, a velocity and an acceleration.
    fn turned(
        &mut self,
        name: &str,
        (angle, [rate, second]): (Expr, [Expr; 2]),
        [x, y, z]: Axes,
        vectors: [Vector; 4],
    ) -> (Axes, [Vector; 4]) {
        let graph = &mut *self.graph;
        let (cos, sin) = (
            graph.function(Function::Cos, angle),
            graph.function(Function::Sin, angle),
        );
        graph.suggest_name(cos, format!("cos_{name}"));
        graph.suggest_name(sin, format!("sin_{name}"));
        let mut mixed = |a: Expr, b: Expr| {
            let (first, second) = (graph.mul(cos, a), graph.mul(sin, b));
            let sum = graph.add(first, second);
            let (first, second) = (graph.mul(cos, b), graph.mul(sin, a));
            (sum, graph.sub(first, second))
        };
        let pairs: [(Expr, Expr); 3] = std::array::from_fn(|k| mixed(x[k], y[k]));
        let axes = [pairs.map(|pair| pair.0), pairs.map(|pair| pair.1), z];
        let [mut omega, mut alpha, velocity, acceleration] = vectors.map(|[x, y, z]| {
            let (along, across) = mixed(x, y);
            [along, across, z]
        });
        // α = α_p + θ̈ z + ω × θ̇ z
        let [p, q] = [omega[0], omega[1]].map(|x| graph.mul(rate, x));
        alpha = [
            graph.add(alpha[0], q),
            graph.sub(alpha[1], p),
            graph.add(alpha[2], second),
        ];
        omega[2] = graph.add(omega[2], rate);
        (axes, [omega, alpha, velocity, acceleration])
    }
}
