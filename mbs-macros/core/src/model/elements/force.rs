//! A force element, as data.

use crate::dimension::Dimension;
use crate::model::geometry::{Attachment, Owner, Point, Tensor, Vector};
use crate::symbolic::{Expr, Table};
use std::sync::Arc;

/// A force element: its points and parts, and its sort.
#[derive(Debug, Clone)]
pub struct Force {
    /// The points it acts on.
    pub points: Vec<Point>,
    /// Parts on which it acts without points.
    pub owners: Vec<Owner>,
    /// Its sort.
    pub element: ForceElement,
}

/// The force elements; all expressions are in local coordinates.
#[derive(Debug, Clone)]
pub enum ForceElement {
    /// A spring and damper along the line between two points.
    Spring {
        /// The first point.
        from: Vector,
        /// The second point.
        to: Vector,
        /// Its tension.
        characteristic: Characteristic,
    },
    /// A rotational spring and damper.
    TorsionSpring {
        /// The angle of the child and of the parent.
        angles: [Expr; 2],
        /// Their rates.
        rates: [Expr; 2],
        /// Its torque.
        characteristic: Characteristic,
    },
    /// A force and a torque, given by components.
    Wrench {
        /// The point on which the force acts.
        on: Point,
        /// The force in components of `axes`.
        force: Vector,
        /// A torque on the part of the point, in the same components.
        torque: Option<Vector>,
        /// The ground or the part whose axes these are.
        axes: Owner,
    },
    /// A torque, given by components.
    Torque {
        /// The part on which it acts, and that on which it acts back.
        between: [Owner; 2],
        /// The torque in components of `axes`.
        torque: Vector,
        /// The ground or the part whose axes these are.
        axes: Owner,
    },
    /// Stops of a position.
    Stop(Box<Stop>),
    /// A scalar force with its rate.
    Load {
        /// Both.
        load: Load,
        /// Dimension of the force.
        dimension: Option<Dimension>,
    },
    /// Springs and dampers in all six directions.
    Bushing(Box<Bushing>),
}

/// A scalar force and a rate: its power is their product, its generalized force on coordinate i is force ·
/// ∂rate/∂vᵢ.
#[derive(Debug, Clone, Copy)]
pub struct Load {
    /// Linear in the velocities.
    pub rate: Expr,
    /// The force.
    pub force: Expr,
}

/// The characteristic of a spring and damper: linear, a table, or a user's law of [deflection, rate].
#[derive(Debug, Clone)]
pub enum Characteristic {
    /// Stiffness · (deflection − free) + damping · rate.
    Linear {
        /// Force per deflection.
        stiffness: Expr,
        /// Its damper.
        damping: Damping,
        /// The deflection at which the force is zero.
        free: Expr,
    },
    /// A table of deflection − free, and a damper.
    Table {
        /// The force.
        table: Arc<Table>,
        /// Its damper.
        damping: Damping,
        /// The deflection at which the table's argument is zero.
        free: Expr,
    },
    /// By its index, with what it takes after deflection and rate.
    Law(u32, Vec<Expr>),
}

/// The force of a damper.
#[derive(Debug, Clone)]
pub enum Damping {
    /// Force per rate.
    Linear(Expr),
    /// A table of the rate.
    Table(Arc<Table>),
}

/// Elastic stops of a position.
#[derive(Debug, Clone)]
pub struct Stop {
    /// The position.
    pub target: Expr,
    /// Its rate.
    pub rate: Expr,
    /// Dimension of the force along it.
    pub dimension: Option<Dimension>,
    /// Below, above or both.
    pub sides: Vec<Side>,
    /// Force per depth, deeper than the onset.
    pub stiffness: Expr,
    /// The depth over which the stiffness grows.
    pub onset: Expr,
    /// Damping force per elastic force and rate.
    pub dissipation: Expr,
}

/// A stop on one side.
#[derive(Debug, Clone, Copy)]
pub struct Side {
    /// Where it begins.
    pub begin: Expr,
    /// Whether it stops what grows.
    pub is_upper: bool,
}

/// An elastic joint between two frames.
#[derive(Debug, Clone)]
pub struct Bushing {
    /// On the first partner; displacements and rotations are in its axes.
    pub parent: Attachment,
    /// On the second.
    pub child: Attachment,
    /// Stiffness for displacements.
    pub stiffness: Tensor,
    /// Damping for velocities.
    pub damping: Tensor,
    /// Stiffness for rotations.
    pub torsion_stiffness: Tensor,
    /// Damping for angular velocities.
    pub torsion_damping: Tensor,
    /// Coupling of forces with rotations and of torques with displacements.
    pub cross_stiffness: Tensor,
}
