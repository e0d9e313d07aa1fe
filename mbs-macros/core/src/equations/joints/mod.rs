//! Joints and constraints, one file each: what the declaration says (`read`, stage 2) and the rows that follow
//! (`equations`, stage 3). Joints of one world are in `planar` and `spatial`, conditions of both here. A new
//! joint needs its file, a line in `read` and an entry in the schema.

mod bar_length;
mod coupling;
mod distance;
mod drive;
mod holonomic;
mod nonholonomic;
mod planar;
mod spatial;

use crate::model::{Arguments, Dimension, Link, Owner, Point};
use crate::schema::World;
use crate::symbolic::{Expr, Graph};
use std::fmt::Debug;

pub use bar_length::bar_length;

/// A joint or constraint.
pub trait Joint: Debug {
    /// Its rows and reactions.
    fn equations(&self, graph: &mut Graph) -> JointEquations;

    /// The points it holds; its reaction acts on the last.
    fn points(&self) -> Vec<&Point> {
        Vec::new()
    }

    /// Parts that it holds otherwise than by points.
    fn owners(&self) -> Vec<Owner> {
        Vec::new()
    }

    /// Two points that coincide (guesses are carried along such pairs).
    fn coincident(&self) -> Option<(&Point, &Point)> {
        None
    }

    /// What it leaves free between its partners, if joint coordinates can take its place.
    fn link(&self) -> Option<Link> {
        None
    }

    /// Parent and child point, if the joint says no more than that they coincide: then they may be merged.
    fn merges(&self) -> Option<(&Point, &Point)> {
        None
    }
}

/// What a joint contributes.
#[derive(Debug, Default)]
pub struct JointEquations {
    /// Its rows.
    pub rows: Vec<JointRow>,
    /// The force and torque on the child.
    pub reactions: Vec<ReactionComponent>,
}

/// A row in local coordinates.
#[derive(Debug, Clone)]
pub struct JointRow {
    /// Appended to the joint's name: `x`, `angle`; may be empty.
    pub suffix: String,
    /// Whether the condition is φ = 0 or ψ̇ = 0.
    pub level: Level,
    /// φ or ψ̇.
    pub expr: Expr,
    /// Dimension of the expression.
    pub dimension: Option<Dimension>,
}

impl JointRow {
    /// Its name: that of the entry and the component.
    pub fn name(&self, entry: &str) -> String {
        match self.suffix.as_str() {
            "" => entry.to_owned(),
            index if index.starts_with('[') => format!("{entry}{index}"),
            suffix => format!("{entry}.{suffix}"),
        }
    }
}

/// At which level a condition is given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Level {
    /// φ(q, t) = 0.
    Position,
    /// ψ̇ = N(q) v + n(q, t) = 0.
    Velocity,
}

/// A component of the reaction on the child: Σ coefficient · λ of the joint's own rows.
#[derive(Debug, Clone)]
pub struct ReactionComponent {
    /// `fx`, `fy`, `torque`, ….
    pub name: &'static str,
    /// Its dimension.
    pub dimension: Dimension,
    /// (row of this joint, coefficient)
    pub terms: Vec<(usize, Expr)>,
}

/// Reads a joint or constraint.
pub fn read(kind: &str, arguments: &mut Arguments) -> Option<Box<dyn Joint>> {
    match kind {
        "Distance" => distance::read(arguments),
        "Coupling" => coupling::read(arguments),
        "Drive" => drive::read(arguments),
        "Holonomic" => holonomic::read(arguments),
        "Nonholonomic" => nonholonomic::read(arguments),
        _ => match arguments.world() {
            World::Planar => planar::read(kind, arguments),
            World::Spatial => spatial::read(kind, arguments),
        },
    }
}

fn row(suffix: &str, expr: Expr, dimension: Dimension) -> JointRow {
    JointRow {
        suffix: suffix.to_owned(),
        level: Level::Position,
        expr,
        dimension: Some(dimension),
    }
}

/// second − ratio · first − offset
fn affine_relation(
    graph: &mut Graph,
    first: Expr,
    second: Expr,
    ratio: Expr,
    offset: Expr,
) -> Expr {
    let driven = graph.mul(ratio, first);
    let difference = graph.sub(second, driven);
    graph.sub(difference, offset)
}

/// The dimension of the multiplier of a condition: power over the rate of φ, or over ψ̇.
fn multiplier_dimension(level: Level, condition: Option<Dimension>) -> Dimension {
    let condition = condition.unwrap_or(Dimension::NONE);
    match level {
        Level::Position => Dimension::TORQUE.over(condition),
        Level::Velocity => Dimension::TORQUE.over(Dimension::TIME).over(condition),
    }
}
