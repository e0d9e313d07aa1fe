//! Settings of [`Method::Bdf`](crate::Method::Bdf).

/// Settings of [`Method::Bdf`](crate::Method::Bdf).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct BdfSettings {
    /// Tolerance of the positions in a step, relative to the size of the mechanism, or to the largest coordinate if that is
    /// larger.
    pub tolerance: f64,
    /// Highest order, 1 to 5.
    pub max_order: u8,
}

impl Default for BdfSettings {
    fn default() -> Self {
        BdfSettings {
            tolerance: 1e-6,
            max_order: 5,
        }
    }
}
