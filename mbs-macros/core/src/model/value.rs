//! What an expression of the declaration can be.

use super::geometry::{Attachment, Owner, Point, Tensor, Vector};
use super::joint_frames::JointFrames;
use crate::dimension::Dimension;
use crate::symbolic::{Expr, Graph, Symbol, Table};
use std::sync::Arc;

/// The value of an expression. A dimension of `None` is that of a bare number: it fits anywhere.
#[derive(Debug, Clone)]
pub(super) enum Value {
    Scalar(Expr, Option<Dimension>),
    Vector(Vector, Option<Dimension>),
    Tensor(Tensor, Option<Dimension>),
    Point(Point),
    Frame(Owner),
    Attachment(Box<Attachment>),
    Joint(Box<JointFrames>),
    /// The reaction of the joint of this name.
    Reaction(String),
    List(Vec<Value>),
    Table(Arc<Table>, TableDimensions),
}

/// What a table takes, and what it gives.
pub(super) type TableDimensions = [Option<Dimension>; 2];

impl Value {
    pub(super) fn describe(&self) -> String {
        match self {
            Value::Scalar(_, dimension) => {
                dimension.map_or("a number".to_owned(), |d| d.to_string())
            }
            Value::Vector(..) => "a vector".to_owned(),
            Value::Tensor(..) => "a tensor".to_owned(),
            Value::Attachment(frame) => format!("a frame at `{}`", frame.point.label),
            Value::Joint(joint) => format!("the joint `{}`", joint.name),
            Value::Reaction(joint) => format!("the reaction of `{joint}`"),
            Value::Point(point) => format!("the point `{}`", point.label),
            Value::Frame(Owner::Ground) => "the ground".to_owned(),
            Value::Frame(Owner::Part(_)) => "a part".to_owned(),
            Value::Table(table, _) => format!("a table (write `{}(…)`)", table.name),
            Value::List(items) => {
                let items = items.iter().map(|item| match item {
                    Value::List(_) => "a list".to_owned(),
                    other => other.describe(),
                });
                format!("a list of {}", items.collect::<Vec<_>>().join(", "))
            }
        }
    }

    /// The same, of a vector with its unit.
    pub(super) fn with_unit(&self) -> String {
        match self {
            Value::Vector(_, Some(Dimension::NONE)) => "a vector of pure numbers".to_owned(),
            Value::Vector(_, Some(dimension)) => format!("a vector in {}", dimension.unit()),
            other => other.describe(),
        }
    }

    /// Whether it depends on a symbol for which `predicate` holds.
    pub(in crate::model) fn depends_on(
        &self,
        graph: &Graph,
        predicate: impl Fn(Symbol) -> bool,
    ) -> bool {
        self.expressions()
            .into_iter()
            .any(|x| graph.depends_on(x, &predicate))
    }

    /// All expressions inside.
    pub(super) fn expressions(&self) -> Vec<Expr> {
        match self {
            Value::Scalar(x, _) => vec![*x],
            Value::Vector(v, _) => v.to_vec(),
            Value::Point(point) => point.position.to_vec(),
            Value::Tensor(tensor, _) => tensor.as_flattened().to_vec(),
            Value::Attachment(frame) => frame.point.position.to_vec(),
            Value::Frame(_) | Value::Joint(_) | Value::Reaction(_) | Value::Table(..) => Vec::new(),
            Value::List(items) => items.iter().flat_map(Value::expressions).collect(),
        }
    }
}

/// The common dimension of two summands; `Err` if they differ.
pub(super) fn unify(a: Option<Dimension>, b: Option<Dimension>) -> Result<Option<Dimension>, ()> {
    match (a, b) {
        (Some(a), Some(b)) if a != b => Err(()),
        (Some(a), _) => Ok(Some(a)),
        (None, b) => Ok(b),
    }
}
