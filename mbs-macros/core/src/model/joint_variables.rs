//! `angle`, `rate`, `stroke` and `speed` of a joint, and angles that are counted over full turns, as data.

use crate::symbolic::Expr;

/// A variable of a joint that has a name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum JointVariable {
    Angle,
    Rate,
    Stroke,
    Speed,
}

impl JointVariable {
    /// The rate of a position.
    pub(super) fn rate(self) -> Option<JointVariable> {
        match self {
            JointVariable::Angle => Some(JointVariable::Rate),
            JointVariable::Stroke => Some(JointVariable::Speed),
            JointVariable::Rate | JointVariable::Speed => None,
        }
    }
}

/// A variable that an expression uses.
#[derive(Debug)]
pub(super) struct AskedVariable {
    pub joint: String,
    pub variable: JointVariable,
    /// In local coordinates, marked (see [`Function::Same`]).
    pub expr: Expr,
}

/// The angle of a joint of space, or of a bar of the plane in natural coordinates, that is counted over full turns:
/// `atan2` gives the angle within one turn, and the stored last angle determines the number of turns. (A bar that a drive turns
/// needs no stored angle: its turns are those of the drive.)
#[derive(Debug, Clone)]
pub struct UnwrappedAngle {
    /// The joint or bar.
    pub of: String,
    /// The bar. The angle of a joint of space starts within half a turn of 0, that of a bar of its guess.
    pub bar: Option<usize>,
    /// The counted angle, in local coordinates.
    pub angle: Expr,
    /// The same within one turn.
    pub within: Expr,
}
