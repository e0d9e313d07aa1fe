//! Bars, bodies and particles: which coordinates each takes on its own.
//!
//! | part | coordinates | mass matrix | rows |
//! |---|---|---|---|
//! | bar | its two end points (*natural*) | constant | its length |
//! | bar whose angle a joint or force uses | centre and angle (*reference*) | constant | none |
//! | body | centre of mass and angle (*reference*) | constant | none |
//! | particle | its point | constant | none |
//! | any, with `frame =` or `position =` | none: it follows `Coordinate`s (*prescribed*) | depends on q | none |

use super::geometry::{Frame, Owner, Vector};
use super::resolve::Resolver;
use super::value::Value;
use super::{Arguments, Dimension};
use crate::symbolic::{Expr, Symbol};
use crate::syntax::Entry;
use proc_macro2::Span;

/// How a part is modelled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Representation {
    /// Two end points as coordinates.
    Natural,
    /// Centre of mass and angle.
    Reference,
    /// A point.
    FreePoint,
    /// Follows `Coordinate`s.
    Prescribed,
    /// A declared coordinate; parts follow it.
    Coordinate,
}

impl Representation {
    /// In words.
    pub fn describe(self) -> &'static str {
        match self {
            Representation::Natural => "natural coordinates (its end points)",
            Representation::Reference => "reference coordinates (centre of mass and angle)",
            Representation::FreePoint => "its point",
            Representation::Prescribed => "follows declared coordinates",
            Representation::Coordinate => "a declared coordinate",
        }
    }
}

/// A bar, body or particle.
#[derive(Debug, Clone)]
pub struct Part {
    /// Its name.
    pub name: String,
    /// Its kind.
    pub kind: &'static str,
    /// Where it is declared.
    pub span: Span,
    /// How it is modelled.
    pub representation: Representation,
    /// Its coordinates.
    pub locals: Vec<u32>,
    /// Mass.
    pub mass: Expr,
    /// Moment of inertia about the centre of mass.
    pub inertia: Expr,
    /// Length of a bar.
    pub length: Option<Expr>,
    /// Centre of mass in the part's axes, from its origin.
    pub center: Vector,
    /// Its frame.
    pub frame: Frame,
    /// Declared guesses.
    pub guess: Guess,
    /// `free = true`.
    pub free: bool,
}

/// Declared guesses of a part's start; all in parameters.
#[derive(Debug, Clone, Default)]
pub struct Guess {
    /// Position of the origin.
    pub origin: Option<Vector>,
    /// Position of the far end of a bar.
    pub end: Option<Vector>,
    /// Velocity of the origin.
    pub velocity: Option<Vector>,
    /// Angle.
    pub angle: Option<Expr>,
    /// Angular velocity.
    pub rate: Option<Expr>,
}

impl Resolver<'_> {
    pub(super) fn coordinate(&mut self, entry: &Entry) -> Option<Value> {
        let mut arguments = Arguments::new(self, entry);
        let (value, dimension) = match arguments.has("value") {
            true => arguments.quantity("value")?,
            false => (arguments.graph().zero(), None),
        };
        let stated = arguments.unit()?;
        if let Some(stated) = stated {
            arguments.check_unit(dimension, stated)?;
        }
        let dimension = stated.or(dimension).unwrap_or(Dimension::NONE);
        let rate = match arguments.has("rate") {
            true => {
                let (rate, found) = arguments.quantity("rate")?;
                let expected = dimension.over(Dimension::TIME);
                if found.is_some_and(|found| found != expected) {
                    return arguments
                        .fail("rate", format!("the rate of this coordinate is {expected}"));
                }
                rate
            }
            false => arguments.graph().zero(),
        };
        let unit = if dimension == Dimension::NONE {
            "rad".to_owned()
        } else {
            dimension.unit()
        };
        let zero = self.graph.zero();
        let local = self.local(entry.name.to_string(), &unit);
        let position = self.graph.symbol(Symbol::LocalPosition(local));
        self.parts.push(Part {
            name: entry.name.to_string(),
            kind: "Coordinate",
            span: entry.span(),
            representation: Representation::Coordinate,
            locals: vec![local],
            mass: zero,
            inertia: zero,
            length: None,
            center: [zero; 2],
            frame: Frame {
                origin: [zero; 2],
                axis: [zero; 2],
                angle: None,
                rate: zero,
            },
            guess: Guess {
                angle: Some(value),
                rate: Some(rate),
                ..Guess::default()
            },
            free: false,
        });
        Some(Value::Scalar(position, Some(dimension)))
    }

    pub(super) fn bar(&mut self, entry: &Entry) -> Option<Value> {
        let needs_angle = self.turning.contains(&entry.name.to_string());
        let mut arguments = Arguments::new(self, entry);
        let mass = arguments.mass("mass");
        let guess = Guess {
            origin: arguments.vector("from"),
            end: arguments.vector("to"),
            velocity: None,
            angle: arguments.scalar("angle"),
            rate: arguments.scalar("rate"),
        };
        let free = arguments.flag("free");
        let length = match (arguments.has("length"), guess.origin, guess.end) {
            (true, ..) => arguments.scalar("length"),
            (false, Some(from), Some(to)) => {
                let difference = arguments.graph().vector_sub(to, from);
                Some(arguments.graph().norm(difference))
            }
            _ => arguments.fail(
                "length",
                format!(
                    "`{}` has no length; give `length =`, or its home pose by `from =` and `to =`",
                    entry.name
                ),
            ),
        }?;
        arguments.refuse_no_length(
            "length",
            length,
            "a bar has a positive length; for a point mass use `Particle`",
        )?;
        let prescribed = if arguments.has("frame") {
            Some(arguments.prescribed_frame("frame")?)
        } else {
            None
        };
        let mass = mass?;
        let name = entry.name.to_string();
        let squared = self.graph.square(length);
        let twelfth = self.graph.scale(1.0 / 12.0, mass);
        let inertia = self.graph.mul(twelfth, squared);
        let half = self.graph.scale(0.5, length);
        let zero = self.graph.zero();
        let center = [half, zero];
        let (representation, locals, frame) = match prescribed {
            Some((origin, angle)) => (
                Representation::Prescribed,
                Vec::new(),
                self.prescribed(&name, origin, angle),
            ),
            None if needs_angle => {
                let (locals, frame) = self.reference(&name, center);
                (Representation::Reference, locals, frame)
            }
            None => {
                let (locals, frame) = self.natural(&name, length);
                (Representation::Natural, locals, frame)
            }
        };
        self.add_part(Part {
            name,
            kind: "Bar",
            span: entry.span(),
            representation,
            locals,
            mass,
            inertia,
            length: Some(length),
            center,
            frame,
            guess,
            free,
        })
    }

    pub(super) fn body(&mut self, entry: &Entry) -> Option<Value> {
        let mut arguments = Arguments::new(self, entry);
        let (mass, inertia) = (arguments.mass("mass"), arguments.mass("inertia"));
        let center = arguments.vector("center_of_mass");
        let guess = Guess {
            origin: arguments.vector("at"),
            end: None,
            velocity: arguments.vector("velocity"),
            angle: arguments.scalar("angle"),
            rate: arguments.scalar("rate"),
        };
        let free = arguments.flag("free");
        let prescribed = if arguments.has("frame") {
            Some(arguments.prescribed_frame("frame")?)
        } else {
            None
        };
        let (mass, inertia) = (mass?, inertia?);
        let name = entry.name.to_string();
        let zero = self.graph.zero();
        let center = center.unwrap_or([zero; 2]);
        let (representation, locals, frame) = match prescribed {
            Some((origin, angle)) => (
                Representation::Prescribed,
                Vec::new(),
                self.prescribed(&name, origin, angle),
            ),
            None => {
                let (locals, frame) = self.reference(&name, center);
                (Representation::Reference, locals, frame)
            }
        };
        self.add_part(Part {
            name,
            kind: "Body",
            span: entry.span(),
            representation,
            locals,
            mass,
            inertia,
            length: None,
            center,
            frame,
            guess,
            free,
        })
    }

    pub(super) fn particle(&mut self, entry: &Entry) -> Option<Value> {
        let mut arguments = Arguments::new(self, entry);
        let mass = arguments.mass("mass");
        let guess = Guess {
            origin: arguments.vector("at"),
            velocity: arguments.vector("velocity"),
            ..Guess::default()
        };
        let free = arguments.flag("free");
        let prescribed = if arguments.has("position") {
            Some(arguments.prescribed_position("position")?)
        } else {
            None
        };
        let mass = mass?;
        let name = entry.name.to_string();
        let (zero, one) = (self.graph.zero(), self.graph.one());
        let (representation, locals, origin) = match prescribed {
            Some(position) => (Representation::Prescribed, Vec::new(), position),
            None => {
                let locals = ["x", "y"].map(|axis| self.local(format!("{name}.{axis}"), "m"));
                let origin = locals.map(|local| self.graph.symbol(Symbol::LocalPosition(local)));
                (Representation::FreePoint, locals.to_vec(), origin)
            }
        };
        self.add_part(Part {
            name,
            kind: "Particle",
            span: entry.span(),
            representation,
            locals,
            mass,
            inertia: zero,
            length: None,
            center: [zero; 2],
            frame: Frame {
                origin,
                axis: [one, zero],
                angle: Some(zero),
                rate: zero,
            },
            guess,
            free,
        })
    }

    fn add_part(&mut self, part: Part) -> Option<Value> {
        self.parts.push(part);
        Some(Value::Frame(Owner::Part(self.parts.len() - 1)))
    }

    /// Natural coordinates: the end points. The axis is (b − a)/L, and its rate (b − a) × (ḃ − ȧ)/L².
    fn natural(&mut self, name: &str, length: Expr) -> (Vec<u32>, Frame) {
        let locals =
            ["a.x", "a.y", "b.x", "b.y"].map(|axis| self.local(format!("{name}.{axis}"), "m"));
        let position = locals.map(|local| self.graph.symbol(Symbol::LocalPosition(local)));
        let velocity = locals.map(|local| self.graph.symbol(Symbol::LocalVelocity(local)));
        let difference = self
            .graph
            .vector_sub([position[2], position[3]], [position[0], position[1]]);
        self.graph.suggest_name(difference[0], format!("{name}_dx"));
        self.graph.suggest_name(difference[1], format!("{name}_dy"));
        let one = self.graph.one();
        let inverse = self.graph.div(one, length);
        let axis = self.graph.vector_scale(inverse, difference);
        let spread = self
            .graph
            .vector_sub([velocity[2], velocity[3]], [velocity[0], velocity[1]]);
        let cross = self.graph.cross(difference, spread);
        let rate = self.graph.product(&[(cross, 1), (length, -2)]);
        let origin = [position[0], position[1]];
        (
            locals.to_vec(),
            Frame {
                origin,
                axis,
                angle: None,
                rate,
            },
        )
    }

    /// Reference coordinates: centre of mass and angle.
    fn reference(&mut self, name: &str, center: Vector) -> (Vec<u32>, Frame) {
        let locals = [("x", "m"), ("y", "m"), ("angle", "rad")]
            .map(|(axis, unit)| self.local(format!("{name}.{axis}"), unit));
        let [x, y, angle] = locals.map(|local| self.graph.symbol(Symbol::LocalPosition(local)));
        let axis = self.named_direction(name, angle);
        let offset = self.graph.turn(axis, center);
        let origin = self.graph.vector_sub([x, y], offset);
        let rate = self.graph.symbol(Symbol::LocalVelocity(locals[2]));
        (
            locals.to_vec(),
            Frame {
                origin,
                axis,
                angle: Some(angle),
                rate,
            },
        )
    }

    fn prescribed(&mut self, name: &str, origin: Vector, angle: Expr) -> Frame {
        let axis = self.named_direction(name, angle);
        let rate = self.graph.rate(angle);
        Frame {
            origin,
            axis,
            angle: Some(angle),
            rate,
        }
    }

    fn named_direction(&mut self, name: &str, angle: Expr) -> Vector {
        let axis = self.graph.direction(angle);
        self.graph.suggest_name(axis[0], format!("cos_{name}"));
        self.graph.suggest_name(axis[1], format!("sin_{name}"));
        axis
    }
}
