//! Vectors, points, parts and frames.

use super::Arguments;
use crate::diagnostics::Place;
use crate::dimension::Dimension;
use crate::model::parts::StartPlace;
use crate::model::value::Value;
use crate::model::{Frame, Owner, Point, Representation, Tensor, Vector};
use crate::schema::{Expects, World};
use crate::symbolic::Expr;
use syn::Expr as Syntax;

impl Arguments<'_, '_> {
    /// A vector of the dimension in the schema.
    pub fn vector(&mut self, field: &str) -> Option<Vector> {
        let syntax = self.syntax(field)?;
        let (vector, dimension) = self.resolver.vector(syntax)?;
        let expects = self.expects(field)?;
        if let Expects::KnownVector(expected)
        | Expects::MovingVector(expected)
        | Expects::FollowingVector(expected) = expects
        {
            self.check_dimension(field, dimension, expected, Place::of(syntax))?;
        }
        if matches!(expects, Expects::KnownVector(_)) {
            self.check_known(field, syntax, &vector)?;
        }
        Some(vector)
    }

    /// A place of the home pose of space, in which points of parts stand for where they are there.
    pub fn home_place(&mut self, field: &str) -> Option<Vector> {
        self.at_home(|arguments| arguments.vector(field))
    }

    /// Evaluates with the points and axes of parts in the home pose.
    pub(super) fn at_home<T>(&mut self, evaluate: impl FnOnce(&mut Self) -> T) -> T {
        let home = self.resolver.world == World::Spatial;
        let before = std::mem::replace(&mut self.resolver.in_home_pose, home);
        let value = evaluate(self);
        self.resolver.in_home_pose = before;
        value
    }

    /// A place at the start: a vector, or a point of a part, which stands for where it is there.
    pub fn start_place(&mut self, field: &str) -> Option<StartPlace> {
        let syntax = self.syntax(field)?;
        if self.resolver.world == World::Planar {
            let value = self.resolver.silently(|resolver| resolver.evaluate(syntax));
            if let Some(Value::Point(point)) = value
                && point.owner != Owner::Ground
            {
                // Once more, so that what it names counts as used.
                self.resolver.evaluate(syntax)?;
                return Some(StartPlace::Of(point));
            }
        }
        self.home_place(field).map(StartPlace::Known)
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

    /// The length of a bar.
    pub fn length(&self, owner: Owner) -> Option<Expr> {
        self.resolver.parts[owner.part()?].length
    }

    /// The part of this index is a particle, which has no orientation.
    pub fn is_particle(&self, owner: Owner) -> bool {
        self.resolver.is_particle(owner)
    }

    /// The name of a part.
    pub fn owner_name(&self, owner: Owner) -> String {
        self.resolver.owner_name(owner).to_owned()
    }

    /// Whether a part is a slender bar of space, which has a direction but no orientation.
    pub fn is_slender(&self, owner: Owner) -> bool {
        let Owner::Part(part) = owner else {
            return false;
        };
        self.resolver.world == World::Spatial
            && self.resolver.parts[part].representation == Representation::Natural
    }

    /// A direction of unit length in the axes of the part that it is fixed in; X where it was not given.
    pub fn own_axis(&mut self, field: &str) -> Option<Vector> {
        match self.syntax(field) {
            None => Some(self.resolver.graph.ground_axes()[0]),
            Some(syntax) => self.direction_of(field, syntax),
        }
    }

    /// The same of `owner`, turned into the ground's axes.
    pub fn axis(&mut self, field: &str, owner: Owner) -> Option<Vector> {
        let components = self.own_axis(field)?;
        let frame = self.resolver.frame(owner);
        Some(self.resolver.graph.turn(&frame.axes, components))
    }

    /// A direction fixed in `owner`, in the ground's axes, given by its components there in the home pose.
    pub fn home_axis(&mut self, field: &str, default: usize, owner: Owner) -> Option<Vector> {
        let direction = match self.syntax(field) {
            None => self.resolver.graph.ground_axes()[default],
            Some(syntax) => self.at_home(|arguments| arguments.direction_of(field, syntax))?,
        };
        Some(self.fixed_direction(direction, owner))
    }

    /// A direction of the home pose, in parameters, fixed in `owner` from then on.
    pub fn fixed_direction(&mut self, direction: Vector, owner: Owner) -> Vector {
        let home = self.resolver.home(owner);
        let frame = self.resolver.frame(owner);
        let graph = &mut self.resolver.graph;
        let local = graph.components(&home.axes, direction);
        graph.turn(&frame.axes, local)
    }

    /// A direction of unit length, in parameters.
    pub(in crate::model) fn direction_of(
        &mut self,
        field: &str,
        syntax: &Syntax,
    ) -> Option<Vector> {
        let (vector, dimension) = self.resolver.vector(syntax)?;
        self.check_known(field, syntax, &vector)?;
        self.check_dimension(field, dimension, Dimension::NONE, Place::of(syntax))?;
        if vector.iter().all(|&x| self.by_default(x) == 0.0) {
            return self.resolver.no_direction(syntax);
        }
        Some(self.resolver.graph.unit(vector))
    }

    /// Refuses a place or motion at the start beside that of coordinates.
    pub fn refuse_start(&mut self, follows: &str) -> Option<()> {
        let fields = ["at", "from", "to", "angle", "velocity", "rate"];
        let Some(field) = fields.into_iter().find(|field| self.has(field)) else {
            return Some(());
        };
        let name = self.entry_name();
        let instead = match field {
            "from" | "to" => "give its `length =`",
            _ => "give the coordinates their values",
        };
        self.fail(
            field,
            format!("`{name}` follows its `{follows}`, at the start, too: leave `{field} =` out, and {instead}"),
        )
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
            self.check_configuration(field, syntax, &exprs)?;
        }
        Some((position, angle))
    }

    /// A position as an expression of coordinates.
    pub fn prescribed_position(&mut self, field: &str) -> Option<Vector> {
        let position = self.vector(field)?;
        let syntax = self.syntax(field)?;
        self.check_configuration(field, syntax, &position)?;
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

    /// Whether an argument names a joint.
    pub fn names_joint(&mut self, field: &str) -> bool {
        let Some(syntax) = self.syntax(field) else {
            return false;
        };
        let value = self.resolver.silently(|resolver| resolver.evaluate(syntax));
        matches!(value, Some(Value::Joint(_)))
    }

    /// Stiffness or damping in three directions: a number for all, three numbers, or a matrix; zero if it was not given.
    pub fn gains(&mut self, field: &str) -> Option<Tensor> {
        let zero = self.graph().zero();
        let Some(syntax) = self.syntax(field) else {
            return Some([[zero; 3]; 3]);
        };
        let (tensor, dimension) = match self.resolver.evaluate(syntax)? {
            Value::Scalar(x, dimension) => (self.diagonal([x; 3]), dimension),
            Value::Vector(v, dimension) => (self.diagonal(v), dimension),
            Value::Tensor(tensor, dimension) => (tensor, dimension),
            other => {
                let what = other.describe();
                return self.fail(
                    field,
                    format!(
                        "`{field}` is a number, three numbers or three rows, but this is {what}"
                    ),
                );
            }
        };
        if let Some(Expects::Gains(expected)) = self.expects(field) {
            self.check_dimension(field, dimension, expected, Place::of(syntax))?;
        }
        self.check_known(field, syntax, tensor.as_flattened())?;
        let value = tensor.map(|row| row.map(|x| self.by_default(x)));
        let skew = [(0, 1), (0, 2), (1, 2)]
            .into_iter()
            .find(|&(i, j)| value[i][j] != value[j][i]);
        if let (Some((i, j)), "stiffness" | "torsion_stiffness") = (skew, field) {
            return self.fail(
                field,
                format!(
                    "a stiffness is symmetric, as it has a potential, but entry [{i}][{j}] is {} and [{j}][{i}] is {}",
                    value[i][j], value[j][i]
                ),
            );
        }
        Some(tensor)
    }
}
