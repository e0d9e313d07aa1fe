//! What follows a dot: points and directions of parts, components of vectors.

use crate::diagnostics::{Place, did_you_mean};
use crate::dimension::Dimension;
use crate::model::resolver::Resolver;
use crate::model::value::Value;
use crate::model::{Owner, Point, Representation, Vector};
use crate::schema::World;
use crate::symbolic::{Expr, Node, Symbol};
use proc_macro2::Span;
use syn::Expr as Syntax;

/// Bytes of a formula in the name of a point, at most.
const LABEL: usize = 400;

impl Resolver<'_> {
    pub(super) fn member(&mut self, value: &Value, member: &str, span: Span) -> Option<Value> {
        let axes = &["x", "y", "z"][..self.world.dimension()];
        let component = axes.iter().position(|axis| *axis == member);
        match (value, component) {
            (Value::Point(point), Some(axis)) => {
                let position = self.position(point);
                Some(Value::Scalar(position[axis], Some(Dimension::LENGTH)))
            }
            (Value::Point(point), None) if member == "velocity" => Some(Value::Vector(
                self.graph.vector_rate(point.position),
                Some(Dimension::VELOCITY),
            )),
            (Value::Point(point), None) if member == "acceleration" => {
                let velocity = self.graph.vector_rate(point.position);
                self.acceleration(velocity, Some(Dimension::VELOCITY), span)
            }
            (Value::Point(_), None) => {
                let known: Vec<&str> = axes
                    .iter()
                    .copied()
                    .chain(["velocity", "acceleration"])
                    .collect();
                self.no_such_member(value, member, &known, "", span)
            }
            (Value::Vector(v, dimension), Some(axis)) => Some(Value::Scalar(v[axis], *dimension)),
            (Value::Vector(..), None) => self.no_such_member(value, member, axes, "", span),
            (Value::Scalar(x, dimension), _) if member == "rate" => match self.graph.node(*x) {
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
            (Value::Joint(joint), _) => self.joint_member(joint, member, span),
            (Value::Reaction(joint), _) => Some(self.reaction_component(joint, member, span)),
            (other, _) => self.fail(span, format!("{} has no `{member}`", other.describe())),
        }
    }

    fn frame_member(&mut self, owner: Owner, member: &str, span: Span) -> Option<Value> {
        if let Some(point) = self.named_point(owner, member) {
            return Some(Value::Point(point));
        }
        let frame = self.frame(owner);
        // A slender bar has a direction only.
        let axes = self.axes(owner);
        let axis = ["x", "y", "z"][..self.world.dimension()]
            .iter()
            .position(|axis| *axis == member)
            .filter(|&axis| axes[axis].iter().any(|&x| !self.graph.is_zero(x)));
        if let Some(axis) = axis {
            return Some(Value::Vector(axes[axis], Some(Dimension::NONE)));
        }
        let particle = self.is_particle(owner);
        match (self.world, member) {
            (_, "angle" | "rate" | "angular_velocity" | "angular_acceleration") if particle => {
                let known = [self.point_names(owner), &["velocity", "acceleration"]].concat();
                let advice = "a particle has no orientation";
                self.no_such_member(&Value::Frame(owner), member, &known, advice, span)
            }
            (World::Planar, "rate") => Some(Value::Scalar(frame.spin[2], Some(Dimension::RATE))),
            (World::Spatial, "angular_velocity") => {
                Some(Value::Vector(frame.spin, Some(Dimension::RATE)))
            }
            (_, "velocity") => Some(Value::Vector(
                self.graph.vector_rate(frame.origin),
                Some(Dimension::VELOCITY),
            )),
            (_, "acceleration") => {
                let velocity = self.graph.vector_rate(frame.origin);
                self.acceleration(velocity, Some(Dimension::VELOCITY), span)
            }
            (World::Spatial, "angular_acceleration") => {
                self.acceleration(frame.spin, Some(Dimension::RATE), span)
            }
            (World::Planar, "angle") => {
                let angle = self.part_angle(owner);
                Some(Value::Scalar(angle, Some(Dimension::NONE)))
            }
            (_, "length") if self.bar_length(owner).is_some() => self
                .bar_length(owner)
                .map(|length| Value::Scalar(length, Some(Dimension::LENGTH))),
            _ => {
                let mut known: Vec<&str> = self.point_names(owner).to_vec();
                let slender = frame.axes[2].iter().all(|&x| self.graph.is_zero(x));
                known.extend(match self.world {
                    World::Planar => &["angle", "rate", "velocity", "acceleration", "x", "y"][..],
                    World::Spatial => &[
                        "angular_velocity",
                        "velocity",
                        "angular_acceleration",
                        "acceleration",
                        "x",
                        "y",
                        "z",
                    ][..if slender { 5 } else { 7 }],
                });
                let advice = match (self.world, member) {
                    (World::Spatial, "y" | "z") => {
                        "a slender bar has no axes across it; give it `radius =` or `inertia =`"
                    }
                    (World::Spatial, "angle") => "in space joints have angles",
                    (World::Spatial, "rate") => "in space parts have `angular_velocity`",
                    (World::Planar, "angular_velocity") => "in the plane it is the number `rate`",
                    (World::Planar, "z") => "there is no axis Z in the plane",
                    _ => "",
                };
                self.no_such_member(&Value::Frame(owner), member, &known, advice, span)
            }
        }
    }

    /// `advice` stands instead of a guess at what was meant.
    pub(in crate::model) fn no_such_member(
        &mut self,
        value: &Value,
        member: &str,
        known: &[&str],
        advice: &str,
        span: Span,
    ) -> Option<Value> {
        let what = match value {
            Value::Frame(owner) => format!("`{}`", self.owner_name(*owner)),
            other => other.describe(),
        };
        let hint = match advice {
            "" => did_you_mean(member, known.iter().copied()),
            advice => format!("; {advice}"),
        };
        let known = match known {
            [] => String::new(),
            known => format!(" (it has: {})", known.join(", ")),
        };
        self.fail(span, format!("{what} has no `{member}`{hint}{known}"))
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
        match name {
            "point" => self.own_point(owner, span, arguments).map(Value::Point),
            "frame" => self.own_frame(owner, span, arguments),
            _ => {
                let [place] = self.take(arguments.to_vec(), name, span)?;
                let (at, dimension) = self.vector(place)?;
                if dimension.is_some_and(|d| d != Dimension::LENGTH) {
                    return self.fail(
                        Place::of(place),
                        "`velocity_at` takes a point, or its position (m)",
                    );
                }
                let frame = self.frame(owner);
                let arm = self.graph.vector_sub(at, frame.origin);
                let swing = self.graph.cross(frame.spin, arm);
                let velocity = self.graph.vector_rate(frame.origin);
                Some(Value::Vector(
                    self.graph.vector_add(velocity, swing),
                    Some(Dimension::VELOCITY),
                ))
            }
        }
    }

    /// `part.point(x, y)` or `part.point(x, y, z)`.
    fn own_point(&mut self, owner: Owner, span: Span, arguments: &[&Syntax]) -> Option<Point> {
        let mut local = self.graph.zero_vector();
        let list: Vec<&Syntax> = match self.world {
            World::Planar => self.take::<2>(arguments.to_vec(), "point", span)?.to_vec(),
            World::Spatial => self.take::<3>(arguments.to_vec(), "point", span)?.to_vec(),
        };
        let mut found = Vec::new();
        for argument in &list {
            found.push(self.scalar(argument)?);
        }
        for ((slot, &(x, dimension)), argument) in local.iter_mut().zip(&found).zip(&list) {
            if dimension.is_some_and(|d| d != Dimension::LENGTH) {
                return self.fail(
                    Place::of(argument),
                    "the coordinates of a point are lengths (m)",
                );
            }
            *slot = x;
        }
        for (&(x, _), argument) in found.iter().zip(&list) {
            if self
                .graph
                .depends_on(x, |symbol| !symbol.is_parameter_like())
            {
                return self.fail(
                    Place::of(argument),
                    "a point is fixed in its part: its coordinates may use parameters only",
                );
            }
            self.known_without_laws(argument, &[x], "point")?;
        }
        let slender = matches!(owner, Owner::Part(part) if self.world == World::Spatial
            && self.parts[part].representation == Representation::Natural);
        if slender && local[1..].iter().any(|&x| !self.graph.is_zero(x)) {
            let name = self.owner_name(owner).to_owned();
            return self.fail(
                span,
                format!("`{name}` is a slender bar: its points lie on it, at `point(x, 0.0, 0.0)`; give it `radius =` or `inertia =` for others"),
            );
        }
        if self.is_particle(owner) && local.iter().any(|&x| !self.graph.is_zero(x)) {
            let name = self.owner_name(owner).to_owned();
            return self.fail(
                span,
                format!("`{name}` is a particle, and has no point but itself: write `{name}.origin`, or use a Body"),
            );
        }
        let texts: Vec<String> = found
            .iter()
            .map(|&(x, _)| self.coordinate_text(x))
            .collect();
        let label = format!("{}.point({})", self.owner_name(owner), texts.join(", "));
        Some(self.point_of(owner, local, label))
    }

    /// A coordinate in the name of a point; of a long formula the beginning, and the number of its node, by which names differ.
    fn coordinate_text(&self, x: Expr) -> String {
        let text = self.graph.start_of_text(x, LABEL);
        match text.len() > LABEL {
            true => format!("{text} {x:?}"),
            false => text,
        }
    }

    /// `part.frame([x, y, z], axis)`: axes whose z is `axis`, given in those of the part.
    fn own_frame(&mut self, owner: Owner, span: Span, arguments: &[&Syntax]) -> Option<Value> {
        if self.world == World::Planar {
            return self.fail(span, "a planar joint takes points; write `point(x, y)`");
        }
        if self.is_particle(owner) {
            let name = self.owner_name(owner).to_owned();
            return self.fail(
                span,
                format!(
                    "`{name}` is a particle and has no orientation: name it alone, or use a Body"
                ),
            );
        }
        let [place, axis] = self.take(arguments.to_vec(), "frame", span)?;
        let (local, dimension) = self.vector(place)?;
        if dimension.is_some_and(|d| d != Dimension::LENGTH) {
            return self.fail(
                Place::of(place),
                "the coordinates of a point are lengths (m)",
            );
        }
        let (direction, dimension) = self.vector(axis)?;
        if let Some(found) = dimension.filter(|d| *d != Dimension::NONE) {
            return self.fail(
                Place::of(axis),
                format!("the axis of a frame is a direction without unit, but this is {found}"),
            );
        }
        let moving = |symbol: Symbol| !symbol.is_parameter_like();
        for (vector, syntax) in [(local, place), (direction, axis)] {
            if vector.iter().any(|&x| self.graph.depends_on(x, moving)) {
                return self.fail(
                    Place::of(syntax),
                    "a frame is fixed in its part: it may use parameters only",
                );
            }
            self.known_without_laws(syntax, &vector, "frame")?;
        }
        if direction.iter().all(|&x| self.by_default(x) == 0.0) {
            return self.no_direction(axis);
        }
        let direction = self.graph.unit(direction);
        let axes = self.axes_along(direction);
        let label = format!("{}.frame", self.owner_name(owner));
        let frame = self.attach(owner, local, axes, label);
        Some(Value::Attachment(Box::new(frame)))
    }

    /// A point of a part or of the ground given by its local coordinates.
    pub(in crate::model) fn point_of(
        &mut self,
        owner: Owner,
        local: Vector,
        label: String,
    ) -> Point {
        let frame = self.frame(owner);
        Point {
            position: self.graph.place(&frame, local),
            owner,
            local,
            free: None,
            label,
        }
    }
}
