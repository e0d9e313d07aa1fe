//! What the last step has told of singular poses ahead, for steps of fixed length.

/// The last step, and the pose that is near.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PosesAhead {
    /// `None` if it tells nothing: after the motion was changed, or past a pose.
    pub last_step: Option<LastStep>,
    /// The pose that the last steps have told of.
    pub foreseen: Option<Foreseen>,
}

/// When the last step began, its length, and the rank margin of the rows there.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LastStep {
    /// s
    pub begin: f64,
    /// s
    pub length: f64,
    /// The least σ of independent rows where it began.
    pub least: f64,
    /// The number of rows that were dependent there.
    pub dependent: u32,
}

/// A pose that is near.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Foreseen {
    /// A singular pose at this time, s.
    Singular(f64),
    /// A pose that is nearly singular.
    Turn {
        /// g, the least σ.
        least: f64,
        /// k, the rate of σ, 1/s.
        rate: f64,
    },
}
