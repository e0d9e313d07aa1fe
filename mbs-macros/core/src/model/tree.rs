//! Joint coordinates: a tree of joints from the ground, each of which has coordinates for its freedoms. The pose and
//! the velocity of a part follow from those of the part before it, body by body; nothing is expanded.
//!
//! | joint | coordinates of the child | kept of its own |
//! |---|---|---|
//! | revolute, screw, prismatic, fixed | angle; angle; stroke; none | nothing |
//! | cylindrical, planar | angle and stroke; angle and two strokes | nothing |
//! | universal | two angles | nothing |
//! | spherical | none | its rotation |
//! | planar revolute | none | its angle |
//!
//! A joint that closes a loop stays a set of rows.

use super::geometry::{Tensor, Vector};
use super::mobilizer::{Freedom, Mobilizer};
use super::parts::{Part, Representation};
use crate::symbolic::Expr;
use std::collections::BTreeSet;

/// A joint of the tree.
#[derive(Debug, Clone)]
pub struct TreeJoint {
    /// The joint's name.
    pub joint: String,
    /// The part before, `None` for the ground.
    pub parent: Option<usize>,
    /// The part that it carries.
    pub child: usize,
    /// The joint, seen from the parent to the child.
    pub mobilizer: Mobilizer,
    /// The local coordinate of each of its freedoms; none of a rotation, which is the child's own.
    pub coordinates: Vec<Option<u32>>,
}

/// A spanning tree of the mechanism.
#[derive(Debug, Clone, Default)]
pub struct Tree {
    /// Its joints, parents before children.
    pub joints: Vec<TreeJoint>,
    /// Joints that could be in the tree but are cut: they close the loops.
    pub cut: Vec<String>,
    /// Other cuts that leave as few rows and chains as short.
    pub alternatives: Vec<Vec<String>>,
}

/// The velocity of a part, for its kinetic energy.
#[derive(Debug, Clone, Copy)]
pub struct BodyTwist {
    /// The part.
    pub part: usize,
    /// Velocity of the centre of mass, in axes of the part's own choice.
    pub velocity: Vector,
    /// Angular velocity in the same axes.
    pub omega: Vector,
    /// Inertia about the centre of mass in the same axes.
    pub inertia: Tensor,
}

impl Tree {
    /// The joint that carries a part.
    pub fn carrier(&self, part: usize) -> Option<&TreeJoint> {
        self.joints.iter().find(|joint| joint.child == part)
    }

    /// The locals of a part that follow from the part before it.
    pub(super) fn dropped(&self, index: usize, part: &Part) -> Vec<u32> {
        let Some(joint) = self.carrier(index) else {
            return Vec::new();
        };
        let count = match part.representation {
            Representation::Reference if joint.mobilizer.frees_rotation() => 2,
            Representation::Rigid if joint.mobilizer.frees_rotation() => 3,
            _ => part.locals.len(),
        };
        part.locals[..count].to_vec()
    }

    /// The locals that joints bring: of each the angles first.
    pub(super) fn locals(&self) -> impl Iterator<Item = u32> {
        self.joints.iter().flat_map(|joint| {
            let [turns, slides] = [true, false].map(|turns| {
                let own = joint.freedoms();
                own.filter(move |(freedom, _)| freedom.turns() == turns)
            });
            turns.chain(slides).map(|(_, local)| local)
        })
    }

    /// A part and all that it carries.
    pub fn carried_by(&self, part: usize) -> Vec<usize> {
        let mut found = vec![part];
        for joint in &self.joints {
            if joint.parent.is_some_and(|parent| found.contains(&parent)) {
                found.push(joint.child);
            }
        }
        found
    }

    /// Whether every part is carried by a joint that stands after that of the part before it.
    pub(super) fn parents_come_first(&self) -> bool {
        let carries = |part: usize| self.joints.iter().position(|joint| joint.child == part);
        self.joints.iter().enumerate().all(|(place, joint)| {
            let before = joint.parent.and_then(carries);
            before.is_none_or(|before| before < place)
        })
    }

    /// Whether a joint belongs to the tree.
    pub fn contains(&self, joint: &str) -> bool {
        self.joints.iter().any(|own| own.joint == joint)
    }
}

/// The places of the joints from the ground, or from a root, to a part.
pub(super) fn chain(joints: &[TreeJoint], part: Option<usize>) -> BTreeSet<usize> {
    let mut chain = BTreeSet::new();
    let mut next = part;
    while let Some(part) = next {
        let carrier = joints.iter().position(|joint| joint.child == part);
        next = carrier.and_then(|joint| joints[joint].parent);
        chain.extend(carrier);
    }
    chain
}

impl TreeJoint {
    /// Its freedoms that are coordinates, in order, each with its local one.
    pub fn freedoms(&self) -> impl Iterator<Item = (&Freedom, u32)> {
        let pairs = self.mobilizer.freedoms.iter().zip(&self.coordinates);
        pairs.filter_map(|(freedom, local)| Some((freedom, (*local)?)))
    }

    /// The local coordinates of its angles, in order.
    pub fn angles(&self) -> Vec<u32> {
        let turns = self.freedoms().filter(|(freedom, _)| freedom.turns());
        turns.map(|(_, local)| local).collect()
    }

    /// The local coordinate by which the child slides along the axis of the joint, and the stroke per unit of it, where
    /// that is not one.
    pub fn stroke(&self) -> Option<(u32, Option<Expr>)> {
        let slides = |(freedom, _): &(&Freedom, u32)| matches!(freedom, Freedom::Slide(_));
        let single = self.freedoms().filter(slides).count() == 1;
        self.freedoms().find_map(|(freedom, local)| match freedom {
            Freedom::Slide(_) if single => Some((local, None)),
            Freedom::Helix(lead) => Some((local, Some(*lead))),
            _ => None,
        })
    }

    /// How the part that it carries is modelled, in words.
    pub fn describe(&self, carried: Representation) -> String {
        let name = &self.joint;
        let frees_rotation = self.mobilizer.frees_rotation();
        let own = match (frees_rotation, carried) {
            (true, Representation::Reference) => "its angle",
            (true, Representation::Rigid) => "its unit quaternion; angular velocity in body axes",
            _ => match (self.angles().len(), self.freedoms().count()) {
                (0, 0) => return format!("joint coordinates (none; `{name}` carries it)"),
                (0, _) => "stroke",
                (1, 1) => "angle",
                (1, 2) => "angle and stroke",
                (1, _) => "angle and strokes",
                _ => "two angles",
            },
        };
        match frees_rotation {
            true => format!("joint coordinates ({own}; `{name}` carries it)"),
            false => format!("joint coordinates ({own} of `{name}`)"),
        }
    }
}
