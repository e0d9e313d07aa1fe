//! Settings of [`Method::Index3Projections`](crate::Method::Index3Projections).

/// Settings of [`Method::Index3Projections`](crate::Method::Index3Projections).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct ProjectionSettings {
    /// Penalty ξ of a row over its effective mass, dimensionless.
    pub penalty: f64,
}

impl Default for ProjectionSettings {
    fn default() -> Self {
        ProjectionSettings { penalty: 1e9 }
    }
}
