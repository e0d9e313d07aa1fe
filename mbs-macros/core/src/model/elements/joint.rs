//! A joint or constraint, as data.

use crate::dimension::Dimension;
use crate::model::geometry::{Owner, Point};
use crate::model::mobilizer::Mobilizer;
use crate::symbolic::Expr;

/// The conditions of a joint or constraint on its partners, and its reaction.
#[derive(Debug, Clone, Default)]
pub struct Joint {
    /// Its conditions.
    pub conditions: Vec<Condition>,
    /// The force and torque on the child.
    pub reactions: Vec<ReactionComponent>,
    /// The points it holds; its reaction acts on the last.
    pub points: Vec<Point>,
    /// Parts that it holds without points.
    pub owners: Vec<Owner>,
    /// Two points that coincide (guesses are propagated along such pairs).
    pub coincident: Option<[Point; 2]>,
    /// Parent and child point, if the joint has no other condition than their coincidence: then they may
    /// be merged.
    pub merges: Option<[Point; 2]>,
    /// The freedoms between its partners, if they can become joint coordinates.
    pub mobilizer: Option<Mobilizer>,
    /// In the plane, an angle that it holds (guesses are propagated along it).
    pub held_angle: Option<HeldAngle>,
}

/// The angle of a part of the plane against another, or against the ground.
#[derive(Debug, Clone, Copy)]
pub struct HeldAngle {
    /// The partner that the angle is counted from.
    pub parent: Owner,
    /// The part that has the angle.
    pub child: Owner,
    /// A function of time, parameters and inputs.
    pub angle: Expr,
}

/// An expression in local coordinates that is to be zero.
#[derive(Debug, Clone)]
pub struct Condition {
    /// Appended to the joint's name: `x`, `angle`; may be empty.
    pub suffix: String,
    /// Whether the condition is φ = 0 or ψ̇ = 0.
    pub level: Level,
    /// φ or ψ̇.
    pub expr: Expr,
    /// Dimension of the expression.
    pub dimension: Option<Dimension>,
}

/// The level of a condition.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Level {
    /// φ(q, t) = 0.
    Position,
    /// ψ̇ = N(q) v + n(q, t) = 0.
    Velocity,
}

/// A component of the reaction on the child: Σ coefficient · λ of the joint's own conditions.
#[derive(Debug, Clone)]
pub struct ReactionComponent {
    /// `fx`, `fy`, `torque`, ….
    pub name: &'static str,
    /// Its dimension.
    pub dimension: Dimension,
    /// (condition of this joint, coefficient)
    pub terms: Vec<(usize, Expr)>,
}

impl Condition {
    /// φ = 0, of a known dimension.
    pub fn position(suffix: &str, expr: Expr, dimension: Dimension) -> Condition {
        Condition {
            suffix: suffix.to_owned(),
            level: Level::Position,
            expr,
            dimension: Some(dimension),
        }
    }

    /// Its name: that of the entry and the component.
    pub fn name(&self, entry: &str) -> String {
        match self.suffix.as_str() {
            "" => entry.to_owned(),
            index if index.starts_with('[') => format!("{entry}{index}"),
            suffix => format!("{entry}.{suffix}"),
        }
    }

    /// The dimension of its multiplier: power over the rate of φ, or over ψ̇.
    pub fn multiplier_dimension(&self) -> Dimension {
        let condition = self.dimension.unwrap_or(Dimension::NONE);
        match self.level {
            Level::Position => Dimension::TORQUE.over(condition),
            Level::Velocity => Dimension::TORQUE.over(Dimension::TIME).over(condition),
        }
    }
}

impl ReactionComponent {
    /// A force: λ of one condition times a coefficient.
    pub fn force(name: &'static str, condition: usize, coefficient: Expr) -> ReactionComponent {
        ReactionComponent {
            name,
            dimension: Dimension::FORCE,
            terms: vec![(condition, coefficient)],
        }
    }
}
