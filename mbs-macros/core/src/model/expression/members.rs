//! What follows a dot: points and directions of parts, components of vectors.

use crate::diagnostics::{Place, did_you_mean};
use crate::model::resolve::Resolver;
use crate::model::value::Value;
use crate::model::{Dimension, Owner, Point, Vector};
use crate::symbolic::{Node, Symbol};
use proc_macro2::Span;
use syn::Expr as Syntax;

impl Resolver<'_> {
    pub(super) fn member(&mut self, value: &Value, member: &str, span: Span) -> Option<Value> {
        match (value, member) {
            (Value::Point(point), "x" | "y") => {
                let slot = usize::from(member == "y");
                Some(Value::Scalar(point.position[slot], Some(Dimension::LENGTH)))
            }
            (Value::Point(point), "velocity") => Some(Value::Vector(
                self.graph.vector_rate(point.position),
                Some(Dimension::VELOCITY),
            )),
            (Value::Point(_), _) => {
                self.unknown_member(value, member, &["x", "y", "velocity"], span)
            }
            (Value::Vector(v, dimension), "x" | "y") => {
                Some(Value::Scalar(v[usize::from(member == "y")], *dimension))
            }
            (Value::Vector(..), _) => self.unknown_member(value, member, &["x", "y"], span),
            (Value::Scalar(x, dimension), "rate") => match self.graph.node(*x) {
                Node::Symbol(Symbol::LocalPosition(i)) => {
                    let rate = self.graph.symbol(Symbol::LocalVelocity(*i));
                    Some(Value::Scalar(
                        rate,
                        dimension.map(|d| d.over(Dimension::TIME)),
                    ))
                }
                _ => self.fail(
                    span,
                    "only a coordinate has `.rate`; for an expression write rate(…)",
                ),
            },
            (Value::Frame(owner), _) => self.frame_member(*owner, member, span),
            (other, _) => self.fail(span, format!("{} has no `{member}`", other.describe())),
        }
    }

    fn frame_member(&mut self, owner: Owner, member: &str, span: Span) -> Option<Value> {
        if let Some(point) = self.named_point(owner, member) {
            return Some(Value::Point(point));
        }
        let frame = self.frame(owner);
        match member {
            "x" => Some(Value::Vector(frame.axis, Some(Dimension::NONE))),
            "y" => Some(Value::Vector(
                self.graph.perpendicular(frame.axis),
                Some(Dimension::NONE),
            )),
            "rate" => Some(Value::Scalar(frame.rate, Some(Dimension::RATE))),
            "velocity" => Some(Value::Vector(
                self.graph.vector_rate(frame.origin),
                Some(Dimension::VELOCITY),
            )),
            "angle" => {
                let angle = match frame.angle {
                    Some(angle) => angle,
                    None => self.graph.atan2(frame.axis[1], frame.axis[0]),
                };
                Some(Value::Scalar(angle, Some(Dimension::NONE)))
            }
            "length" if self.bar_length(owner).is_some() => self
                .bar_length(owner)
                .map(|length| Value::Scalar(length, Some(Dimension::LENGTH))),
            _ => {
                let mut known: Vec<&str> = self.point_names(owner).to_vec();
                known.extend(["angle", "rate", "velocity", "x", "y"]);
                self.unknown_member(&Value::Frame(owner), member, &known, span)
            }
        }
    }

    fn unknown_member(
        &mut self,
        value: &Value,
        member: &str,
        known: &[&str],
        span: Span,
    ) -> Option<Value> {
        let what = match value {
            Value::Frame(owner) => format!("`{}`", self.owner_name(*owner)),
            other => other.describe(),
        };
        let hint = did_you_mean(member, known.iter().copied());
        self.fail(
            span,
            format!(
                "{what} has no `{member}`{hint} (it has: {})",
                known.join(", ")
            ),
        )
    }

    pub(super) fn frame_method(
        &mut self,
        receiver: &Syntax,
        name: &str,
        span: Span,
        arguments: &[&Syntax],
    ) -> Option<Value> {
        let value = self.evaluate(receiver)?;
        let Value::Frame(owner) = value else {
            return self.fail(
                Place::of(receiver),
                format!(
                    "`{name}` belongs to parts and the ground, but this is {}",
                    value.describe()
                ),
            );
        };
        if name == "point" {
            let [x, y] = self.take(arguments.to_vec(), name, span)?;
            let ((x, dx), (y, dy)) = (self.scalar(x)?, self.scalar(y)?);
            for (dimension, argument) in [(dx, arguments[0]), (dy, arguments[1])] {
                if dimension.is_some_and(|d| d != Dimension::LENGTH) {
                    return self.fail(
                        Place::of(argument),
                        "the coordinates of a point are lengths (m)",
                    );
                }
            }
            for (expr, argument) in [(x, arguments[0]), (y, arguments[1])] {
                if self
                    .graph
                    .depends_on(expr, |symbol| !symbol.is_parameter_like())
                {
                    return self.fail(
                        Place::of(argument),
                        "a point is fixed in its part: its coordinates may use parameters only",
                    );
                }
            }
            let label = format!(
                "{}.point({}, {})",
                self.owner_name(owner),
                self.graph.text(x),
                self.graph.text(y)
            );
            return Some(Value::Point(self.point_of(owner, [x, y], label)));
        }
        let [at] = self.take(arguments.to_vec(), name, span)?;
        let (at, _) = self.vector(at)?;
        let frame = self.frame(owner);
        let arm = self.graph.vector_sub(at, frame.origin);
        let turned = self.graph.perpendicular(arm);
        let swing = self.graph.vector_scale(frame.rate, turned);
        let velocity = self.graph.vector_rate(frame.origin);
        Some(Value::Vector(
            self.graph.vector_add(velocity, swing),
            Some(Dimension::VELOCITY),
        ))
    }

    /// A point of a part or of the ground given by its local coordinates.
    pub(in crate::model) fn point_of(
        &mut self,
        owner: Owner,
        local: Vector,
        label: String,
    ) -> Point {
        let frame = self.frame(owner);
        let offset = self.graph.turn(frame.axis, local);
        let position = self.graph.vector_add(frame.origin, offset);
        Point {
            position,
            owner,
            local,
            free: None,
            label,
        }
    }
}
