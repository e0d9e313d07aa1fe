//! Settings of [`Method::Penalty`](crate::Method::Penalty).

/// Settings of [`Method::Penalty`](crate::Method::Penalty).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct PenaltySettings {
    /// ξ, 1/s².
    pub penalty: f64,
    /// ζ.
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
