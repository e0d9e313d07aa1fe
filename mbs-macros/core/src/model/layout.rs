//! The generalized coordinates as they are stored, and the velocities: a rotation has four coordinates and three
//! velocities.

use super::geometry::Tensor;
use super::initial_pose::Guesses;
use super::reduction::Reduction;
use super::resolver::Resolver;
use crate::symbolic::{Expr, Graph, Map, Symbol, rotation_entry};

/// Coordinates q and velocities v, with their guesses.
#[derive(Debug, Default, Clone)]
pub struct Layout {
    /// q, in order.
    pub coordinates: Vec<Stored>,
    /// v, in order.
    pub velocities: Vec<Stored>,
    /// The velocities that are states, in the order of their declarations.
    pub states: Vec<usize>,
    /// For each velocity the coordinate that it is the rate of; for one of a rotation, the first of its quaternion.
    pub slots: Vec<usize>,
    /// Rotations, in order.
    pub rotations: Vec<Rotation>,
    /// Counted angles: for each its coordinate and the angle, in local coordinates, that it remembers.
    pub unwrapped_angles: Vec<(usize, Expr)>,
}

/// A coordinate or velocity.
#[derive(Debug, Clone)]
pub struct Stored {
    /// For example `crank.b.x`.
    pub name: String,
    /// SI unit.
    pub unit: String,
    /// Initial guess, in parameters.
    pub guess: Expr,
}

/// A unit quaternion among the coordinates.
#[derive(Debug, Clone)]
pub struct Rotation {
    /// The part that it turns.
    pub part: String,
    /// Index of its first velocity; its entries are [`Symbol::Rotation`] by this.
    pub velocity: usize,
    /// Index of the first component of its quaternion.
    pub coordinate: usize,
    /// The inertia of the part, in its axes.
    pub inertia: Tensor,
}

impl Layout {
    /// Where in q a coordinate is stored, or the first component of a rotation's quaternion.
    pub fn slot(&self, symbol: Symbol) -> Option<usize> {
        match symbol {
            Symbol::Coordinate(velocity) | Symbol::Rotation(velocity, _) => {
                self.slots.get(velocity as usize).copied()
            }
            Symbol::UnwrappedAngle(index) => self
                .unwrapped_angles
                .get(index as usize)
                .map(|(slot, _)| *slot),
            _ => None,
        }
    }

    /// q moved by v over h; rotations by (1, h ω/2), normalised.
    pub fn moved(&self, q: &[f64], v: &[f64], h: f64) -> Vec<f64> {
        let mut next = q.to_vec();
        for (i, &slot) in self.slots.iter().enumerate() {
            if !self
                .rotations
                .iter()
                .any(|rotation| rotation.coordinate == slot)
            {
                next[slot] += h * v[i];
            }
        }
        for rotation in &self.rotations {
            let (slot, first) = (rotation.coordinate, rotation.velocity);
            let [w, x, y, z] = [0, 1, 2, 3].map(|k| q[slot + k]);
            let [a, b, c] = [0, 1, 2].map(|k| 0.5 * h * v[first + k]);
            let turned = [
                w - x * a - y * b - z * c,
                x + w * a + y * c - z * b,
                y + w * b + z * a - x * c,
                z + w * c + x * b - y * a,
            ];
            let length = turned.iter().map(|x| x * x).sum::<f64>().sqrt();
            for (k, x) in turned.into_iter().enumerate() {
                next[slot + k] = x / length;
            }
        }
        next
    }

    /// The value of a generalized position or orientation at q; `None` for other symbols.
    pub fn value(&self, symbol: Symbol, q: &[f64]) -> Option<f64> {
        let slot = self.slot(symbol)?;
        match symbol {
            Symbol::Rotation(_, entry) => {
                let quaternion = q.get(slot..slot + 4)?.try_into().ok()?;
                Some(rotation_entry(quaternion, entry))
            }
            _ => q.get(slot).copied(),
        }
    }
}

/// Lays out what the reduction has kept.
pub(super) fn layout(resolver: &mut Resolver, reduction: &Reduction, guesses: &Guesses) -> Layout {
    let mut layout = Layout {
        states: vec![0; resolver.scalar_states.len()],
        ..Layout::default()
    };
    let parts = resolver.parts.iter().enumerate();
    let turning = parts.filter_map(|(index, part)| Some((part.rotation()?, index)));
    let turning: Map<u32, usize> = turning.collect();
    let mut kept = reduction.kept().iter();
    while let Some((local, name)) = kept.next() {
        let slot = layout.coordinates.len();
        if let Some(&part) = turning.get(local) {
            let part = &resolver.parts[part];
            let (name, inertia) = (part.name.clone(), part.inertia);
            let first = layout.velocities.len();
            layout.rotations.push(Rotation {
                part: name.clone(),
                velocity: first,
                coordinate: slot,
                inertia,
            });
            let quaternion = guesses.quaternion(*local, &mut resolver.graph);
            for (component, guess) in ["w", "x", "y", "z"].iter().zip(quaternion) {
                layout.coordinates.push(Stored {
                    name: format!("{name}.q{component}"),
                    unit: String::new(),
                    guess,
                });
            }
            for (turn, axis) in (*local..).zip(["x", "y", "z"]) {
                layout.velocities.push(Stored {
                    name: format!("{name}.omega.{axis}"),
                    unit: "rad/s".to_owned(),
                    guess: guesses.velocity(turn, &mut resolver.graph),
                });
                layout.slots.push(slot);
            }
            kept.nth(1);
            continue;
        }
        let unit = resolver.locals[*local as usize].unit.clone();
        let mut states = resolver.scalar_states.iter();
        let (rate, unit_of_rate) = match states.position(|state| state.local == *local) {
            Some(place) => {
                let index = layout.velocities.len();
                layout.states[place] = index;
                let own = resolver.scalar_states[place].quantity.clone();
                name_state(&mut resolver.graph, index as u32, &own.name);
                (own.name, own.unit)
            }
            None => (format!("{name}'"), rate_unit(&unit)),
        };
        layout.velocities.push(Stored {
            name: rate,
            unit: unit_of_rate,
            guess: guesses.velocity(*local, &mut resolver.graph),
        });
        layout.coordinates.push(Stored {
            name: name.clone(),
            unit,
            guess: guesses.position(*local, &mut resolver.graph),
        });
        layout.slots.push(slot);
    }
    for &index in &reduction.unwrapped_angles {
        let unwrapped = &resolver.unwrapped_angles[index];
        let guess = match unwrapped.bar {
            Some(bar) => guesses.angle(bar, &mut resolver.graph),
            None => resolver.graph.zero(),
        };
        layout
            .unwrapped_angles
            .push((layout.coordinates.len(), unwrapped.angle));
        layout.coordinates.push(Stored {
            name: format!("{}.angle", unwrapped.of),
            unit: "rad".to_owned(),
            guess,
        });
    }
    for (slot, stored) in layout.coordinates.iter().enumerate() {
        let symbol = Symbol::Stored(slot as u32);
        resolver.graph.set_name(symbol, stored.name.clone());
    }
    layout
}

/// A velocity that is a state has the name of the state.
fn name_state(graph: &mut Graph, index: u32, name: &str) {
    graph.set_name(Symbol::Velocity(index), name);
    graph.set_name(Symbol::Acceleration(index), format!("{name}'"));
}

/// The unit of a rate.
pub(super) fn rate_unit(unit: &str) -> String {
    match unit {
        "" => "1/s".to_owned(),
        unit if unit.contains('/') => format!("({unit})/s"),
        unit => format!("{unit}/s"),
    }
}
