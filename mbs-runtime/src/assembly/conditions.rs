//! Values that the start has to have.

use super::differences::derivative;
use crate::linear::{vector, zeros};
use crate::yardstick::Yardstick;
use crate::{Level, SimulationError, System, UnknownName};
use core::f64::consts::TAU;
use nalgebra::SVector;

/// A value that the program asks for.
#[derive(Debug, Clone)]
pub(crate) struct Wanted {
    /// The name of a coordinate, velocity or output.
    pub(crate) name: String,
    pub(crate) value: f64,
    /// Whether the value is that of the rate.
    pub(crate) rate: bool,
}

/// A value that the start has to have.
pub(super) struct Condition {
    pub(super) name: String,
    pub(super) unit: String,
    pub(super) level: Level,
    quantity: Quantity,
    wanted: f64,
}

/// What has this value.
#[derive(Clone, Copy)]
enum Quantity {
    /// One of [`Observables::HELD`](crate::Observables::HELD).
    Declared(usize),
    Coordinate(usize),
    /// The rate of a coordinate that no velocity is the rate of.
    CoordinateRate(usize),
    Velocity(usize),
    Output(usize),
    OutputRate(usize),
}

/// What the declaration and the program ask for.
///
/// # Errors
/// A name that the mechanism does not have, or a value that is not finite.
pub(super) fn conditions<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    wanted: &[Wanted],
    q: &SVector<f64, Q>,
) -> Result<Vec<Condition>, SimulationError> {
    let declared = S::HELD.iter().enumerate().map(|(i, held)| Condition {
        name: held.name.to_owned(),
        unit: held.unit.to_owned(),
        level: held.level,
        quantity: Quantity::Declared(i),
        wanted: 0.0,
    });
    let mut conditions: Vec<Condition> = declared.collect();
    for wanted in wanted {
        if !wanted.value.is_finite() {
            return Err(SimulationError::Guess {
                what: "a held value",
                value: wanted.value,
            });
        }
        conditions.push(find(system, wanted, q)?);
    }
    Ok(conditions)
}

/// The quantity that a program names.
fn find<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    wanted: &Wanted,
    q: &SVector<f64, Q>,
) -> Result<Condition, UnknownName> {
    let (name, model) = (wanted.name.as_str(), S::MODEL);
    let condition = |quantity: Quantity, level: Level, unit: &str| Condition {
        name: match wanted.rate {
            true => format!("rate of {name}"),
            false => name.to_owned(),
        },
        unit: match (quantity, unit) {
            (Quantity::OutputRate(_) | Quantity::CoordinateRate(_), "") => "1/s".to_owned(),
            (Quantity::OutputRate(_) | Quantity::CoordinateRate(_), unit) => format!("{unit}/s"),
            _ => unit.to_owned(),
        },
        level,
        quantity,
        wanted: wanted.value,
    };
    let rate = format!("{name}'");
    // A start gives a state its value; its rate follows.
    let is_free = |own: &str| !(wanted.rate && model.is_state(own) || model.is_integral(own));
    let velocity = |name: &str| {
        let mut velocities = model.velocities.iter();
        velocities.position(|own| own.name == name && is_free(name))
    };
    let velocity = match wanted.rate {
        true => velocity(&rate).or_else(|| velocity(name)),
        false => velocity(name),
    };
    if let Some(i) = velocity {
        let unit = model.velocities[i].unit;
        return Ok(condition(Quantity::Velocity(i), Level::Velocity, unit));
    }
    let mut coordinates = model.coordinates.iter();
    let coordinate = coordinates.position(|own| own.name == name && is_free(name));
    if let Some(i) = coordinate {
        let unit = model.coordinates[i].unit;
        return Ok(match wanted.rate {
            true => condition(Quantity::CoordinateRate(i), Level::Velocity, unit),
            false => condition(Quantity::Coordinate(i), Level::Position, unit),
        });
    }
    let startable = |&i: &usize| !output(system, i, q, &zeros()).is_nan();
    let declared = model.outputs.iter().position(|own| own.name == name);
    let output = declared.filter(startable);
    let moving = |i: &usize| depends_on_velocities(system, *i, q);
    // The rate of such an output is not that of the motion alone.
    let timed = |i: &usize| depends_on_time(system, *i, q);
    let output = output.filter(|i| !(wanted.rate && timed(i)));
    match output.map(|i| (i, moving(&i))) {
        Some((i, false)) if wanted.rate => {
            let unit = model.outputs[i].unit;
            Ok(condition(Quantity::OutputRate(i), Level::Velocity, unit))
        }
        Some((i, moving)) if !wanted.rate => {
            let level = match moving {
                true => Level::Velocity,
                false => Level::Position,
            };
            let unit = model.outputs[i].unit;
            Ok(condition(Quantity::Output(i), level, unit))
        }
        _ => {
            let what = match (wanted.rate, declared) {
                (true, _) => "coordinate, velocity or output of positions alone",
                (false, Some(_)) => "coordinate, velocity or output without accelerations",
                (false, None) => "coordinate, velocity or output",
            };
            let outputs = model.outputs.iter().enumerate();
            // A state is among the velocities.
            let outputs = outputs.filter(|(i, own)| {
                let has_rate = || !moving(i) && !timed(i);
                startable(i) && (!wanted.rate || has_rate()) && !model.is_state(own.name)
            });
            let stored = model.coordinates.iter().chain(model.velocities);
            let known = stored.map(|own| own.name).filter(|own| is_free(own));
            let known = known.chain(outputs.map(|(_, own)| own.name));
            Err(UnknownName::new(what, name, known.collect::<Vec<_>>()))
        }
    }
}

/// Whether an output changes with the velocities, at a few poses around q.
fn depends_on_velocities<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    index: usize,
    q: &SVector<f64, Q>,
) -> bool {
    around(system, q).any(|q| {
        let v: SVector<f64, N> = vector(|i| (2.0 + i as f64).cos());
        let still = output(system, index, &q, &zeros());
        let moving = output(system, index, &q, &v);
        still.to_bits() != moving.to_bits() && still != moving
    })
}

/// Whether an output changes with the time where nothing moves, at a few poses around q.
fn depends_on_time<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    index: usize,
    q: &SVector<f64, Q>,
) -> bool {
    around(system, q).any(|q| {
        let at = |t: f64| output_at(system, index, (t, &q, &zeros()));
        [1e-3, 0.7, 31.0].into_iter().any(|t| at(t) != at(0.0))
    })
}

/// A few poses around q.
fn around<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    q: &SVector<f64, Q>,
) -> impl Iterator<Item = SVector<f64, Q>> {
    (0..3).map(move |pose| {
        let way: SVector<f64, N> = vector(|i| f64::from(pose) * (1.0 + i as f64).sin());
        system.advance(q, &way, 0.01)
    })
}

/// NaN if it reads accelerations.
fn output<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    index: usize,
    q: &SVector<f64, Q>,
    v: &SVector<f64, N>,
) -> f64 {
    output_at(system, index, (0.0, q, v))
}

fn output_at<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    index: usize,
    (t, q, v): (f64, &SVector<f64, Q>, &SVector<f64, N>),
) -> f64 {
    let mut outputs = vec![f64::NAN; S::MODEL.outputs.len()];
    system.outputs(t, q, v, &mut outputs);
    outputs.get(index).copied().unwrap_or(f64::NAN)
}

impl Condition {
    /// By how much the quantity exceeds its wanted value.
    pub(super) fn gap<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
        &self,
        system: &S,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        yardstick: &Yardstick<Q, N>,
    ) -> f64 {
        let found = match self.quantity {
            Quantity::Declared(i) => return declared(system, q, v)[2 * i],
            Quantity::Coordinate(slot) => q[slot],
            Quantity::Velocity(i) => v[i],
            Quantity::Output(i) => output(system, i, q, v),
            Quantity::CoordinateRate(_) | Quantity::OutputRate(_) => {
                crate::linear::dot(&self.gradient(system, q, v, yardstick), v)
            }
        };
        found - self.wanted
    }

    /// Its derivatives: of a position along the velocities, of a velocity with respect to them.
    pub(super) fn gradient<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
        &self,
        system: &S,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        yardstick: &Yardstick<Q, N>,
    ) -> SVector<f64, N> {
        let unit = |j: usize| vector::<N>(|i| if i == j { 1.0 } else { 0.0 });
        // Along velocity j, by s lengths of the mechanism or radians.
        let along = |value: &dyn Fn(&SVector<f64, Q>) -> f64| {
            vector::<N>(|j| {
                let way = yardstick.displacement(unit(j));
                let moved = |s: f64| value(&system.advance(q, &way, s));
                derivative(&moved) / way[j]
            })
        };
        match self.quantity {
            Quantity::Declared(i) => vector(|j| declared(system, q, &unit(j))[2 * i + 1]),
            Quantity::Velocity(i) => unit(i),
            Quantity::Coordinate(slot) | Quantity::CoordinateRate(slot) => {
                let name = S::MODEL.coordinates[slot].name;
                let mut velocities = S::MODEL.velocities.iter();
                let own = velocities.position(|own| own.name.strip_suffix('\'') == Some(name));
                match own {
                    Some(i) => unit(i),
                    None => along(&|q| q[slot]),
                }
            }
            Quantity::Output(i) if self.level == Level::Velocity => vector(|j| {
                let way = yardstick.displacement(unit(j));
                let moved = |s: f64| output(system, i, q, &(v + way * s));
                derivative(&moved) / way[j]
            }),
            Quantity::Output(i) | Quantity::OutputRate(i) => {
                // An angle that does not count turns may jump by one on the way.
                let here = output(system, i, q, v);
                let turns = matches!(S::MODEL.outputs[i].unit, "" | "rad");
                along(&|q| {
                    let change = output(system, i, q, v) - here;
                    match turns {
                        true => change - TAU * (change / TAU).round(),
                        false => change,
                    }
                })
            }
        }
    }
}

fn declared<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    q: &SVector<f64, Q>,
    v: &SVector<f64, N>,
) -> Vec<f64> {
    let mut held = vec![0.0; 2 * S::HELD.len()];
    system.held(q, v, &mut held);
    held
}
