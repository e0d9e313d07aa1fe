//! Initial values that are held: `Exactly(…)`.

use super::arguments::Arguments;
use super::geometry::Vector;
use super::layout::rate_unit;
use super::parts::{Part, StartPlace};
use super::resolver::Resolver;
use crate::schema::Initial;
use crate::symbolic::{Expr, Symbol};
use crate::syntax::exactly;

/// One number of a start that assembly holds.
#[derive(Debug, Clone)]
pub struct Held {
    /// For example `crank.angle` or `bob.origin.x`.
    pub name: String,
    /// The part or coordinate.
    pub entry: String,
    /// Its SI unit.
    pub unit: String,
    /// Whether it is a velocity.
    pub is_velocity: bool,
    /// The number less its declared value.
    pub gap: Expr,
    /// Of a position its rate; a velocity itself.
    pub rate: Expr,
}

/// The same in local coordinates.
struct Number {
    /// The end of its name.
    suffix: String,
    unit: String,
    gap: Expr,
    rate: Expr,
}

impl Number {
    fn new(suffix: &str, unit: &str, gap: Expr, rate: Expr) -> Number {
        Number {
            suffix: suffix.to_owned(),
            unit: unit.to_owned(),
            gap,
            rate,
        }
    }
}

impl Resolver<'_> {
    /// The initial values that are held, in local coordinates.
    pub(super) fn held(&mut self) -> Vec<Held> {
        let mut held = Vec::new();
        for entry in &self.declaration.entries {
            let named = entry.named.iter().map(|argument| &argument.value);
            if !entry
                .positional
                .iter()
                .chain(named)
                .any(|value| exactly(value).is_some())
            {
                continue;
            }
            let name = entry.name.to_string();
            let Some(part) = self.parts.iter().find(|part| part.name == name).cloned() else {
                continue;
            };
            let Some(kind) = self.kinds.kind(self.world, &entry.kind.to_string()) else {
                continue;
            };
            for field in kind.fields {
                let Some(initial) = field.initial else {
                    continue;
                };
                if !Arguments::new(self, entry).is_held(field.name) {
                    continue;
                }
                held.extend(
                    self.held_numbers(&part, initial)
                        .into_iter()
                        .map(|number| Held {
                            name: format!("{name}{}", number.suffix),
                            entry: name.clone(),
                            unit: number.unit,
                            is_velocity: is_velocity(initial),
                            gap: number.gap,
                            rate: number.rate,
                        }),
                );
            }
        }
        held
    }

    /// The numbers of an initial value.
    fn held_numbers(&mut self, part: &Part, initial: Initial) -> Vec<Number> {
        let (frame, guess) = (&part.frame, &part.guess);
        match initial {
            Initial::Origin => {
                let name = match part.kind {
                    "Bar" => ".a",
                    _ => ".origin",
                };
                self.held_place(name, frame.origin, guess.origin.as_ref())
            }
            Initial::End => {
                let Some(length) = part.length else {
                    return Vec::new();
                };
                let arm = self.graph.vector_scale(length, frame.axes[0]);
                let end = self.graph.vector_add(frame.origin, arm);
                self.held_place(".b", end, guess.end.as_ref())
            }
            Initial::Velocity => {
                let velocity = self.graph.vector_rate(frame.origin);
                self.held_components((".velocity", "m/s"), velocity, guess.velocity, velocity)
            }
            Initial::Spin => {
                let name = (".angular_velocity", "rad/s");
                self.held_components(name, frame.spin, guess.spin, frame.spin)
            }
            Initial::Rate => {
                let rate = frame.spin[2];
                self.held_number((".rate", "rad/s"), rate, guess.rate, rate)
            }
            Initial::Angle => match (frame.angle, guess.angle) {
                (None, Some(wanted)) => {
                    let gap = self.angle_from(wanted, frame.axes[0]);
                    vec![Number::new(".angle", "rad", gap, frame.spin[2])]
                }
                (Some(angle), wanted) => {
                    self.held_number((".angle", "rad"), angle, wanted, frame.spin[2])
                }
                (None, None) => Vec::new(),
            },
            Initial::Coordinate | Initial::CoordinateRate => {
                let Some(&local) = part.locals.first() else {
                    return Vec::new();
                };
                let unit = self.locals[local as usize].unit.clone();
                let value = self.graph.symbol(Symbol::LocalPosition(local));
                let rate = self.graph.symbol(Symbol::LocalVelocity(local));
                match initial {
                    Initial::Coordinate => self.held_number(("", &unit), value, guess.angle, rate),
                    _ => self.held_number((".rate", &rate_unit(&unit)), rate, guess.rate, rate),
                }
            }
        }
    }

    fn held_number(
        &mut self,
        (suffix, unit): (&str, &str),
        found: Expr,
        wanted: Option<Expr>,
        rate: Expr,
    ) -> Vec<Number> {
        let gap = wanted.map(|wanted| self.graph.sub(found, wanted));
        let number = gap.map(|gap| Number::new(suffix, unit, gap, rate));
        number.into_iter().collect()
    }

    fn held_place(
        &mut self,
        suffix: &str,
        found: Vector,
        wanted: Option<&StartPlace>,
    ) -> Vec<Number> {
        let wanted = wanted.map(StartPlace::position);
        let gap = wanted.map_or(found, |wanted| self.graph.vector_sub(found, wanted));
        let rates = self.graph.vector_rate(gap);
        self.held_components((suffix, "m"), found, wanted, rates)
    }

    fn held_components(
        &mut self,
        (suffix, unit): (&str, &str),
        found: Vector,
        wanted: Option<Vector>,
        rates: Vector,
    ) -> Vec<Number> {
        let letters = ["x", "y", "z"].iter().take(self.world.dimension());
        let numbers = letters.zip(0..).flat_map(|(letter, k)| {
            let suffix = format!("{suffix}.{letter}");
            self.held_number((&suffix, unit), found[k], wanted.map(|v| v[k]), rates[k])
        });
        numbers.collect()
    }

    /// The angle of a direction of the plane from the direction of this angle, below a half turn.
    fn angle_from(&mut self, angle: Expr, direction: Vector) -> Expr {
        let wanted = self.graph.direction(angle);
        let across = self.graph.planar_cross(wanted, direction);
        let along = self.graph.dot(wanted, direction);
        self.graph.atan2(across, along)
    }
}

fn is_velocity(initial: Initial) -> bool {
    matches!(
        initial,
        Initial::Velocity | Initial::Rate | Initial::Spin | Initial::CoordinateRate
    )
}
