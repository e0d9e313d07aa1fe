//! Stage 2: tree → model.
//!
//! AFTER THIS STAGE: every name is resolved, every dimension checked, every expression symbolic (in the *local*
//! coordinates of the parts), every point merged that a joint merges, and no user error is left to find.
//!
//! The passes stand in `passes`, in order.

// Data.
pub mod elements;
mod formulation;
mod geometry;
mod given;
mod held;
mod joint_frames;
mod joint_variables;
mod mechanism;
mod mobilizer;
mod outline;
mod quantities;
mod readings;
mod reduction;
mod requirements;
mod solved;
mod tables;
mod tree;
mod value;

// Names and expressions.
mod advice;
mod alignment;
mod arguments;
mod budget;
mod defaults;
mod entries;
mod expression;
mod frames;
mod home;
mod joint_kinematics;
mod lengths;
mod needs_angle;
mod outputs;
mod parts;
mod planar_joint;
mod resolver;
mod sizes;

// The passes, and what they use.
mod check;
mod coordinates;
mod counted;
mod drawing;
mod initial_pose;
mod kinematics;
mod layout;
mod loads;
mod passes;
mod reduce;
mod solve;
mod spanning;
mod vacuous;

pub use budget::budget;
pub(crate) use defaults::vanishes;
pub use drawing::Drawing;
pub use elements::kinds::kinds;
pub use formulation::{Description, Formulation, requested};
pub use geometry::{Attachment, Axes, Frame, Owner, Point, Tensor, Vector};
pub use held::Held;
pub use joint_variables::UnwrappedAngle;
pub use layout::{Layout, Rotation, Stored};
pub use mechanism::Model;
pub use mobilizer::{Freedom, Mobilizer};
pub use outline::Outline;
pub use parts::{Part, Representation, Shape};
pub use passes::{parameters, resolve};
pub use quantities::{Law, Local, Quantity, ScalarState};
pub use readings::Reading;
pub use reduction::MergedJoint;
pub use requirements::{Requirement, Wanted};
pub use sizes::Sizes;
pub use solved::{Solved, SolvedCoordinate};
pub use tree::{BodyTwist, Tree, TreeJoint};
pub use vacuous::VacuousPlace;
pub(crate) use vacuous::scattered_motion;
