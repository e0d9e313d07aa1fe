//! Settings for the choices that Algorithm 1 leaves open.

/// The start values of the multipliers μ in line 3 of Algorithm 1, which the paper does not specify.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum MultiplierStart {
    /// With the change of μ over the last accepted step, scaled by h/h_last; at the start of a run with that of the
    /// reactions at acceleration level, h (λ + f̄)/m̄. A step that is tried again after a rejection is scaled likewise. M-ALF
    /// begins with λ of the last step.
    #[default]
    Warm,
    /// With no change of μ: at zero unless the fields are carried from step to step. M-ALF begins with λ₀ + h μ₀, where
    /// μ₀ is the rate of λ at the end of the last step.
    Cold,
}

/// The direction c_R of equation (19) along which a row has its mass, damping, stiffness and force; a_R c_R = 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum RowDirection {
    /// c_R = M⁻¹aᵀ/(a M⁻¹aᵀ), which gives the least m̄_R = c_Rᵀ M c_R of all directions.
    #[default]
    Metric,
    /// c_R = aᵀ/(a aᵀ), whatever the units of the velocities.
    Euclidean,
}

/// Settings of Algorithm 1. The defaults are those of a search over other mechanisms than those of the charts ("How the
/// baselines were tuned" in the book).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct PaperSettings {
    /// Newton (lines 10–14) stops when the correction of the weak velocities is below this fraction of their size.
    pub newton_tolerance: f64,
    /// Tolerance of the velocity rows ψ̇ (line 28), in their own units.
    pub velocity_tolerance: f64,
    /// Tolerance of the residual ℜ = η(v₁) for the updated q₁ and λ₁ (line 32), in the metric of M⁻¹ and relative to the
    /// motion: √(ℜᵀM⁻¹ℜ) against √(vᵀMv) + h √(FᵀM⁻¹F). Not less than what the last correction of Newton's method leaves.
    pub residual_tolerance: f64,
    /// Initial penalty ξ (line 4); dimensionless, because the rows are scaled by their effective mass m̄.
    pub penalty: f64,
    /// Factor τ > 1 by which the penalty of a row grows (line 22).
    pub penalty_growth: f64,
    /// The largest penalty.
    pub max_penalty: f64,
    /// A row satisfies the augmentation criterion (line 15) when |ψ̇| is below this fraction of its value before the
    /// last Newton block.
    pub augmentation_ratio: f64,
    /// i_max of line 14, 10,000 at most.
    pub max_newton_iterations: usize,
    /// j_max of line 28, 10,000 at most.
    pub max_augmentations: usize,
    /// The least number of updates of q₁ (lines 6–32). If M or the forces depend on q, the first update leaves an error
    /// of second order in each step, which adds up to one of first order; the second update removes it.
    pub min_updates: usize,
    /// k_max of line 32, 10,000 at most.
    pub max_updates: usize,
    /// The step is halved on failure, down to this, s.
    pub smallest_step: f64,
    /// Factor on m̄ of equation (18), for ablations; 1 is the paper.
    pub mass_scale: f64,
    /// Frequency ω, rad/s, of a stabilisation k̄ = m̄ω², c̄ = 2m̄ω added to equation (20); 0 is the paper.
    pub stabilisation_frequency: f64,
    /// The start values of μ in line 3.
    pub start: MultiplierStart,
    /// The direction c_R of each row.
    pub direction: RowDirection,
    /// Whether μ, λ and π are carried from step to step. Being time integrals of reactions they grow without bound then;
    /// without it each step begins with μ = 0, λ = 0, π = Mv. For rows quadratic in q the motion is the same if ψ̇ = 0 is
    /// solved to round-off; with the default tolerances, and for other rows, it is more accurate without.
    pub carried_fields: bool,
}

impl Default for PaperSettings {
    fn default() -> Self {
        PaperSettings {
            newton_tolerance: 1e-8,
            velocity_tolerance: 1e-2,
            residual_tolerance: 1e-2,
            penalty: 100.0,
            penalty_growth: 2.0,
            max_penalty: 1e9,
            augmentation_ratio: 0.5,
            max_newton_iterations: 20,
            max_augmentations: 40,
            min_updates: 2,
            max_updates: 30,
            smallest_step: 1e-9,
            mass_scale: 1.0,
            stabilisation_frequency: 0.0,
            start: MultiplierStart::Warm,
            direction: RowDirection::Metric,
            carried_fields: false,
        }
    }
}

impl PaperSettings {
    /// Defaults for [`Method::MAlf`](crate::Method::MAlf): its penalty is a stiffness, N/m; h²/4 times it is compared
    /// with the masses.
    pub fn m_alf() -> Self {
        PaperSettings {
            residual_tolerance: 1e-3,
            penalty: 1e8,
            max_penalty: 1e14,
            carried_fields: true,
            ..PaperSettings::default()
        }
    }
}
