//! The kinds of joints.

use super::joint::Joint;
use crate::model::arguments::Arguments;
use crate::schema::Kind;

/// A kind of joint or condition: its row of the table, and the function that reads its arguments.
#[derive(Clone, Copy)]
pub(in crate::model) struct JointKind {
    /// The row.
    pub kind: Kind,
    /// Reads an entry; `None` if it has an error, which is recorded.
    pub read: fn(&mut Arguments) -> Option<Joint>,
}
