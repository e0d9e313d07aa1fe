//! Results and diagnostics of a simulation.

/// The energy balance, J.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Energy {
    /// T.
    pub kinetic: f64,
    /// V of gravity and springs.
    pub potential: f64,
    /// Work done since the start by applied forces that have no potential.
    pub nonconservative_work: f64,
    /// Work done since the start by rheonomic rows.
    pub drive_work: f64,
    /// T + V − work − (T + V at the start).
    pub error: f64,
}

/// A row of results.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Sample {
    /// Time, s.
    pub time: f64,
    /// In the order of [`Model::outputs`](crate::Model::outputs).
    pub outputs: Vec<f64>,
    /// The energy balance.
    pub energy: Energy,
    /// max |φ| over the holonomic rows, each in its own unit.
    pub holonomic_error: f64,
    /// max |A v + b| over all rows, each in its own unit.
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
    pub values: Vec<f64>,
    /// λ in the order of [`Model::rows`](crate::Model::rows).
    pub multipliers: Vec<f64>,
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
    /// Multiplier iterations (two-level) or Newton iterations (paper).
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
    /// Numerical rank of A at the start.
    pub rank: usize,
    /// Singular poses passed; each is in [`Simulation::rank_losses`](crate::Simulation::rank_losses).
    pub rank_losses: usize,
}

/// A singular pose during the motion: rows that are generally independent were dependent there, or nearly so.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct RankLoss {
    /// When, s; from the steps around it.
    pub time: f64,
    /// The smallest singular value of the rows there, each of unit length in the metric of M; estimated like the time.
    pub sigma_min: f64,
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
            joints,
            count,
        }
    }

    /// The entries of the declaration whose rows depend on each other there, most involved first.
    pub fn joints(&self) -> &[&'static str] {
        &self.joints[..self.count]
    }
}

/// What assembly found.
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct AssemblyVerdict {
    /// max |φ| of the declared guess.
    pub residual_before: f64,
    /// max |φ| after assembly.
    pub residual: f64,
    /// Root mean square change of q, weighted with the masses.
    pub moved: f64,
    /// Numerical rank of A in the assembled pose.
    pub rank: usize,
    /// Rows that depend on those above them in that pose.
    pub redundant_rows: Vec<&'static str>,
    /// The holonomic rows with the largest |φ| after assembly, worst first.
    pub worst_rows: Vec<(&'static str, f64)>,
    /// The coordinates that assembly has moved, the farthest first, and then the velocities that it has changed.
    pub changes: Vec<Change>,
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
}
