//! The model: a mechanism with all names resolved.

use super::elements::force::Force;
use super::elements::joint::Joint;
use super::geometry::Vector;
use super::held::Held;
use super::layout::Layout;
use super::outline::Outline;
use super::readings::Reading;
use super::reduction::MergedJoint;
use super::requirements::Requirement;
use super::sizes::Sizes;
use super::solved::Solved;
use super::tree::BodyTwist;
use super::vacuous::VacuousPlace;
use crate::symbolic::{Expr, Graph, Substitution};
use std::collections::BTreeSet;

/// A mechanism with all names resolved.
#[derive(Debug)]
pub struct Model {
    /// All expressions.
    pub graph: Graph,
    /// What it is called and made of.
    pub outline: Outline,
    /// The expressions of the outputs.
    pub outputs: Vec<Expr>,
    /// The components of reactions that outputs read.
    pub readings: Vec<Reading>,
    /// The expressions of the events.
    pub events: Vec<Expr>,
    /// Initial values that assembly holds.
    pub held: Vec<Held>,
    /// What arguments that follow from parameters have to be.
    pub requirements: Vec<Requirement>,
    /// Acceleration of gravity.
    pub gravity: Vector,
    /// Joints and constraints that leave rows (merged joints are in `merged`).
    pub joints: Vec<(String, Joint)>,
    /// Conditions of these joints that are zero in every pose, and are left out.
    pub vacuous: BTreeSet<VacuousPlace>,
    /// Force elements.
    pub forces: Vec<Force>,
    /// The generalized coordinates and velocities.
    pub layout: Layout,
    /// Local coordinates in terms of the generalized ones.
    pub reduction: Substitution,
    /// Joints that the reduction dissolved.
    pub merged: Vec<MergedJoint>,
    /// Rows that were solved for a coordinate.
    pub solved: Solved,
    /// Velocities of the parts that the tree carries.
    pub twists: Vec<BodyTwist>,
    /// The guessed velocities of the local coordinates that the tree carries in space.
    pub carried_velocities: Vec<(u32, Expr)>,
    /// How large coordinates and rates are at the start.
    pub sizes: Sizes,
}

impl Model {
    /// The number of rows that its joints leave.
    pub fn count_rows(&self) -> usize {
        let joints = self.joints.iter();
        let conditions: usize = joints.map(|(_, joint)| joint.conditions.len()).sum();
        conditions - self.vacuous.len() - self.solved.rows.len()
    }
}
