//! The kinds of joints.

use super::joint::Joint;
use crate::model::arguments::Arguments;
use crate::schema::Kind;

/// A kind of joint or condition: its row of the table, and what reads its arguments.
#[derive(Clone, Copy)]
pub(in crate::model) struct JointKind {
    /// The row.
    pub kind: Kind,
    /// Reads an entry; nothing where it is wrong, which is recorded.
    pub read: fn(&mut Arguments) -> Option<Joint>,
}
