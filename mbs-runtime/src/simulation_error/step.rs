//! The messages about steps that do not converge, or that gain or lose energy.

use super::clock::{Short, clock};
use core::fmt;

/// The cause of a wrong energy balance, and what to do.
fn advice(adaptive: bool) -> &'static str {
    match adaptive {
        false => {
            "the steps are too long for this motion; use a smaller step or a tolerance (vibrations of a stiff spring that are shorter than some steps are followed by no flow), and check what came before"
        }
        true => {
            "the shortest steps that are tried have this error, too: look for a pose that the mechanism cannot pass, as where a drive goes too far; where there is none, use a smaller tolerance; and check what came before"
        }
    }
}

/// The message of [`SimulationError::NotConverged`](super::SimulationError::NotConverged).
pub(super) fn write_not_converged(
    out: &mut fmt::Formatter<'_>,
    row: &str,
    (time, step): (f64, f64),
    (residual, iterations): (f64, usize),
) -> fmt::Result {
    let (time, step) = (clock(time), Short(step));
    match residual.is_infinite() {
        true => write!(
            out,
            "`{row}` cannot be solved in the step from t = {time} s (h = {step} s): a matrix is singular or not finite; use a smaller step, or look for a force that is infinite or NaN there, or has no slope, as atan2(y, x) where both vanish"
        ),
        false => write!(
            out,
            "`{row}` did not converge in the step from t = {time} s (h = {step} s): residual {residual:.3e} after {iterations} iterations; use a smaller step, or, where this does not help, look for a pose that the mechanism cannot pass, as where a drive goes too far"
        ),
    }
}

/// The message of [`SimulationError::EnergyGain`](super::SimulationError::EnergyGain).
pub(super) fn write_gain(
    out: &mut fmt::Formatter<'_>,
    (time, step): (f64, f64),
    [gained, available]: [f64; 2],
    adaptive: bool,
) -> fmt::Result {
    let (time, step, advice) = (clock(time), Short(step), advice(adaptive));
    write!(
        out,
        "the motion has gained {gained:.1e} J up to t = {time} s with steps of {step} s, where start and works have given it {available:.1e} J: {advice}"
    )
}

/// The message of [`SimulationError::EnergyLoss`](super::SimulationError::EnergyLoss).
pub(super) fn write_loss(
    out: &mut fmt::Formatter<'_>,
    (time, step): (f64, f64),
    [lost, available]: [f64; 2],
    adaptive: bool,
) -> fmt::Result {
    let (time, step, advice) = (clock(time), Short(step), advice(adaptive));
    write!(
        out,
        "the motion has lost {lost:.1e} J of {available:.1e} J up to t = {time} s with steps of {step} s, which no force has taken: {advice}"
    )
}
