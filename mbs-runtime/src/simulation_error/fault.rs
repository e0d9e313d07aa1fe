//! Errors of steps from the reasons of methods.

use super::SimulationError;
use crate::Model;
use crate::fault::Fault;

impl SimulationError {
    /// Adds names and time to the reason for which a step failed.
    #[cold]
    pub(crate) fn from_fault(fault: Fault, model: &'static Model, time: f64, step: f64) -> Self {
        const MOTION: &str = "equations of motion";
        let name = |row: usize| model.rows.get(row).map_or("unnamed row", |row| row.name);
        match fault {
            Fault::Row {
                row,
                residual,
                iterations,
            } => SimulationError::NotConverged {
                time,
                step,
                row: name(row),
                residual,
                iterations,
            },
            Fault::Flow {
                residual,
                iterations,
            } => SimulationError::NotConverged {
                time,
                step,
                row: MOTION,
                residual,
                iterations,
            },
            Fault::Astray(by) => SimulationError::Astray { time, step, by },
            Fault::Length(wanted) => SimulationError::Setting {
                name: "step",
                value: step,
                wanted,
            },
            Fault::NonFinite(what) => SimulationError::NonFinite { time, what },
            Fault::Mass => SimulationError::Mass { time },
            Fault::Underflow { row, step } => SimulationError::StepUnderflow {
                time,
                step,
                row: row.map_or(MOTION, name),
            },
        }
    }
}
