//! Settings of [`Method::Penalty`](crate::Method::Penalty).

/// Settings of [`Method::Penalty`](crate::Method::Penalty).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct PenaltySettings {
    /// Stiffness ξ of a row over its effective mass, 1/s². A nonholonomic row has a damper alone, of ξ · 1 s over its effective
    /// mass.
    pub penalty: f64,
    /// Damping ratio ζ of a holonomic row; 1 is critical.
    pub damping_ratio: f64,
}

impl Default for PenaltySettings {
    fn default() -> Self {
        PenaltySettings {
            penalty: 1e7,
            damping_ratio: 3.0,
        }
    }
}
