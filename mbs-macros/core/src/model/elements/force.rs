//! A force element, as data.

use crate::model::geometry::Tensor;
use crate::model::geometry::{Axes, Owner, Point, Vector};
use crate::symbolic::Expr;

/// A force element: where it acts, and what it is.
#[derive(Debug, Clone)]
pub struct Force {
    /// The points it acts on.
    pub points: Vec<Point>,
    /// Parts it acts on otherwise than by points.
    pub owners: Vec<Owner>,
    /// What it is.
    pub element: ForceElement,
}

/// The force elements; all expressions are in local coordinates.
#[derive(Debug, Clone)]
pub enum ForceElement {
    /// A spring and damper along the line between two points.
    Spring {
        /// From here.
        from: Vector,
        /// To here.
        to: Vector,
        /// Its tension.
        characteristic: Characteristic,
    },
    /// A spring and damper against turning.
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
        /// Where the force acts.
        at: Vector,
        /// The force in components of `axes`.
        force: Vector,
        /// The angular velocity of the part, and the torque in components of `axes`.
        torque: Option<[Vector; 2]>,
        /// The axes of the components.
        axes: Axes,
    },
    /// Scalar forces against rates.
    Loads(Vec<Load>),
    /// Springs and dampers in all six directions.
    Bushing(Box<Bushing>),
}

/// A scalar force against the rate it works on: its power is their product, its generalized force on coordinate i
/// is force · ∂rate/∂vᵢ.
#[derive(Debug, Clone, Copy)]
pub struct Load {
    /// Linear in the velocities.
    pub rate: Expr,
    /// The force.
    pub force: Expr,
}

/// How a spring and damper answers to a deflection: linearly, or by a user's law of [deflection, rate].
#[derive(Debug, Clone)]
pub enum Characteristic {
    /// Stiffness · (deflection − free) + damping · rate.
    Linear {
        /// Force per deflection.
        stiffness: Expr,
        /// Force per rate.
        damping: Expr,
        /// The deflection without force.
        free: Expr,
    },
    /// By its index.
    Law(u32),
}

/// An elastic joint between two frames.
#[derive(Debug, Clone)]
pub struct Bushing {
    /// The origins of the parent's and of the child's frame.
    pub origins: [Vector; 2],
    /// The axes of the parent's and of the child's frame.
    pub axes: [Axes; 2],
    /// Angular velocity of the child against the parent, in the ground's axes.
    pub spin: Vector,
    /// Against displacement.
    pub stiffness: Tensor,
    /// Against velocity.
    pub damping: Tensor,
    /// Against turning.
    pub torsion_stiffness: Tensor,
    /// Against angular velocity.
    pub torsion_damping: Tensor,
    /// Force against turning, and torque against displacement.
    pub cross_stiffness: Tensor,
}
