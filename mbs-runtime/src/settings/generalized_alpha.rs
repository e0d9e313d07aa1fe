//! Settings of [`Method::GeneralizedAlpha`](crate::Method::GeneralizedAlpha).

/// Settings of [`Method::GeneralizedAlpha`](crate::Method::GeneralizedAlpha).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct GeneralizedAlphaSettings {
    /// ρ, the factor by which the amplitude of motion of infinite frequency is multiplied in a
    /// step; from 0 to 1.
    pub spectral_radius: f64,
    /// Whether velocities satisfy the rows as well: the stabilised form of index 2.
    pub stabilised: bool,
}

impl Default for GeneralizedAlphaSettings {
    fn default() -> Self {
        GeneralizedAlphaSettings {
            spectral_radius: 0.8,
            stabilised: false,
        }
    }
}
