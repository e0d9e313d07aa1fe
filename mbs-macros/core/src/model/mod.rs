//! Stage 2: tree → model.
//!
//! AFTER THIS STAGE: every name is resolved, every dimension checked, every expression symbolic (in the *local*
//! coordinates of the parts), every point merged that a joint merges, and no user error is left to find.

mod advice;
mod arguments;
mod check;
mod coordinates;
mod counted;
mod dimension;
mod drawing;
mod elements;
mod expression;
mod formulation;
mod frames;
mod geometry;
mod home;
mod joint_frames;
mod joint_motion;
mod kinematics;
mod layout;
mod parts;
mod placement;
mod reduce;
mod resolve;
mod solve;
mod solved;
mod spanning;
mod tree;
mod turning;
mod vacuous;
mod value;

use crate::equations::{forces::Force, joints::Joint};
use crate::schema::World;
use crate::symbolic::{Expr, Graph, Substitution};
use std::collections::BTreeSet;

pub use arguments::Arguments;
pub use dimension::{Dimension, UNITS, unit};
pub use drawing::Drawing;
pub use formulation::{Description, Formulation, requested};
pub use geometry::{Attachment, Axes, Frame, Owner, Point, Vector};
pub use joint_frames::JointFrames;
pub use joint_motion::UnwrappedAngle;
pub use layout::{Layout, Rotation, Stored};
pub use parts::{Part, Representation, Shape, Tensor};
pub use reduce::MergedJoint;
pub use resolve::resolve;
pub use solved::{Solved, SolvedCoordinate};
pub use tree::{Link, Motion, Tree, TreeJoint};
pub use vacuous::VacuousPlace;

/// A mechanism with all names resolved.
#[derive(Debug)]
pub struct Model {
    /// All expressions.
    pub graph: Graph,
    /// The name given to `mechanism!`.
    pub name: String,
    /// Its documentation.
    pub doc: String,
    /// The plane or space.
    pub world: World,
    /// Its declaration as text.
    pub text: String,
    /// Parameters, in declaration order.
    pub parameters: Vec<Quantity>,
    /// Inputs, in declaration order.
    pub inputs: Vec<Quantity>,
    /// Outputs with their expressions.
    pub outputs: Vec<(Quantity, Expr)>,
    /// Events with their expressions.
    pub events: Vec<(String, Expr)>,
    /// Acceleration of gravity.
    pub gravity: Vector,
    /// The unit vector against gravity with default parameters; without gravity, y in the plane and z in space.
    pub up: [f64; 3],
    /// Coordinates of the parts on their own.
    pub locals: Vec<Local>,
    /// Bars, bodies, particles.
    pub parts: Vec<Part>,
    /// Joints and constraints that leave rows (merged joints are in `merged`).
    pub joints: Vec<(String, Box<dyn Joint>)>,
    /// Rows of these joints that are zero in every pose, and are left out.
    pub vacuous: BTreeSet<VacuousPlace>,
    /// Force elements.
    pub forces: Vec<(String, Box<dyn Force>)>,
    /// The generalized coordinates and velocities.
    pub layout: Layout,
    /// Local coordinates in terms of the generalized ones.
    pub reduction: Substitution,
    /// Joints that the reduction dissolved.
    pub merged: Vec<MergedJoint>,
    /// Rows that were solved for a coordinate.
    pub solved: Solved,
    /// Joints that became coordinates.
    pub tree: Tree,
    /// Velocities of the parts that the tree carries.
    pub motions: Vec<Motion>,
    /// The choice of coordinates.
    pub formulation: Formulation,
    /// What the reduction did, in sentences.
    pub reductions: Vec<String>,
    /// What an animation draws.
    pub drawing: Drawing,
    /// Paths of the users' laws and the number of their arguments.
    pub laws: Vec<Law>,
}

/// A parameter, input or output.
#[derive(Debug, Clone)]
pub struct Quantity {
    /// Its name.
    pub name: String,
    /// SI unit, empty where dimensionless or not stated.
    pub unit: String,
    /// Default value.
    pub default: f64,
    /// Documentation comment.
    pub doc: String,
}

/// A coordinate of a part on its own.
#[derive(Debug, Clone)]
pub struct Local {
    /// For example `crank.b.x`.
    pub name: String,
    /// SI unit.
    pub unit: String,
}

/// A user's law.
#[derive(Debug, Clone)]
pub struct Law {
    /// Where the function is.
    pub path: syn::Expr,
    /// The number of its arguments.
    pub arguments: usize,
}
