//! Particles, and coordinates declared by hand.

use super::part::{Guess, Home, Part, Representation, StartPlace};
use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::geometry::{Frame, Vector};
use crate::model::resolver::Resolver;
use crate::model::value::Value;
use crate::schema::World;
use crate::symbolic::Symbol;
use crate::syntax::Entry;

impl Resolver<'_> {
    pub(in crate::model) fn coordinate(&mut self, entry: &Entry) -> Option<Value> {
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
            formulation: None,
            locals: vec![local],
            mass: zero,
            inertia: [[zero; 3]; 3],
            length: None,
            center: [zero; 3],
            frame: Frame {
                origin: [zero; 3],
                axes: [[zero; 3]; 3],
                angle: None,
                spin: [zero; 3],
            },
            guess: Guess {
                angle: Some(value),
                rate: Some(rate),
                ..Guess::default()
            },
            home: None,
            shape: None,
            free: false,
        });
        Some(Value::Scalar(position, Some(dimension)))
    }

    pub(in crate::model) fn particle(&mut self, entry: &Entry) -> Option<Value> {
        let mut arguments = Arguments::new(self, entry);
        let mass = arguments.mass("mass");
        let guess = Guess {
            origin: arguments.start_place("at"),
            velocity: arguments.vector("velocity"),
            ..Guess::default()
        };
        let free = arguments.flag("free");
        let prescribed = if arguments.has("position") {
            arguments.refuse_start("position")?;
            Some(arguments.prescribed_position("position")?)
        } else {
            None
        };
        let mass = mass?;
        let name = entry.name.to_string();
        let zero = self.graph.zero();
        let axes = self.graph.ground_axes();
        let home = guess.origin.as_ref().map(StartPlace::position);
        let home = match prescribed {
            _ if self.world == World::Planar => None,
            Some(position) => Some(self.in_home_pose_of(position)),
            None => Some(home.unwrap_or([zero; 3])),
        };
        let (representation, locals, origin) = match prescribed {
            Some(position) => (Representation::Prescribed, Vec::new(), position),
            None => {
                let locals = self.point_locals(&name);
                let origin = self.free_position(locals[0]);
                (Representation::FreePoint, locals, origin)
            }
        };
        self.add_part(Part {
            name,
            kind: "Particle",
            span: entry.span(),
            representation,
            formulation: None,
            locals,
            mass,
            inertia: [[zero; 3]; 3],
            length: None,
            center: [zero; 3],
            frame: Frame {
                origin,
                axes,
                angle: Some(zero),
                spin: [zero; 3],
            },
            home: home.map(|origin| Home { origin, axes }),
            guess,
            shape: None,
            free,
        })
    }

    /// New locals for the components of a point.
    pub(super) fn point_locals(&mut self, name: &str) -> Vec<u32> {
        ["x", "y", "z"][..self.world.dimension()]
            .iter()
            .map(|axis| self.local(format!("{name}.{axis}"), "m"))
            .collect()
    }

    /// The position of the point whose components are locals, from `first` on.
    pub(in crate::model) fn free_position(&mut self, first: u32) -> Vector {
        let mut position = self.graph.zero_vector();
        for (local, x) in (first..).zip(&mut position[..self.world.dimension()]) {
            *x = self.graph.symbol(Symbol::LocalPosition(local));
        }
        position
    }
}
