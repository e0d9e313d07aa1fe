//! Joints and force elements with their names.

use super::force::Force;
use super::joint::Joint;
use proc_macro2::Span;

/// A joint or constraint, or the length of a bar.
#[derive(Debug)]
pub struct JointEntry {
    /// The name of its entry.
    pub name: String,
    /// Where it is declared.
    pub span: Span,
    /// Its data.
    pub joint: Joint,
}

/// A force element, which is read at its first use.
#[derive(Debug)]
pub enum ReadForce {
    /// It is being read.
    Working,
    /// `None` after an error.
    Read(Option<Force>),
}

/// A force element.
#[derive(Debug)]
pub struct ForceEntry {
    /// The name of its entry.
    pub name: String,
    /// Its data.
    pub force: Force,
}
