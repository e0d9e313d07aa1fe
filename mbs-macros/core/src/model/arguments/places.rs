//! Vectors, points, parts and frames.

use super::Arguments;
use crate::diagnostics::Place;
use crate::model::value::Value;
use crate::model::{Dimension, Frame, Owner, Point, Vector};
use crate::schema::Expects;
use crate::symbolic::Expr;
use syn::Expr as Syntax;

impl Arguments<'_, '_> {
    /// Two components of the dimension that the schema asks for.
    pub fn vector(&mut self, field: &str) -> Option<Vector> {
        let syntax = self.syntax(field)?;
        let (vector, dimension) = self.resolver.vector(syntax)?;
        let expects = self.expects(field)?;
        if let Expects::KnownVector(expected) | Expects::MovingVector(expected) = expects {
            self.check_dimension(field, dimension, expected, Place::of(syntax))?;
        }
        if matches!(expects, Expects::KnownVector(_)) {
            self.check_known(field, syntax, &vector)?;
        }
        Some(vector)
    }

    /// A point; a particle stands for its own.
    pub fn point(&mut self, field: &str) -> Option<Point> {
        let syntax = self.syntax(field)?;
        match self.resolver.evaluate(syntax)? {
            Value::Point(point) => Some(point),
            Value::Frame(owner) => {
                let names = self.resolver.point_names(owner);
                if names == ["origin"] && owner != Owner::Ground {
                    return self.resolver.named_point(owner, "origin");
                }
                let name = self.resolver.owner_name(owner).to_owned();
                let examples: Vec<_> = names
                    .iter()
                    .map(|point| format!("`{name}.{point}`"))
                    .collect();
                self.resolver.fail(
                    Place::of(syntax),
                    format!(
                        "`{field}` is a point: name one of `{name}`, such as {}",
                        examples.join(" or ")
                    ),
                )
            }
            other => {
                let what = other.describe();
                self.resolver.fail(Place::of(syntax), format!("`{field}` is a point, such as `crank.b` or `ground.origin`, but this is {what}"))
            }
        }
    }

    /// A part or the ground.
    pub fn part(&mut self, field: &str) -> Option<Owner> {
        let syntax = self.syntax(field)?;
        match self.resolver.evaluate(syntax)? {
            Value::Frame(owner) => Some(owner),
            other => {
                let what = other.describe();
                self.resolver.fail(
                    Place::of(syntax),
                    format!("`{field}` is a part or `ground`, but this is {what}"),
                )
            }
        }
    }

    /// The frame of the ground or of a part.
    pub fn frame(&mut self, owner: Owner) -> Frame {
        self.resolver.frame(owner)
    }

    /// The part of this index is a particle, which has no orientation.
    pub fn is_particle(&self, owner: Owner) -> bool {
        matches!(owner, Owner::Part(part) if self.resolver.parts[part].kind == "Particle")
    }

    /// The name of a part.
    pub fn owner_name(&self, owner: Owner) -> String {
        self.resolver.owner_name(owner).to_owned()
    }

    /// The length of a bar.
    pub fn bar_length(&self, owner: Owner) -> Option<Expr> {
        self.resolver.bar_length(owner)
    }

    /// A direction of unit length, turned into the ground's axes from those of `owner`.
    pub fn axis(&mut self, field: &str, owner: Owner) -> Option<Vector> {
        let components = match self.syntax(field) {
            None => [self.resolver.graph.one(), self.resolver.graph.zero()],
            Some(syntax) => {
                let (vector, dimension) = self.resolver.vector(syntax)?;
                self.check_known(field, syntax, &vector)?;
                self.check_dimension(field, dimension, Dimension::NONE, Place::of(syntax))?;
                if vector.iter().all(|&x| self.resolver.graph.is_zero(x)) {
                    return self.resolver.fail(
                        Place::of(syntax),
                        "this axis has no length; give it a direction, such as X or [1.0, 1.0]",
                    );
                }
                let norm = self.resolver.graph.norm(vector);
                let one = self.resolver.graph.one();
                let inverse = self.resolver.graph.div(one, norm);
                self.resolver.graph.vector_scale(inverse, vector)
            }
        };
        let frame = self.resolver.frame(owner);
        Some(self.resolver.graph.turn(frame.axis, components))
    }

    /// `Frame([x, y], angle)`.
    pub fn prescribed_frame(&mut self, field: &str) -> Option<(Vector, Expr)> {
        let syntax = self.syntax(field)?;
        let expected = "expected `Frame([x, y], angle)`";
        let Syntax::Call(call) = syntax else {
            return self.resolver.fail(Place::of(syntax), expected);
        };
        let is_frame = matches!(&*call.func, Syntax::Path(path) if path.path.is_ident("Frame"));
        if !is_frame || call.args.len() != 2 {
            return self.resolver.fail(Place::of(syntax), expected);
        }
        let (position, dimension) = self.resolver.vector(&call.args[0])?;
        self.check_dimension(
            field,
            dimension,
            Dimension::LENGTH,
            Place::of(&call.args[0]),
        )?;
        let (angle, dimension) = self.resolver.scalar(&call.args[1])?;
        self.check_dimension(field, dimension, Dimension::NONE, Place::of(&call.args[1]))?;
        for (syntax, exprs) in [
            (&call.args[0], position.to_vec()),
            (&call.args[1], vec![angle]),
        ] {
            self.check_configuration(syntax, &exprs)?;
        }
        Some((position, angle))
    }

    /// A position as an expression of coordinates.
    pub fn prescribed_position(&mut self, field: &str) -> Option<Vector> {
        let position = self.vector(field)?;
        let syntax = self.syntax(field)?;
        self.check_configuration(syntax, &position)?;
        Some(position)
    }

    /// The part that an expression names, if it does.
    pub fn part_of(&mut self, syntax: &Syntax) -> Option<Owner> {
        match self
            .resolver
            .silently(|resolver| resolver.evaluate(syntax))?
        {
            Value::Frame(owner) => {
                self.resolver
                    .used
                    .insert(self.resolver.owner_name(owner).to_owned());
                Some(owner)
            }
            _ => None,
        }
    }
}
