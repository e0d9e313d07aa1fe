//! Settings of [`Method::Baumgarte`](crate::Method::Baumgarte).

/// Settings of [`Method::Baumgarte`](crate::Method::Baumgarte).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct BaumgarteSettings {
    /// α = β, 1/s.
    pub gain: f64,
    /// Tolerance of an error-controlled pair of orders 5 and 4, relative to the speed of the mechanism and to its size, or to the
    /// largest coordinate if that is larger; `None` for steps of the given length.
    pub adaptive: Option<f64>,
}

impl Default for BaumgarteSettings {
    fn default() -> Self {
        BaumgarteSettings {
            gain: 30.0,
            adaptive: None,
        }
    }
}
