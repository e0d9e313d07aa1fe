//! The output of a run: a table ([`csv`], [`npz`]), an animation ([`motion`]) and, with the feature `plot`, diagrams, all
//! from the same recorded [`Frame`]s; [`Record`] makes them. And the model in words.

mod columns;
pub mod csv;
mod explain;
mod frame_check;
mod json;
#[cfg(feature = "latex")]
mod latex;
mod members;
pub mod motion;
pub mod npz;
mod path_error;
#[cfg(feature = "plot")]
pub mod plot;
mod progress;
mod record;
mod save;
mod stream;
pub mod table;
mod thinned;

pub use explain::Explanation;
pub use progress::ProgressBar;
pub use record::{Interrupted, Progress, Record, Recording};
pub use save::Saved;
pub use stream::SaveError;

#[cfg(feature = "serde")]
use crate::read_numbers::{list, number, points};
use crate::{AnySimulation, Energy};

/// One recorded instant of a run.
///
/// With the feature `serde` it can be written and read. JSON has no number that is not finite: there NaN and ±∞ are `null`, which is read as
/// NaN. A table ([`csv`]) keeps them apart.
#[derive(Debug, Clone, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Frame {
    /// Time, s.
    pub time: f64,
    /// Generalized coordinates q, in the order and the units of [`Model::coordinates`](crate::Model::coordinates).
    #[cfg_attr(feature = "serde", serde(deserialize_with = "list"))]
    pub coordinates: Vec<f64>,
    /// Generalized velocities v, in those of [`Model::velocities`](crate::Model::velocities).
    #[cfg_attr(feature = "serde", serde(deserialize_with = "list"))]
    pub velocities: Vec<f64>,
    /// Values of the `Output`s and `State`s, in those of [`Model::outputs`](crate::Model::outputs).
    #[cfg_attr(feature = "serde", serde(deserialize_with = "list"))]
    pub outputs: Vec<f64>,
    /// Named points in world axes, m.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "points"))]
    pub points: Vec<[f64; 3]>,
    /// Joint reactions in the order of [`Model::reactions`](crate::Model::reactions); NaN where they are not known.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "list"))]
    pub reactions: Vec<f64>,
    /// The energy balance.
    pub energy: Energy,
    /// max |φ| over the rows as declared.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "number"))]
    pub holonomic_error: f64,
    /// max |A v + b|.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "number"))]
    pub velocity_error: f64,
}

impl Frame {
    /// Records where the simulation is now.
    pub fn record(simulation: &dyn AnySimulation) -> Self {
        let sample = simulation.sample();
        let reactions = simulation.reactions().map(|reactions| reactions.values);
        Frame {
            time: sample.time,
            coordinates: simulation.coordinates(),
            velocities: simulation.velocities(),
            outputs: sample.outputs,
            points: simulation.points(),
            reactions: reactions
                .unwrap_or_else(|_| vec![f64::NAN; simulation.model().reactions.len()]),
            energy: sample.energy,
            holonomic_error: sample.holonomic_error,
            velocity_error: sample.velocity_error,
        }
    }
}
