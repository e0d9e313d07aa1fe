//! Bars and bodies of space.

use super::part::{Guess, Home, Part, Representation, StartPlace};
use super::shape::Shape;
use crate::model::arguments::Arguments;
use crate::model::formulation::{self, Formulation};
use crate::model::geometry::{Axes, Frame, Tensor, Vector};
use crate::model::home::NEARLY_TOGETHER;
use crate::model::resolver::Resolver;
use crate::model::value::Value;
use crate::symbolic::{Expr, Symbol};
use crate::syntax::Entry;

impl Resolver<'_> {
    pub(in crate::model) fn spatial_bar(&mut self, entry: &Entry) -> Option<Value> {
        let mut arguments = Arguments::new(self, entry);
        let mass = arguments.mass("mass");
        let free = arguments.flag("free");
        let (from, to) = (arguments.home_place("from"), arguments.home_place("to"));
        let (velocity, spin) = (
            arguments.vector("velocity"),
            arguments.vector("angular_velocity"),
        );
        let zero = arguments.graph().zero();
        // Their errors are recorded already.
        if (from.is_none() && arguments.has("from")) || (to.is_none() && arguments.has("to")) {
            return None;
        }
        let from = from.unwrap_or([zero; 3]);
        let length = match (arguments.has("length"), to) {
            (true, _) => arguments.scalar("length"),
            (false, Some(to)) => {
                let difference = arguments.graph().vector_sub(to, from);
                Some(arguments.graph().norm(difference))
            }
            (false, None) if arguments.are_misplaced() => None,
            (false, None) => arguments.fail(
                "length",
                format!(
                    "`{}` has no length; give `length =`, or its home pose by `from =` and `to =`",
                    entry.name
                ),
            ),
        }?;
        let field = match arguments.has("length") {
            true => "length",
            false => "to",
        };
        arguments.refuse_not_positive(
            field,
            length,
            "a bar has a positive length; for a point mass use `Particle`",
        )?;
        if let (true, Some(to)) = (arguments.has("length"), to) {
            let difference = arguments.graph().vector_sub(to, from);
            let span = arguments.graph().norm(difference);
            let (span, length) = (arguments.by_default(span), arguments.by_default(length));
            if span == 0.0 {
                return arguments.fail("to", "`from` and `to` are the same point, which gives the bar no direction; move one of them, or leave `to` out");
            }
            if (span - length).abs() > NEARLY_TOGETHER * length {
                return arguments.fail("length", format!("`from` and `to` are {span:.4} m apart, but `length` is {length} m; keep one of `length` and `to`, or make them agree"));
            }
        }
        let direction = match to {
            Some(to) => {
                let graph = arguments.graph();
                let difference = graph.vector_sub(to, from);
                graph.unit(difference)
            }
            None => arguments.graph().ground_axes()[0],
        };
        let mass = mass?;
        let rigid = arguments.has("radius") || arguments.has("inertia");
        let possible: &[Formulation] = match rigid {
            true => &formulation::OF_BODIES,
            false => &[Formulation::Natural],
        };
        let (inertia, shape) = match rigid {
            true => arguments.bar_inertia(mass, length)?,
            false => {
                arguments.slender_bar(&["velocity", "angular_velocity"])?;
                ([[zero; 3]; 3], None)
            }
        };
        let formulation = self.wish(entry, possible);
        let x_first = self.axes_along(direction);
        // x along the bar.
        let home = Home {
            origin: from,
            axes: [x_first[2], x_first[0], x_first[1]],
        };
        let name = entry.name.to_string();
        let half = self.graph.scale(0.5, length);
        let center = [half, zero, zero];
        let (representation, locals, frame) = match rigid {
            true => {
                let (locals, frame) = self.rigid(&name, center);
                (Representation::Rigid, locals, frame)
            }
            false => {
                let (locals, frame) = self.spatial_natural(&name, length);
                (Representation::Natural, locals, frame)
            }
        };
        let end = self.graph.vector_scale(length, direction);
        let end = self.graph.vector_add(from, end);
        self.add_part(Part {
            name,
            kind: "Bar",
            span: entry.span(),
            representation,
            formulation,
            locals,
            mass,
            inertia,
            length: Some(length),
            center,
            frame,
            guess: Guess {
                origin: Some(StartPlace::Known(from)),
                end: Some(StartPlace::Known(end)),
                velocity,
                spin,
                ..Guess::default()
            },
            home: Some(home),
            shape,
            free,
        })
    }

    pub(in crate::model) fn spatial_body(&mut self, entry: &Entry) -> Option<Value> {
        let formulation = self.wish(entry, &formulation::OF_BODIES);
        let mut arguments = Arguments::new(self, entry);
        let mass = arguments.mass("mass");
        let center = arguments.vector("center_of_mass");
        let origin = arguments.home_place("at");
        let (velocity, spin) = (
            arguments.vector("velocity"),
            arguments.vector("angular_velocity"),
        );
        let free = arguments.flag("free");
        let axes = arguments.orientation("orientation")?;
        let mass = mass?;
        let (inertia, shape): (Tensor, Option<Shape>) = arguments.inertia("inertia", mass)?;
        let shape = arguments.drawn_shape()?.or(shape);
        let name = entry.name.to_string();
        let zero = self.graph.zero();
        let center = center.unwrap_or([zero; 3]);
        let (locals, frame) = self.rigid(&name, center);
        let origin = origin.unwrap_or([zero; 3]);
        self.add_part(Part {
            name,
            kind: "Body",
            span: entry.span(),
            representation: Representation::Rigid,
            formulation,
            locals,
            mass,
            inertia,
            length: None,
            center,
            frame,
            guess: Guess {
                origin: Some(StartPlace::Known(origin)),
                velocity,
                spin,
                ..Guess::default()
            },
            home: Some(Home { origin, axes }),
            shape,
            free,
        })
    }

    /// Natural coordinates: the end points. A slender bar has a direction, but no axes across it.
    fn spatial_natural(&mut self, name: &str, length: Expr) -> (Vec<u32>, Frame) {
        let (locals, difference) = self.end_points(name);
        let one = self.graph.one();
        let inverse = self.graph.div(one, length);
        let axis = self.graph.vector_scale(inverse, difference);
        // d × ḋ / L², which has no part along the bar.
        let spread = self.graph.vector_rate(difference);
        let cross = self.graph.cross(difference, spread);
        let spin = cross.map(|x| self.graph.product(&[(x, 1), (length, -2)]));
        let zero = self.graph.zero();
        let frame = Frame {
            origin: self.free_position(locals[0]),
            axes: [axis, [zero; 3], [zero; 3]],
            angle: None,
            spin,
        };
        (locals, frame)
    }

    /// The locals of the two end points, and b − a.
    pub(super) fn end_points(&mut self, name: &str) -> (Vec<u32>, Vector) {
        let mut locals = self.point_locals(&format!("{name}.a"));
        locals.extend(self.point_locals(&format!("{name}.b")));
        let (a, b) = (
            self.free_position(locals[0]),
            self.free_position(locals[locals.len() / 2]),
        );
        let difference = self.graph.vector_sub(b, a);
        for (axis, &x) in ["x", "y", "z"].iter().zip(&difference) {
            if !self.graph.is_zero(x) {
                self.graph.suggest_name(x, format!("{name}_d{axis}"));
            }
        }
        (locals, difference)
    }

    /// Centre of mass and rotation; the angular velocity, in body axes, is a quasi-velocity.
    fn rigid(&mut self, name: &str, center: Vector) -> (Vec<u32>, Frame) {
        let mut locals = self.point_locals(name);
        let turns = ["rotation.x", "rotation.y", "rotation.z"]
            .map(|axis| self.local(format!("{name}.{axis}"), "rad"));
        locals.extend(turns);
        let first = turns[0];
        let axes: Axes = std::array::from_fn(|column| {
            std::array::from_fn(|row| {
                let entry = (3 * row + column) as u8;
                let letter = ["x", "y", "z"];
                let symbol = Symbol::LocalRotation(first, entry);
                self.graph
                    .set_name(symbol, format!("{name}.{}.{}", letter[column], letter[row]));
                self.graph.symbol(symbol)
            })
        });
        let place = self.free_position(locals[0]);
        let offset = self.graph.turn(&axes, center);
        let origin = self.graph.vector_sub(place, offset);
        let omega = turns.map(|local| self.graph.symbol(Symbol::LocalVelocity(local)));
        let spin = self.graph.turn(&axes, omega);
        let frame = Frame {
            origin,
            axes,
            angle: None,
            spin,
        };
        (locals, frame)
    }

    /// Right-handed axes whose third is `direction`, a unit vector in parameters: for a direction of the ground's axes
    /// the others are such, too.
    pub(in crate::model) fn axes_along(&mut self, direction: Vector) -> Axes {
        let sizes = direction.map(|x| self.by_default(x).abs());
        // The axis after the largest component is far enough from it, and Z → (X, Y, Z), X → (Y, Z, X).
        let largest = (0..3).fold(0, |best, k| if sizes[k] > sizes[best] { k } else { best });
        let reference = self.graph.ground_axes()[(largest + 1) % 3];
        let across = self.graph.dot(reference, direction);
        let along = self.graph.vector_scale(across, direction);
        let x = self.graph.vector_sub(reference, along);
        let x = self.graph.unit(x);
        let y = self.graph.cross(direction, x);
        [x, y, direction]
    }
}
