//! Poses and velocities along the tree, from each part to those that it carries.

mod carried;

use super::geometry::{Axes, Owner, Tensor, Vector};
use super::mobilizer::{Freedom, transposed};
use super::parts::{Part, Representation};
use super::tree::{BodyTwist, Tree, TreeJoint};
use crate::schema::World;
use crate::symbolic::{Expr, Graph, Substitution, Symbol};
use carried::Carried;
use std::collections::BTreeMap;

/// A part in generalized coordinates and velocities.
#[derive(Clone, Copy)]
struct State {
    /// Centre of mass.
    center: Vector,
    /// The axes in which the part is described: in space those of the joint that carries it, because the axes of the part
    /// would cost a multiplication by a constant rotation.
    axes: Axes,
    /// These axes in components of the part's own: constants.
    fixed: Axes,
    /// In the plane.
    angle: Expr,
    /// Velocity of the centre of mass: in `axes` in space, in the ground's axes in the plane.
    velocity: Vector,
    /// Angular velocity in `axes`.
    omega: Vector,
    /// Acceleration of the centre of mass, in the axes of the velocity.
    acceleration: Vector,
    /// Angular acceleration in `axes`.
    alpha: Vector,
}

/// A velocity and an acceleration.
type Rates = [Vector; 2];

/// Walks along the tree.
pub(super) struct Walk<'a> {
    pub graph: &'a mut Graph,
    pub world: World,
    pub parts: &'a [Part],
    pub substitution: &'a mut Substitution,
}

impl Walk<'_> {
    /// Replaces the locals of all parts that the tree carries, and returns their velocities. What the tree leaves to
    /// parts themselves (roots, own rotations, joint coordinates) has to be replaced already.
    pub(super) fn run(&mut self, tree: &Tree) -> Vec<BodyTwist> {
        let mut states: BTreeMap<usize, State> = BTreeMap::new();
        let mut twists = Vec::new();
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
                World::Spatial => self.spatial(tree, joint, &parent),
            };
            self.store(joint.child, &state);
            twists.push(BodyTwist {
                part: joint.child,
                velocity: state.velocity,
                omega: state.omega,
                inertia: self.inertia(joint.child, &state.fixed),
            });
            states.insert(joint.child, state);
        }
        twists
    }

    fn ground(&mut self) -> State {
        let zero = self.graph.zero_vector();
        let axes = self.graph.ground_axes();
        State {
            center: zero,
            axes,
            fixed: axes,
            angle: self.graph.zero(),
            velocity: zero,
            omega: zero,
            acceleration: zero,
            alpha: zero,
        }
    }

    /// The inertia of a part in other axes, given in components of its own.
    fn inertia(&mut self, part: usize, axes: &Axes) -> Tensor {
        let inertia = self.parts[part].inertia;
        let columns = axes.map(|axis| inertia.map(|row| self.graph.dot(row, axis)));
        axes.map(|axis| columns.map(|column| self.graph.dot(axis, column)))
    }

    fn generalized(&mut self, vector: Vector) -> Vector {
        vector.map(|x| self.graph.substitute(x, self.substitution))
    }

    fn symbol(&mut self, symbol: Symbol) -> Expr {
        let local = self.graph.symbol(symbol);
        self.graph.substitute(local, self.substitution)
    }

    /// A coordinate of a joint or its rates, as the motion of the child against the parent.
    fn motion(&mut self, joint: &TreeJoint, symbol: Symbol) -> Expr {
        let own = self.symbol(symbol);
        self.graph.scale(joint.mobilizer.sign(), own)
    }

    /// A part's centre with its velocity and acceleration, from its own locals.
    fn own_center(&mut self, part: &Part) -> (Vector, Rates) {
        let zero = self.graph.zero_vector();
        let (mut center, mut rates) = (zero, [zero; 2]);
        for (k, &local) in part.locals[..self.world.dimension()].iter().enumerate() {
            center[k] = self.symbol(Symbol::LocalPosition(local));
            rates[0][k] = self.symbol(Symbol::LocalVelocity(local));
            rates[1][k] = self.symbol(Symbol::LocalAcceleration(local));
        }
        (center, rates)
    }

    /// The orientation of a part with its angular velocity and acceleration in body axes, from its own locals.
    fn own_rotation(&mut self, part: &Part) -> (Axes, Rates) {
        let axes = part.frame.axes.map(|axis| self.generalized(axis));
        let zero = self.graph.zero();
        let turns: [fn(u32) -> Symbol; 2] = [Symbol::LocalVelocity, Symbol::LocalAcceleration];
        let rates = turns.map(|symbol| match part.rotation() {
            Some(first) => [0, 1, 2].map(|k| self.symbol(symbol(first + k))),
            None => [zero, zero, self.symbol(symbol(part.locals[2]))],
        });
        (axes, rates)
    }

    /// Velocity and acceleration of a point at `arm` from one that has `rates`, on a body that turns.
    fn carry(&mut self, rates: Rates, turn: Rates, arm: Vector) -> Rates {
        let graph = &mut *self.graph;
        let [velocity, acceleration] = rates;
        let swing = graph.cross(turn[0], arm);
        let inward = graph.cross(turn[0], swing);
        let push = graph.cross(turn[1], arm);
        let push = graph.vector_add(push, inward);
        [
            graph.vector_add(velocity, swing),
            graph.vector_add(acceleration, push),
        ]
    }

    fn root(&mut self, index: usize) -> State {
        let part = &self.parts[index];
        let (center, rates) = self.own_center(part);
        let (axes, [omega, alpha]) = self.own_rotation(part);
        let [velocity, acceleration] = match self.world {
            World::Planar => rates,
            World::Spatial => rates.map(|rate| self.graph.components(&axes, rate)),
        };
        let angle = match self.world {
            World::Planar => self.symbol(Symbol::LocalPosition(part.locals[2])),
            World::Spatial => self.graph.zero(),
        };
        State {
            center,
            axes,
            fixed: self.graph.ground_axes(),
            angle,
            velocity,
            omega,
            acceleration,
            alpha,
        }
    }

    /// A point of a part's own frame, seen from its centre of mass.
    fn off_center(&mut self, owner: Owner, local: Vector) -> Vector {
        match owner {
            Owner::Ground => local,
            Owner::Part(part) => self.graph.vector_sub(local, self.parts[part].center),
        }
    }

    fn spatial(&mut self, tree: &Tree, joint: &TreeJoint, parent: &State) -> State {
        let mobilizer = &joint.mobilizer;
        let part = &self.parts[joint.child];
        let (p, c) = (&mobilizer.parent, &mobilizer.child);
        let arm = self.off_center(p.point.owner, p.point.local);
        let back = self.off_center(c.point.owner, c.point.local);
        let outer = self.graph.composed_constants(&parent.fixed, &p.local);
        // The joint's place, velocity and acceleration on the parent, in the axes of its state.
        let mut arm = self.graph.components(&parent.fixed, arm);
        let mut slide = [self.graph.zero_vector(); 2];
        let mut slides = false;
        for (freedom, local) in joint.freedoms() {
            let (axis, per_unit) = match *freedom {
                Freedom::Slide(axis) => (axis, None),
                Freedom::Helix(lead) => (2, Some(lead)),
                Freedom::Turn(_) | Freedom::Rotation => continue,
            };
            slides = true;
            let direction = outer[axis];
            let along = |walk: &mut Self, symbol: Symbol, before: Vector| {
                let mut stroke = walk.motion(joint, symbol);
                if let Some(per_unit) = per_unit {
                    stroke = walk.graph.mul(per_unit, stroke);
                }
                let along = walk.graph.vector_scale(stroke, direction);
                walk.graph.vector_add(before, along)
            };
            arm = along(self, Symbol::LocalPosition(local), arm);
            slide[0] = along(self, Symbol::LocalVelocity(local), slide[0]);
            slide[1] = along(self, Symbol::LocalAcceleration(local), slide[1]);
        }
        let turn = [parent.omega, parent.alpha];
        let mut rates = self.carry([parent.velocity, parent.acceleration], turn, arm);
        if slides {
            // … with the acceleration of Coriolis, 2 ω × ṡ.
            let twice = slide[0].map(|x| self.graph.scale(2.0, x));
            let deflection = self.graph.cross(parent.omega, twice);
            slide[1] = self.graph.vector_add(slide[1], deflection);
            rates = [0, 1].map(|k| self.graph.vector_add(rates[k], slide[k]));
        }
        let reach = self.graph.turn(&parent.axes, arm);
        let hinge = self.graph.vector_add(parent.center, reach);
        if part.representation == Representation::FreePoint {
            return State {
                center: hinge,
                velocity: rates[0],
                acceleration: rates[1],
                ..*parent
            };
        }
        let Carried {
            axes,
            fixed,
            turn,
            rates,
        } = if mobilizer.frees_rotation() {
            let (axes, turn) = self.own_rotation(part);
            let rates = rates.map(|rate| {
                let outside = self.graph.turn(&parent.axes, rate);
                self.graph.components(&axes, outside)
            });
            let fixed = self.graph.ground_axes();
            Carried {
                axes,
                fixed,
                turn,
                rates,
            }
        } else {
            self.carried(tree, joint, parent, &outer, rates)
        };
        let back = self.graph.components(&fixed, back);
        let arm = self.graph.turn(&axes, back);
        let center = self.graph.vector_sub(hinge, arm);
        let back = back.map(|x| self.graph.neg(x));
        let [velocity, acceleration] = self.carry(rates, turn, back);
        State {
            center,
            axes,
            fixed,
            angle: parent.angle,
            velocity,
            omega: turn[0],
            acceleration,
            alpha: turn[1],
        }
    }

    fn planar(&mut self, joint: &TreeJoint, parent: &State) -> State {
        let mobilizer = &joint.mobilizer;
        let part = &self.parts[joint.child];
        let mut arm = self.off_center(mobilizer.parent.point.owner, mobilizer.parent.point.local);
        // The sliding against the parent, in the parent's axes.
        let mut slide = [self.graph.zero_vector(); 2];
        let mut slides = false;
        for (freedom, local) in joint.freedoms() {
            let Freedom::Slide(axis) = *freedom else {
                continue;
            };
            slides = true;
            let direction = mobilizer.parent.local[axis];
            let along = |walk: &mut Self, symbol: Symbol, before: Vector| {
                let stroke = walk.motion(joint, symbol);
                let along = walk.graph.vector_scale(stroke, direction);
                walk.graph.vector_add(before, along)
            };
            arm = along(self, Symbol::LocalPosition(local), arm);
            slide[0] = along(self, Symbol::LocalVelocity(local), slide[0]);
            slide[1] = along(self, Symbol::LocalAcceleration(local), slide[1]);
        }
        let arm = self.graph.turn(&parent.axes, arm);
        let turn = [parent.omega, parent.alpha];
        let mut rates = self.carry([parent.velocity, parent.acceleration], turn, arm);
        if slides {
            // … with the acceleration of Coriolis, 2 ω × ṡ.
            let [speed, push] = slide.map(|v| self.graph.turn(&parent.axes, v));
            let twice = speed.map(|x| self.graph.scale(2.0, x));
            let deflection = self.graph.cross(parent.omega, twice);
            let push = self.graph.vector_add(push, deflection);
            rates = [
                self.graph.vector_add(rates[0], speed),
                self.graph.vector_add(rates[1], push),
            ];
        }
        let hinge = self.graph.vector_add(parent.center, arm);
        if part.representation == Representation::FreePoint {
            return State {
                center: hinge,
                velocity: rates[0],
                acceleration: rates[1],
                ..*parent
            };
        }
        let angle = part.locals[2];
        if let (false, Some(offset)) = (mobilizer.frees_rotation(), mobilizer.offset) {
            let offset = match mobilizer.forwards {
                true => offset,
                false => self.graph.neg(offset),
            };
            let turned = self.graph.add(parent.angle, offset);
            let [rate, second] = turn.map(|v| v[2]);
            for (symbol, value) in [
                (Symbol::LocalPosition(angle), turned),
                (Symbol::LocalVelocity(angle), rate),
                (Symbol::LocalAcceleration(angle), second),
            ] {
                self.substitution.insert(symbol, value);
            }
        }
        let (axes, turn) = self.own_rotation(part);
        let back = self.off_center(mobilizer.child.point.owner, mobilizer.child.point.local);
        let back = self.graph.turn(&axes, back);
        let center = self.graph.vector_sub(hinge, back);
        let back = back.map(|x| self.graph.neg(x));
        let [velocity, acceleration] = self.carry(rates, turn, back);
        State {
            center,
            axes,
            fixed: self.graph.ground_axes(),
            angle: self.symbol(Symbol::LocalPosition(angle)),
            velocity,
            omega: turn[0],
            acceleration,
            alpha: turn[1],
        }
    }

    fn store(&mut self, index: usize, state: &State) {
        let part = &self.parts[index];
        let [velocity, acceleration] = match self.world {
            World::Planar => [state.velocity, state.acceleration],
            World::Spatial => {
                [state.velocity, state.acceleration].map(|rate| self.graph.turn(&state.axes, rate))
            }
        };
        for (k, &local) in part.locals[..self.world.dimension()].iter().enumerate() {
            let values = [
                (Symbol::LocalPosition(local), state.center[k]),
                (Symbol::LocalVelocity(local), velocity[k]),
                (Symbol::LocalAcceleration(local), acceleration[k]),
            ];
            for (symbol, value) in values {
                self.substitution.insert(symbol, value);
            }
        }
        let Some(first) = part.rotation() else {
            return;
        };
        let own = transposed(&state.fixed);
        for entry in 0..9u8 {
            let (row, column) = (usize::from(entry / 3), usize::from(entry % 3));
            let across = state.axes.map(|axis| axis[row]);
            let symbol = Symbol::LocalRotation(first, entry);
            match self.graph.numbers(own[column]) {
                Some(numbers) => {
                    let terms = across.into_iter().zip(numbers);
                    let terms: Vec<(Expr, f64)> = terms.filter(|(_, x)| *x != 0.0).collect();
                    let value = self.graph.linear(0.0, &terms);
                    self.substitution.insert_sum(symbol, value, terms);
                }
                None => {
                    let value = self.graph.dot(across, own[column]);
                    self.substitution.insert(symbol, value);
                }
            }
        }
        let own = part.own_velocity(self.graph);
        let [velocity, omega, alpha] =
            [state.velocity, state.omega, state.alpha].map(|v| self.graph.turn(&state.fixed, v));
        for (mark, value) in own.into_iter().zip(velocity) {
            self.substitution.equate(mark, value);
        }
        for k in 0..3 {
            let local = first + k;
            let (omega, alpha) = (omega[k as usize], alpha[k as usize]);
            self.substitution
                .insert(Symbol::LocalVelocity(local), omega);
            self.substitution
                .insert(Symbol::LocalAcceleration(local), alpha);
        }
    }
}
