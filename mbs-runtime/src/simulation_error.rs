//! Errors of a simulation: what happened, where (row, coordinate, time), and what to do.

mod clock;
mod error_of;
mod fault;
#[cfg(feature = "std")]
mod start;
mod step;

use self::clock::{Short, Whole, clock};
pub use self::error_of::ErrorOf;
use core::fmt;

#[cfg(feature = "std")]
use crate::{AssemblyVerdict, HeldGap, Level};
use crate::{Flow, ParameterError, UnknownName};

/// Why a simulation could not be set up or continued.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum SimulationError {
    /// The parameters do not make a mechanism.
    Parameter(ParameterError),
    /// A name that the mechanism does not have.
    UnknownName(UnknownName),
    /// A setting that cannot be used.
    Setting {
        /// The setting: a field of [`Settings`](crate::Settings) or of a method's settings, or its name in words.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What it should be.
        wanted: &'static str,
    },
    /// The flow of the settings cannot integrate this mechanism.
    Flow {
        /// The flow of the settings.
        flow: Flow,
        /// Why not.
        because: &'static str,
        /// One that can.
        instead: Flow,
    },
    /// The dense arrays of a step would not fit on a stack.
    Large {
        /// N.
        velocities: usize,
        /// The flow that would need them; `None`: the start.
        flow: Option<Flow>,
        /// What to do.
        wanted: &'static str,
    },
    /// A method that cannot integrate this mechanism.
    Method {
        /// The method of the settings.
        method: &'static str,
        /// Why not.
        because: &'static str,
    },
    /// A method that a stepper, or another setting, is not for.
    OtherMethod {
        /// The method of the settings.
        method: &'static str,
        /// What can be given.
        wanted: &'static str,
    },
    /// A method that this simulation was not compiled with.
    NotCompiled {
        /// The method of the settings.
        method: &'static str,
    },
    /// An order that the method does not reach with this mechanism.
    Order {
        /// The order of the settings.
        order: u8,
        /// Why not.
        because: &'static str,
    },
    /// A time to run to that lies in the past or is not finite.
    Time {
        /// The current time, s.
        now: f64,
        /// The given time, s.
        wanted: f64,
    },
    /// The declared guess cannot be assembled.
    #[cfg(feature = "std")]
    Assembly(AssemblyVerdict),
    /// The same without a list of rows.
    NotAssembled {
        /// The row that is farthest from satisfied.
        row: &'static str,
        /// Its residual.
        residual: f64,
    },
    /// No pose near the present one satisfies the rows with other inputs or parameters: the simulation goes on with those that
    /// it had.
    #[cfg(feature = "std")]
    NoPose {
        /// What was changed: `inputs` or `parameters`.
        changed: &'static str,
        /// The rows of the nearest pose.
        verdict: Box<AssemblyVerdict>,
    },
    /// No velocities satisfy the rows, at the start or after a change: rows on velocities, or the rates of driven rows, contradict each other.
    Contradiction {
        /// The row that is farthest from satisfied.
        row: &'static str,
        /// What is left of its rate, in its unit a second.
        rate: f64,
    },
    /// A declaration that holds initial values, for a simulation that cannot.
    HeldStart {
        /// The first of them.
        name: &'static str,
    },
    /// Initial values that cannot be held: too many, or values that the rows do not allow.
    #[cfg(feature = "std")]
    Held {
        /// Positions or velocities.
        level: Level,
        /// All that are held.
        held: Vec<String>,
        /// Those that would be off, the worst first.
        open: Vec<HeldGap>,
        /// How many can be held at most.
        degrees_of_freedom: usize,
    },
    /// A constraint row did not converge.
    NotConverged {
        /// Time at the start of the step, s.
        time: f64,
        /// The step, s.
        step: f64,
        /// The row, or `equations of motion`.
        row: &'static str,
        /// Its residual.
        residual: f64,
        /// Iterations taken.
        iterations: usize,
    },
    /// The rows hold at the end of the step, but in another pose than that of the motion.
    Astray {
        /// Time at the start of the step, s.
        time: f64,
        /// The step, s.
        step: f64,
        /// The way that the velocities do not account for, in lengths of the mechanism or radians.
        by: f64,
    },
    /// A quantity became infinite or NaN.
    NonFinite {
        /// Time at the start of the step, s.
        time: f64,
        /// The quantity.
        what: &'static str,
    },
    /// The expression of an event is not a number, so that its sign cannot change.
    Event {
        /// Time, s.
        time: f64,
        /// The event.
        event: &'static str,
    },
    /// The motion has gained energy without a source: the steps are too long for it, and the results before are
    /// doubtful.
    EnergyGain {
        /// Time at the end of the step, s.
        time: f64,
        /// The step, s.
        step: f64,
        /// The error of the energy balance, J.
        gained: f64,
        /// The energy that start and works have given, J.
        available: f64,
        /// Whether steps follow a tolerance: then the shortest one that may be tried has this error, too.
        adaptive: bool,
    },
    /// The motion has lost a large part of its energy, which no force has taken: the steps are too long for it, and the
    /// results before are doubtful.
    EnergyLoss {
        /// Time at the end of the step, s.
        time: f64,
        /// The step, s.
        step: f64,
        /// The error of the energy balance with its sign changed, J.
        lost: f64,
        /// The energy that start and works have given, J.
        available: f64,
        /// Whether steps follow a tolerance: then the shortest one that may be tried has this error, too.
        adaptive: bool,
    },
    /// The mass matrix is not positive definite.
    Mass {
        /// Time, s.
        time: f64,
    },
    /// A method that chooses its steps, such as Algorithm 1, reached its smallest step.
    StepUnderflow {
        /// Time at the start of the step, s.
        time: f64,
        /// The last step tried, s.
        step: f64,
        /// The row that did not converge, or `equations of motion`.
        row: &'static str,
    },
    /// [`Settings::tolerance`](crate::Settings::tolerance) cannot be met.
    Tolerance {
        /// Time at the start of the step, s.
        time: f64,
        /// The last step tried, s.
        step: f64,
        /// The tolerance.
        tolerance: f64,
        /// The estimated error as a multiple of what the tolerance allows.
        times: f64,
        /// What it is the error of.
        of: ErrorOf,
    },
    /// A value that an input or a state cannot take.
    Input {
        /// The input or state.
        name: &'static str,
        /// The value.
        value: f64,
    },
    /// Values at the start, or after a change, that are not finite, or give forces or energies that are not.
    Guess {
        /// What is wrong: a coordinate, a velocity.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// A state that a simulation cannot resume from.
    State {
        /// What is wrong: a coordinate, the time.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// A state that violates a row by more than the method leaves.
    StateRow {
        /// The row.
        row: &'static str,
        /// Its residual, or the rate of it.
        residual: f64,
    },
}

impl SimulationError {
    /// Whether a shorter step can succeed.
    pub(crate) fn asks_for_less(&self) -> bool {
        use SimulationError::{Astray, Mass, NotConverged};
        // In poses that a step much too long tries, M may be anything.
        matches!(self, NotConverged { .. } | Astray { .. } | Mass { .. })
    }

    /// Whether other steps, or those of another method, may succeed.
    pub(crate) fn is_due_to_steps(&self) -> bool {
        use SimulationError::{EnergyGain, EnergyLoss, NonFinite, Tolerance};
        let of_step = matches!(
            self,
            NonFinite { .. } | EnergyGain { .. } | EnergyLoss { .. } | Tolerance { .. }
        );
        of_step || self.asks_for_less()
    }
}

impl fmt::Display for SimulationError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        use SimulationError::*;
        match self {
            Parameter(error) => error.fmt(out),
            UnknownName(error) => error.fmt(out),
            Setting {
                name,
                value,
                wanted,
            } => {
                write!(
                    out,
                    "setting `{name}` is {}; give it {wanted}",
                    Whole(*value)
                )
            }
            Flow {
                flow,
                because,
                instead,
            } => write!(
                out,
                "the {} flow cannot be used here: {because}; use {}, or leave the choice to the runtime",
                flow.name(),
                instead.name()
            ),
            Large {
                velocities,
                flow,
                wanted,
            } => {
                match flow {
                    Some(flow) => write!(
                        out,
                        "the {} flow would need dense arrays of {velocities} × {velocities} numbers",
                        flow.name()
                    )?,
                    None => write!(
                        out,
                        "this start would need dense arrays of {velocities} velocities and all rows"
                    )?,
                }
                write!(out, "; {wanted}")
            }
            Method { method, because } => write!(
                out,
                "the method {method} cannot integrate this mechanism: {because}; use two-level"
            ),
            OtherMethod { method, wanted } => {
                write!(
                    out,
                    "the method `{method}` cannot be used here: give {wanted}"
                )
            }
            NotCompiled { method } => write!(
                out,
                "method `{method}` is not compiled into this simulation; construct it with `Simulation::with_methods` and a value of `mbs_runtime::methods`, or resume it with `Simulation::resume_with_methods`"
            ),
            Order { order, because } => write!(
                out,
                "order {order} cannot be had here: {because}; leave the order at 2, the default"
            ),
            Time { now, wanted } => write!(
                out,
                "cannot run to t = {} s from t = {} s; give a finite time that is not in the past",
                Whole(*wanted),
                Whole(*now)
            ),
            #[cfg(feature = "std")]
            Assembly(verdict) => start::write_assembly(out, verdict),
            #[cfg(feature = "std")]
            NoPose { changed, verdict } => start::write_no_pose(out, changed, verdict),
            NotAssembled { row, residual } => write!(
                out,
                "the mechanism cannot be assembled near its declared guess; `{row}` is off most (residual {residual:.3e}); check the lengths in this joint, or start from a closer guess"
            ),
            Contradiction { row, rate } => write!(
                out,
                "no velocities satisfy `{row}` and the other rows here: a rate of {rate:.3e} is left; leave this row out, or make its rate agree with those of the others"
            ),
            HeldStart { name } => write!(
                out,
                "the declaration holds `{name}` exactly, which only `Simulation` does: take the state from one, and resume from it"
            ),
            #[cfg(feature = "std")]
            Held {
                level,
                held,
                open,
                degrees_of_freedom,
            } => start::write_held(out, *level, held, open, *degrees_of_freedom),
            NotConverged {
                time,
                step,
                row,
                residual,
                iterations,
            } => step::write_not_converged(out, row, (*time, *step), (*residual, *iterations)),
            Astray { time, step, by } => write!(
                out,
                "the step from t = {} s (h = {} s) leads to another assembly of the mechanism, {by:.1} of its lengths or radians from where its velocities lead; use a smaller step",
                clock(*time),
                Short(*step)
            ),
            NonFinite { time, what } => write!(
                out,
                "the {what} became infinite or NaN in the step from t = {} s; use a smaller step, or look for a force that grows without bound",
                clock(*time)
            ),
            Event { time, event } => write!(
                out,
                "the event `{event}` is NaN at t = {} s; keep its expression within its domain, for example by `max`",
                clock(*time)
            ),
            EnergyGain {
                time,
                step,
                gained,
                available,
                adaptive,
            } => step::write_gain(out, (*time, *step), [*gained, *available], *adaptive),
            EnergyLoss {
                time,
                step,
                lost,
                available,
                adaptive,
            } => step::write_loss(out, (*time, *step), [*lost, *available], *adaptive),
            Mass { time } => write!(
                out,
                "the mass matrix is not positive definite at t = {} s: something moves without mass there; use a smaller step, or give mass and inertia to every part that moves",
                clock(*time)
            ),
            StepUnderflow { time, step, row } => write!(
                out,
                "`{row}` cannot be satisfied beyond t = {} s, not even with a step of {step:.1e} s; loosen the tolerance (for Algorithm 1 `velocity_tolerance`), or use the two-level method, which passes singular poses",
                clock(*time)
            ),
            Tolerance {
                time,
                step,
                tolerance,
                times,
                of,
            } => {
                write!(
                    out,
                    "the tolerance {tolerance:.1e} cannot be met beyond t = {} s: with a step of {step:.1e} s ",
                    clock(*time)
                )?;
                match of {
                    ErrorOf::Velocity(name) => write!(out, "the error along `{name}`")?,
                    ErrorOf::Motion => write!(out, "the error of the motion")?,
                    ErrorOf::Balance => write!(out, "the error of the energy balance")?,
                    ErrorOf::Branch => {
                        return write!(
                            out,
                            "the motion still leaps over a pose that is nearly singular; loosen the tolerance of the rows, or look for lengths that are nearly equal"
                        );
                    }
                }
                write!(
                    out,
                    " is still {times:.1e} times what it allows; loosen the tolerance, or look for a force that jumps there"
                )
            }
            Input { name, value } => {
                write!(out, "`{name}` cannot be {value}; give it a finite value")
            }
            Guess { what, value } => write!(
                out,
                "cannot start with these values: {what} is {value}; give finite initial values, and parameters that make them finite"
            ),
            State { what, value } => write!(
                out,
                "cannot resume from this state: {what} is {value:.3e}; pass a state taken from a simulation of the same mechanism and parameters"
            ),
            StateRow { row, residual } => write!(
                out,
                "cannot resume from this state: the row `{row}`, or its rate, is {residual:.3e}; pass a state taken from a simulation of the same mechanism and parameters by a method that satisfies rows as closely, or raise `constraint_tolerance`"
            ),
        }
    }
}

impl core::error::Error for SimulationError {
    /// The error of the parameters or of a name. The message of this error includes that of its source.
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            SimulationError::Parameter(source) => Some(source),
            SimulationError::UnknownName(source) => Some(source),
            _ => None,
        }
    }
}

impl From<ParameterError> for SimulationError {
    fn from(error: ParameterError) -> Self {
        SimulationError::Parameter(error)
    }
}

impl From<UnknownName> for SimulationError {
    fn from(error: UnknownName) -> Self {
        SimulationError::UnknownName(error)
    }
}
