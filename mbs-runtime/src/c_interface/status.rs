//! What calls return, and the text to the last failure.

use crate::SimulationError;
use std::cell::RefCell;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// The result of a call.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(i32)]
pub enum Status {
    /// All is well.
    Ok = 0,
    /// A pointer is null.
    Null = 1,
    /// A size is not that of the struct or array: header and library do not belong together.
    Size = 2,
    /// A parameter, a setting or an input has a value that it cannot have.
    Value = 3,
    /// The mechanism cannot be assembled.
    Assembly = 4,
    /// A step failed; the state is that before it.
    Step = 5,
    /// An error in the library itself. The simulation must not be used any more, except to free it.
    Internal = 6,
}

impl Status {
    /// All of them, with their names in C.
    pub(super) const NAMES: [(Status, &'static str); 7] = [
        (Status::Ok, "MBS_OK"),
        (Status::Null, "MBS_NULL"),
        (Status::Size, "MBS_SIZE"),
        (Status::Value, "MBS_VALUE"),
        (Status::Assembly, "MBS_ASSEMBLY"),
        (Status::Step, "MBS_STEP"),
        (Status::Internal, "MBS_INTERNAL"),
    ];
}

/// Why a call failed.
pub(super) struct Failure {
    status: Status,
    text: String,
}

impl Failure {
    pub(super) fn new(status: Status, text: impl Into<String>) -> Self {
        let text = text.into();
        Failure { status, text }
    }

    /// The same where no simulation was made: no step has failed.
    pub(super) fn at_start(error: SimulationError) -> Self {
        let is_open = matches!(error, SimulationError::NotConverged { .. });
        let mut failure = Failure::from(error);
        if failure.status == Status::Step {
            failure.status = match is_open {
                true => Status::Assembly,
                false => Status::Value,
            };
        }
        failure
    }
}

impl From<SimulationError> for Failure {
    fn from(error: SimulationError) -> Self {
        use SimulationError as E;
        let status = match error {
            E::Assembly(_)
            | E::NotAssembled { .. }
            | E::NoPose { .. }
            | E::Contradiction { .. }
            | E::Held { .. }
            | E::HeldStart { .. } => Status::Assembly,
            E::Parameter(_)
            | E::UnknownName(_)
            | E::Setting { .. }
            | E::Flow { .. }
            | E::Method { .. }
            | E::NotCompiled { .. }
            | E::OtherMethod { .. }
            | E::Order { .. }
            | E::Large { .. }
            | E::Time { .. }
            | E::Input { .. }
            | E::Guess { .. }
            | E::State { .. }
            | E::StateRow { .. } => Status::Value,
            E::NotConverged { .. }
            | E::Astray { .. }
            | E::NonFinite { .. }
            | E::Event { .. }
            | E::EnergyGain { .. }
            | E::EnergyLoss { .. }
            | E::Mass { .. }
            | E::StepUnderflow { .. }
            | E::Tolerance { .. } => Status::Step,
        };
        Failure::new(status, error.to_string())
    }
}

thread_local! {
    static MESSAGE: RefCell<String> = const { RefCell::new(String::new()) };
}

/// The status of some work. No panic passes.
pub(super) fn status_of(work: impl FnOnce() -> Result<(), Failure>) -> i32 {
    // After a panic the caller is told not to use the simulation.
    let failure = match catch_unwind(AssertUnwindSafe(work)) {
        Ok(Ok(())) => return Status::Ok as i32,
        Ok(Err(failure)) => failure,
        Err(_) => Failure::new(Status::Internal, "an error in the library"),
    };
    // Where the thread ends, the text is not kept.
    let _ = MESSAGE.try_with(|message| message.replace(failure.text));
    failure.status as i32
}

/// Writes the text of the last failure of this thread, ending with a zero and cut where it does not fit; returns its
/// length.
///
/// # Safety
/// `buffer` is null or has room for `size` bytes.
pub unsafe fn message(buffer: *mut u8, size: usize) -> usize {
    let read = |message: &RefCell<String>| {
        let message = message.borrow();
        let count = message.len().min(size.saturating_sub(1));
        if !buffer.is_null() && size > 0 {
            // SAFETY: `count` bytes and a zero are at most `size`.
            unsafe {
                buffer.copy_from_nonoverlapping(message.as_ptr(), count);
                buffer.add(count).write(0);
            }
        }
        message.len()
    };
    MESSAGE.try_with(read).unwrap_or(0)
}
