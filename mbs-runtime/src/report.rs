//! Results and diagnostics of a simulation.

#[cfg(feature = "std")]
mod lists;

use crate::Method;
#[cfg(feature = "serde")]
use crate::read_numbers::number;

#[cfg(feature = "std")]
pub use lists::{AssemblyVerdict, Change, HeldGap, OpenRow, Reactions, Sample};

/// The energy balance, J.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Energy {
    /// T.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "number"))]
    pub kinetic: f64,
    /// V of gravity and springs.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "number"))]
    pub potential: f64,
    /// Work done since the start by applied forces that have no potential.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "number"))]
    pub nonconservative_work: f64,
    /// Work done since the start by rheonomic rows.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "number"))]
    pub drive_work: f64,
    /// T + V − work − (T + V at the start).
    #[cfg_attr(feature = "serde", serde(deserialize_with = "number"))]
    pub error: f64,
}

/// Work done and errors met since the start.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Report {
    /// Steps accepted.
    pub steps: u64,
    /// Integrator stages, including those of rejected steps.
    pub stages: u64,
    /// Corrections of Newton's method, of multipliers or of projections, whichever the method has.
    pub iterations: u64,
    /// Steps that were repeated with a shorter step.
    pub rejected_steps: u64,
    /// Steps whose length was changed so that no stage ends beside a singular pose.
    pub placed_steps: u64,
    /// Solves in which rows were redundant, or nearly so.
    pub regularised_solves: u64,
    /// max |energy error| over all steps, J.
    pub energy_error: f64,
    /// max |φ| over all steps.
    pub holonomic_error: f64,
    /// max |A v + b| over all steps.
    pub velocity_error: f64,
    /// Numerical rank of A at the start, or where parameters were changed last.
    pub rank: usize,
    /// Singular poses passed; [`Simulation::rank_losses`](crate::Simulation::rank_losses) has the last 64.
    pub rank_losses: usize,
    /// Changes of the method for an accuracy; each is in [`Simulation::method_changes`](crate::Simulation::method_changes).
    pub method_changes: usize,
}

/// A change of the method, for an [accuracy](crate::Settings::accuracy): the motion needs much shorter or longer steps than
/// before, and the other method has less work with them.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct MethodChange {
    /// When, s.
    pub time: f64,
    /// The method until then, …
    pub before: Method,
    /// … the method from then on, …
    pub method: Method,
    /// … and its order.
    pub order: u8,
    /// Operations for a second of the motion from there on, of the method before, at least, and of this one; infinite for a
    /// method that could not go on.
    pub operations: [f64; 2],
}

/// A singular pose during the motion: rows that are generally independent were dependent there, or nearly so.
///
/// A run that begins in such a pose has a loss at the time of its start, once the motion has left the pose. If it begins from
/// rest, the equations do not determine on which branch: the motion is one of several.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct RankLoss {
    /// When, s; from the steps around it, to about a hundredth of their length (and not better than the motion itself).
    pub time: f64,
    /// The smallest singular value of the rows there, each of unit length in the metric of M; estimated like the time.
    pub sigma_min: f64,
    /// Whether the run began there, at rest: several motions that satisfy the equations may leave the pose, and round-off
    /// decides which one is followed. A small rate in the declaration decides it.
    pub undetermined: bool,
    /// The entries whose rows depend on each other there, most involved first.
    joints: [&'static str; RankLoss::MOST_JOINTS],
    count: usize,
}

impl RankLoss {
    /// Joints beyond these are left out.
    const MOST_JOINTS: usize = 8;

    /// With the entries in the order of their weights; the same entry may come more than once.
    pub(crate) fn new(
        time: f64,
        sigma_min: f64,
        undetermined: bool,
        entries: impl Iterator<Item = &'static str>,
    ) -> Self {
        let (mut joints, mut count) = ([""; Self::MOST_JOINTS], 0);
        for entry in entries {
            if count < Self::MOST_JOINTS && !joints[..count].contains(&entry) {
                joints[count] = entry;
                count += 1;
            }
        }
        RankLoss {
            time,
            sigma_min,
            undetermined,
            joints,
            count,
        }
    }

    /// The entries of the declaration whose rows depend on each other there, most involved first.
    pub fn joints(&self) -> &[&'static str] {
        &self.joints[..self.count]
    }
}
