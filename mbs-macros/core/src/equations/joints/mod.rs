//! Joints and constraints, one file each: what the declaration says (`read`, stage 2) and the rows that follow
//! (`equations`, stage 3). A new joint needs its file, a line in [`read`] and an entry in the schema.

mod alignment;
mod bar_length;
mod coupling;
mod distance;
mod drive;
mod fixed;
mod gear;
mod holonomic;
mod nonholonomic;
mod point_on_line;
mod prismatic;
mod revolute;

use crate::model::{Arguments, Dimension, Owner, Point, Vector};
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
        "Revolute" => revolute::read(arguments),
        "Prismatic" => prismatic::read(arguments),
        "Fixed" => fixed::read(arguments),
        "PointOnLine" => point_on_line::read(arguments),
        "Distance" => distance::read(arguments),
        "Gear" => gear::read(arguments),
        "Coupling" => coupling::read(arguments),
        "Drive" => drive::read(arguments),
        "Holonomic" => holonomic::read(arguments),
        "Nonholonomic" => nonholonomic::read(arguments),
        _ => None,
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

/// φ = child − parent, two rows; λ is the force on the child.
fn coincidence(graph: &mut Graph, parent: &Point, child: &Point) -> JointEquations {
    let gap = graph.vector_sub(child.position, parent.position);
    let one = graph.one();
    let force = |name, row| ReactionComponent {
        name,
        dimension: Dimension::FORCE,
        terms: vec![(row, one)],
    };
    JointEquations {
        rows: vec![
            row("x", gap[0], Dimension::LENGTH),
            row("y", gap[1], Dimension::LENGTH),
        ],
        reactions: vec![force("fx", 0), force("fy", 1)],
    }
}

/// n · (child − parent) = 0 with n across `axis`; λ n is the force on the child.
fn across(
    graph: &mut Graph,
    parent: &Point,
    child: &Point,
    axis: Vector,
    suffix: &str,
) -> JointEquations {
    let normal = graph.perpendicular(axis);
    let gap = graph.vector_sub(child.position, parent.position);
    let across = graph.dot(normal, gap);
    let force = |name, n| ReactionComponent {
        name,
        dimension: Dimension::FORCE,
        terms: vec![(0, n)],
    };
    JointEquations {
        rows: vec![row(suffix, across, Dimension::LENGTH)],
        reactions: vec![force("fx", normal[0]), force("fy", normal[1])],
    }
}

/// The multiplier of row `row` as a torque on the child.
fn torque(graph: &mut Graph, row: usize) -> ReactionComponent {
    ReactionComponent {
        name: "torque",
        dimension: Dimension::TORQUE,
        terms: vec![(row, graph.one())],
    }
}

/// The dimension of the multiplier of a condition: power over the rate of φ, or over ψ̇.
fn multiplier_dimension(level: Level, condition: Option<Dimension>) -> Dimension {
    let condition = condition.unwrap_or(Dimension::NONE);
    match level {
        Level::Position => Dimension::TORQUE.over(condition),
        Level::Velocity => Dimension::TORQUE.over(Dimension::TIME).over(condition),
    }
}
