//! Operation counts: exact, stable, and part of the generated comments.

use super::{Function, Operation};
use std::fmt;

/// Floating-point operations of a function.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Cost {
    /// Additions and subtractions.
    pub additions: usize,
    /// Multiplications.
    pub multiplications: usize,
    /// Divisions.
    pub divisions: usize,
    /// Elementary functions, laws and tables.
    pub calls: usize,
}

impl Cost {
    /// Loops of as many multiplications as additions.
    pub fn of_loops(operations: usize) -> Self {
        Cost {
            additions: operations / 2,
            multiplications: operations - operations / 2,
            ..Cost::default()
        }
    }

    /// All operations.
    pub fn total(self) -> usize {
        self.additions + self.multiplications + self.divisions + self.calls
    }
}

impl Function {
    /// The operations of this function (negations are free: they become subtractions).
    pub fn cost(&self) -> Cost {
        let mut cost = Cost::default();
        for operation in &self.operations {
            match operation {
                Operation::Add(..) | Operation::Subtract(..) | Operation::Larger(..) => {
                    cost.additions += 1;
                }
                Operation::Multiply(..) => cost.multiplications += 1,
                Operation::Divide(..) | Operation::PivotInverse(..) => cost.divisions += 1,
                Operation::Call(..)
                | Operation::Atan2(..)
                | Operation::Power(..)
                | Operation::Law(..)
                | Operation::Table(..) => cost.calls += 1,
                Operation::Negate(_) | Operation::Part(..) => {}
            }
        }
        cost
    }
}

impl fmt::Display for Cost {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            out,
            "add: {}  multiply: {}  divide: {}  call: {}",
            self.additions, self.multiplications, self.divisions, self.calls
        )
    }
}
