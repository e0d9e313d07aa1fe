//! Conditions between two frames, with the forces and torques of their multipliers on the child.

use crate::dimension::Dimension;
use crate::model::elements::joint::{Condition, Joint, ReactionComponent};
use crate::model::geometry::Vector;
use crate::model::joint_frames::JointFrames;
use crate::symbolic::{Expr, Graph};

/// Collects conditions between two frames p (parent) and c (child), with the force and the torque of their multipliers
/// λ on the child.
///
/// | condition | φ | force on the child | torque on the child |
/// |---|---|---|---|
/// | [`coincide`](Builder::coincide) | the gap d = r_c − r_p, along X, Y, Z | λ along X, Y, Z | |
/// | [`on_plane`](Builder::on_plane) | p_k · d | λ p_k | |
/// | [`square`](Builder::square) | p_i · c_j | | λ c_j × p_i |
///
/// The name of a condition is the direction that it holds: `x` or `rotation_x` if this is X in the home pose; `u`, `v`,
/// `w` for the joint's own axes if these are not axes of the ground.
pub(super) struct Builder<'g> {
    pub graph: &'g mut Graph,
    frames: &'g JointFrames,
    joint: Joint,
    force: [Vec<(usize, Expr)>; 3],
    torque: [Vec<(usize, Expr)>; 3],
}

impl<'g> Builder<'g> {
    /// No condition yet.
    pub fn new(graph: &'g mut Graph, frames: &'g JointFrames) -> Self {
        Builder {
            graph,
            frames,
            joint: Joint::default(),
            force: Default::default(),
            torque: Default::default(),
        }
    }

    fn gap(&mut self) -> Vector {
        let (parent, child) = (&self.frames.parent.point, &self.frames.child.point);
        self.graph.vector_sub(child.position, parent.position)
    }

    /// Adds a condition; returns its index.
    pub fn push(&mut self, suffix: &str, expr: Expr, dimension: Dimension) -> usize {
        let condition = Condition::position(suffix, expr, dimension);
        self.joint.conditions.push(condition);
        self.joint.conditions.len() - 1
    }

    /// The force and the torque of λ of a condition on the child.
    pub fn acts(&mut self, condition: usize, force: Option<Vector>, torque: Option<Vector>) {
        for (components, vector) in [(&mut self.force, force), (&mut self.torque, torque)] {
            for (component, x) in components.iter_mut().zip(vector.into_iter().flatten()) {
                if !self.graph.is_zero(x) {
                    component.push((condition, x));
                }
            }
        }
    }

    /// The origins coincide.
    pub fn coincide(mut self) -> Self {
        let gap = self.gap();
        let axes = self.graph.ground_axes();
        for ((suffix, gap), axis) in ["x", "y", "z"].into_iter().zip(gap).zip(axes) {
            let condition = self.push(suffix, gap, Dimension::LENGTH);
            self.acts(condition, Some(axis), None);
        }
        self
    }

    /// The child's origin stays in the plane across axis k of the parent.
    pub fn on_plane(mut self, k: usize) -> Self {
        let normal = self.frames.parent.axes[k];
        let gap = self.gap();
        let distance = self.graph.dot(normal, gap);
        let condition = self.push(self.frames.letters[k], distance, Dimension::LENGTH);
        self.acts(condition, Some(normal), None);
        self
    }

    /// Axis i of the parent stays square to axis j of the child: no rotation about the third.
    pub fn square(mut self, i: usize, j: usize) -> Self {
        let (fixed, turned) = (self.frames.parent.axes[i], self.frames.child.axes[j]);
        let cosine = self.graph.dot(fixed, turned);
        let suffix = format!("rotation_{}", self.frames.letters[3 - i - j]);
        let condition = self.push(&suffix, cosine, Dimension::NONE);
        let torque = self.graph.cross(turned, fixed);
        self.acts(condition, None, Some(torque));
        self
    }

    /// The z axes stay parallel.
    pub fn parallel(self) -> Self {
        self.square(2, 1).square(2, 0)
    }

    /// The joint, with its reactions.
    pub fn finish(mut self) -> Joint {
        let names = [["fx", "fy", "fz"], ["tx", "ty", "tz"]];
        let dimensions = [Dimension::FORCE, Dimension::TORQUE];
        for ((components, names), dimension) in [self.force, self.torque]
            .into_iter()
            .zip(names)
            .zip(dimensions)
        {
            if components.iter().all(Vec::is_empty) {
                continue;
            }
            for (terms, name) in components.into_iter().zip(names) {
                self.joint.reactions.push(ReactionComponent {
                    name,
                    dimension,
                    terms,
                });
            }
        }
        self.joint.points = self.frames.points();
        self.joint
    }
}
