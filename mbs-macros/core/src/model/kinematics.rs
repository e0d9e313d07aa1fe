//! Poses and velocities along the tree, from each part to those that it carries.

use super::geometry::{Axes, Owner, Vector};
use super::parts::{Part, Representation};
use super::tree::{Motion, Tree, TreeJoint};
use crate::schema::World;
use crate::symbolic::{Expr, Function, Graph, Substitution, Symbol};
use std::collections::BTreeMap;

/// A part in generalized coordinates and velocities.
#[derive(Clone, Copy)]
struct State {
    /// Centre of mass.
    place: Vector,
    axes: Axes,
    /// Velocity of the centre of mass: in body axes in space, in the ground's axes in the plane.
    velocity: Vector,
    /// Angular velocity in body axes.
    omega: Vector,
}

/// Walks along the tree.
pub(super) struct Walk<'a> {
    pub graph: &'a mut Graph,
    pub world: World,
    pub parts: &'a [Part],
    pub substitution: &'a mut Substitution,
}

impl Walk<'_> {
    /// Replaces the locals of all parts that the tree carries, and answers their velocities. What the tree leaves to parts
    /// themselves (roots, own rotations, joint coordinates) has to be replaced already.
    pub(super) fn run(&mut self, tree: &Tree) -> Vec<Motion> {
        let mut states: BTreeMap<usize, State> = BTreeMap::new();
        let mut motions = Vec::new();
        for joint in &tree.joints {
            let parent = match joint.parent {
                None => self.ground(),
                Some(part) => match states.get(&part) {
                    Some(state) => *state,
                    None => {
                        let root = self.root(part);
                        states.insert(part, root);
                        root
                    }
                },
            };
            let state = match self.world {
                World::Planar => self.planar(joint, &parent),
                World::Spatial => self.spatial(joint, &parent),
            };
            self.store(joint.child, &state);
            motions.push(Motion {
                part: joint.child,
                velocity: state.velocity,
                omega: state.omega,
            });
            states.insert(joint.child, state);
        }
        motions
    }

    fn ground(&mut self) -> State {
        let zero = self.graph.zero_vector();
        State {
            place: zero,
            axes: self.graph.ground_axes(),
            velocity: zero,
            omega: zero,
        }
    }

    fn generalized(&mut self, vector: Vector) -> Vector {
        vector.map(|x| self.graph.substitute(x, self.substitution))
    }

    fn symbol(&mut self, symbol: Symbol) -> Expr {
        let local = self.graph.symbol(symbol);
        self.graph.substitute(local, self.substitution)
    }

    /// The place of a part's centre and its velocity, from its own locals.
    fn own_place(&mut self, part: &Part) -> (Vector, Vector) {
        let (mut place, mut velocity) = (self.graph.zero_vector(), self.graph.zero_vector());
        for k in 0..self.world.dimension() {
            place[k] = self.symbol(Symbol::LocalPosition(part.locals[k]));
            velocity[k] = self.symbol(Symbol::LocalVelocity(part.locals[k]));
        }
        (place, velocity)
    }

    /// The orientation of a part and its angular velocity in body axes, from its own locals.
    fn own_rotation(&mut self, part: &Part) -> (Axes, Vector) {
        let axes = part.frame.axes.map(|axis| self.generalized(axis));
        let zero = self.graph.zero();
        let omega = match part.rotation() {
            Some(first) => [0, 1, 2].map(|k| self.symbol(Symbol::LocalVelocity(first + k))),
            None => [
                zero,
                zero,
                self.symbol(Symbol::LocalVelocity(part.locals[2])),
            ],
        };
        (axes, omega)
    }

    fn root(&mut self, index: usize) -> State {
        let part = &self.parts[index];
        let (place, velocity) = self.own_place(part);
        let (axes, omega) = self.own_rotation(part);
        let velocity = match self.world {
            World::Planar => velocity,
            World::Spatial => self.graph.components(&axes, velocity),
        };
        State {
            place,
            axes,
            velocity,
            omega,
        }
    }

    /// A point of a part's own frame, seen from its centre of mass.
    fn from_center(&mut self, owner: Owner, local: Vector) -> Vector {
        match owner {
            Owner::Ground => local,
            Owner::Part(part) => self.graph.vector_sub(local, self.parts[part].center),
        }
    }

    fn spatial(&mut self, joint: &TreeJoint, parent: &State) -> State {
        let link = &joint.link;
        let part = &self.parts[joint.child];
        let (p, c) = (&link.parent, &link.child);
        let arm = self.from_center(p.point.owner, p.point.local);
        let back = self.from_center(c.point.owner, c.point.local);
        // The joint's place and velocity on the parent, in the parent's axes.
        let mut arm = arm;
        let mut slide = self.graph.zero_vector();
        for (&axis, &local) in link.slides.iter().zip(&joint.strokes) {
            let (stroke, speed) = (
                self.symbol(Symbol::LocalPosition(local)),
                self.symbol(Symbol::LocalVelocity(local)),
            );
            let along = self.graph.vector_scale(stroke, p.local[axis]);
            arm = self.graph.vector_add(arm, along);
            let along = self.graph.vector_scale(speed, p.local[axis]);
            slide = self.graph.vector_add(slide, along);
        }
        let swing = self.graph.cross(parent.omega, arm);
        let velocity = self.graph.vector_add(parent.velocity, swing);
        let velocity = self.graph.vector_add(velocity, slide);
        let reach = self.graph.turn(&parent.axes, arm);
        let hinge = self.graph.vector_add(parent.place, reach);
        if part.representation == Representation::FreePoint {
            return State {
                place: hinge,
                axes: parent.axes,
                velocity,
                omega: parent.omega,
            };
        }
        let (axes, omega, velocity) = if link.free_rotation {
            let (axes, omega) = self.own_rotation(part);
            let outside = self.graph.turn(&parent.axes, velocity);
            let velocity = self.graph.components(&axes, outside);
            (axes, omega, velocity)
        } else {
            self.carried(joint, parent, velocity)
        };
        let arm = self.graph.turn(&axes, back);
        let place = self.graph.vector_sub(hinge, arm);
        let swing = self.graph.cross(omega, back);
        let velocity = self.graph.vector_sub(velocity, swing);
        State {
            place,
            axes,
            velocity,
            omega,
        }
    }

    /// Axes, angular velocity, and the joint's velocity in the axes of the child, which turns about z at most.
    fn carried(
        &mut self,
        joint: &TreeJoint,
        parent: &State,
        velocity: Vector,
    ) -> (Axes, Vector, Vector) {
        let (outer, inner) = (joint.link.parent.local, joint.link.child.local);
        let mut axes = self.graph.compose(&parent.axes, &outer);
        let mut vectors = [parent.omega, velocity].map(|v| self.graph.components(&outer, v));
        let mut spin = None;
        if let Some(local) = joint.angle {
            let angle = self.symbol(Symbol::LocalPosition(local));
            spin = Some(self.symbol(Symbol::LocalVelocity(local)));
            let (cos, sin) = (
                self.graph.function(Function::Cos, angle),
                self.graph.function(Function::Sin, angle),
            );
            self.graph.suggest_name(cos, format!("cos_{}", joint.joint));
            self.graph.suggest_name(sin, format!("sin_{}", joint.joint));
            let turned = |a: Expr, b: Expr, graph: &mut Graph| {
                let (first, second) = (graph.mul(cos, a), graph.mul(sin, b));
                graph.add(first, second)
            };
            let [x, y, z] = axes;
            let minus_x = x.map(|x| self.graph.neg(x));
            let graph = &mut *self.graph;
            axes = [
                std::array::from_fn(|k| turned(x[k], y[k], graph)),
                std::array::from_fn(|k| turned(y[k], minus_x[k], graph)),
                z,
            ];
            vectors = vectors.map(|[x, y, z]| {
                let minus_x = graph.neg(x);
                [turned(x, y, graph), turned(y, minus_x, graph), z]
            });
        }
        // The child's axes are those whose composition with its attachment gives the joint's.
        let axes = std::array::from_fn(|k| {
            self.graph
                .turn(&axes, [inner[0][k], inner[1][k], inner[2][k]])
        });
        let [mut omega, velocity] = vectors.map(|v| self.graph.turn(&inner, v));
        if let Some(spin) = spin {
            let own = self.graph.vector_scale(spin, inner[2]);
            omega = self.graph.vector_add(omega, own);
        }
        (axes, omega, velocity)
    }

    fn planar(&mut self, joint: &TreeJoint, parent: &State) -> State {
        let link = &joint.link;
        let part = &self.parts[joint.child];
        let arm = self.from_center(link.parent.point.owner, link.parent.point.local);
        let arm = self.graph.turn(&parent.axes, arm);
        let swing = self.graph.cross(parent.omega, arm);
        let (place, velocity) = (
            self.graph.vector_add(parent.place, arm),
            self.graph.vector_add(parent.velocity, swing),
        );
        if part.representation == Representation::FreePoint {
            return State {
                place,
                axes: parent.axes,
                velocity,
                omega: parent.omega,
            };
        }
        let (axes, omega) = self.own_rotation(part);
        let back = self.from_center(link.child.point.owner, link.child.point.local);
        let back = self.graph.turn(&axes, back);
        let swing = self.graph.cross(omega, back);
        State {
            place: self.graph.vector_sub(place, back),
            axes,
            velocity: self.graph.vector_sub(velocity, swing),
            omega,
        }
    }

    fn store(&mut self, index: usize, state: &State) {
        let part = &self.parts[index];
        let velocity = match self.world {
            World::Planar => state.velocity,
            World::Spatial => self.graph.turn(&state.axes, state.velocity),
        };
        for k in 0..self.world.dimension() {
            let local = part.locals[k];
            self.substitution
                .insert(Symbol::LocalPosition(local), state.place[k]);
            self.substitution
                .insert(Symbol::LocalVelocity(local), velocity[k]);
        }
        let Some(first) = part.rotation() else {
            return;
        };
        for entry in 0..9u8 {
            let value = state.axes[usize::from(entry % 3)][usize::from(entry / 3)];
            self.substitution
                .insert(Symbol::LocalRotation(first, entry), value);
        }
        for (k, rate) in state.omega.into_iter().enumerate() {
            self.substitution
                .insert(Symbol::LocalVelocity(first + k as u32), rate);
        }
    }
}
