//! Settings of [`Method::Index3Projections`](crate::Method::Index3Projections).

/// Settings of [`Method::Index3Projections`](crate::Method::Index3Projections).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProjectionSettings {
    /// ξ.
    pub penalty: f64,
}

impl Default for ProjectionSettings {
    fn default() -> Self {
        ProjectionSettings { penalty: 1e9 }
    }
}
