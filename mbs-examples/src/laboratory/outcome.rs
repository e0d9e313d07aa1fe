//! The outcome of a run. The book states the criteria before the results (`results/criteria.md`).

use mbs_runtime::SimulationError;

/// Gain or loss of energy that is allowed, relative to the largest kinetic energy.
pub const ENERGY: f64 = 0.1;
/// Violation of a position row that is allowed, relative to the size of the mechanism.
pub const DRIFT: f64 = 1e-3;
/// Distance from the right motion that is allowed, relative to the size of the mechanism.
pub const ASTRAY: f64 = 0.1;

/// The outcome of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Outcome {
    /// It reached its end on the right branch.
    Ok,
    /// Its poses are not on the right motion, or its position error is too large.
    WrongBranch,
    /// Rows are violated, or energy was lost.
    Drift,
    /// Energy was gained, or the state is not finite.
    EnergyGrowth,
    /// Even the smallest step failed.
    StepUnderflow,
    /// An iteration did not converge.
    NoConvergence,
    /// It took too long and was stopped.
    TooSlow,
    /// The method does not apply to such a mechanism.
    Refused,
}

impl Outcome {
    /// All of them, in the order of a legend.
    pub const ALL: [Outcome; 8] = [
        Outcome::Ok,
        Outcome::WrongBranch,
        Outcome::Drift,
        Outcome::EnergyGrowth,
        Outcome::StepUnderflow,
        Outcome::NoConvergence,
        Outcome::TooSlow,
        Outcome::Refused,
    ];

    /// In files and legends.
    pub fn name(self) -> &'static str {
        match self {
            Outcome::Ok => "ok",
            Outcome::WrongBranch => "wrong branch",
            Outcome::Drift => "drift",
            Outcome::EnergyGrowth => "energy growth",
            Outcome::StepUnderflow => "step underflow",
            Outcome::NoConvergence => "no convergence",
            Outcome::TooSlow => "too slow",
            Outcome::Refused => "not applicable",
        }
    }

    /// The outcome of this name.
    pub fn by_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|outcome| outcome.name() == name)
    }

    /// Whether the method was tried and failed.
    pub fn is_failure(self) -> bool {
        !matches!(self, Outcome::Ok | Outcome::TooSlow | Outcome::Refused)
    }

    /// The outcome for an error during a run.
    pub fn of_error(error: &SimulationError) -> Self {
        match error {
            SimulationError::StepUnderflow { .. } | SimulationError::Tolerance { .. } => {
                Outcome::StepUnderflow
            }
            SimulationError::NotConverged { .. } => Outcome::NoConvergence,
            SimulationError::Astray { .. } => Outcome::WrongBranch,
            SimulationError::NonFinite { .. }
            | SimulationError::Mass { .. }
            | SimulationError::EnergyGain { .. } => Outcome::EnergyGrowth,
            SimulationError::EnergyLoss { .. } => Outcome::Drift,
            _ => Outcome::Refused,
        }
    }
}
