//! Results of which the length depends on the mechanism.

use super::Energy;
#[cfg(feature = "serde")]
use crate::read_numbers::{list, number};

/// A row of results.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Sample {
    /// Time, s.
    pub time: f64,
    /// In the order of [`Model::outputs`](crate::Model::outputs).
    #[cfg_attr(feature = "serde", serde(deserialize_with = "list"))]
    pub outputs: Vec<f64>,
    /// The energy balance.
    pub energy: Energy,
    /// max |φ| over the holonomic rows, each in its own unit.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "number"))]
    pub holonomic_error: f64,
    /// max |A v + b| over all rows, each in its own unit.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "number"))]
    pub velocity_error: f64,
}

/// Joint reactions and multipliers at an instant.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Reactions {
    /// False if rows are redundant, or nearly so: the values are then those of least norm, for the rows of this
    /// description. ([`Model::is_determined`](crate::Model::is_determined) says for which joints.)
    pub unique: bool,
    /// In the order of [`Model::reactions`](crate::Model::reactions).
    #[cfg_attr(feature = "serde", serde(deserialize_with = "list"))]
    pub values: Vec<f64>,
    /// λ in the order of [`Model::rows`](crate::Model::rows).
    #[cfg_attr(feature = "serde", serde(deserialize_with = "list"))]
    pub multipliers: Vec<f64>,
}

/// What assembly found.
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct AssemblyVerdict {
    /// max |φ| of the declared guess, each row in its own unit.
    pub residual_before: f64,
    /// max |φ| after assembly, each row in its own unit.
    pub residual: f64,
    /// The change Δ of q, weighted with the masses: √(ΔᵀMΔ / tr M), in m or rad, whichever the coordinates have.
    pub moved: f64,
    /// Numerical rank of A in the assembled pose.
    pub rank: usize,
    /// Rows that depend on those above them in that pose.
    pub redundant_rows: Vec<&'static str>,
    /// The holonomic rows that are farthest from satisfied after assembly, worst first.
    pub worst_rows: Vec<OpenRow>,
    /// The coordinates that assembly has moved, the farthest first, and then the velocities that it has changed.
    pub changes: Vec<Change>,
}

/// A holonomic row that assembly could not close.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct OpenRow {
    /// As [`Model::rows`](crate::Model::rows) names it.
    pub name: &'static str,
    /// SI unit.
    pub unit: &'static str,
    /// φ.
    pub residual: f64,
}

/// A coordinate or velocity whose initial value is not the declared one.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Change {
    /// As [`Model::coordinates`](crate::Model::coordinates) or [`Model::velocities`](crate::Model::velocities) names it.
    pub name: &'static str,
    /// SI unit.
    pub unit: &'static str,
    /// Its declared value, or what the declared values imply.
    pub declared: f64,
    /// Its value at the start.
    pub started: f64,
}

/// An initial value that could not be held.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct HeldGap {
    /// For example `crank.angle`.
    pub name: String,
    /// SI unit.
    pub unit: String,
    /// By how much it would be off, where all are off as little as possible.
    pub gap: f64,
    /// Whether it does not change near the guess, whatever moves.
    #[cfg_attr(feature = "serde", serde(default))]
    pub is_constant: bool,
}
