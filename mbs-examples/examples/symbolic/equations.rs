//! What the rival writes for a mechanism.

/// Standard gravity of the scenes, m/s².
pub const GRAVITY: f64 = 9.81;

/// The saddle system of a mechanism in N bar angles, with numbers in place of parameters:
///
/// ```text
/// [ M  Aᵀ ] [ v̇  ]   [ f  ]
/// [ A  0  ] [ −λ ] = [ −γ ]
/// ```
///
/// Every function that takes angles factors the matrix there; those that follow use this factor.
pub trait Equations<const N: usize>: Default {
    /// Angles and rates at the start.
    fn start() -> [[f64; N]; 2];

    /// Sines, cosines and the factor at these angles.
    fn place(&mut self, q: &[f64; N]);

    /// v̇ where it was placed.
    fn accelerations(&self, v: &[f64; N], into: &mut [f64; N]);

    /// Both at once.
    #[inline(always)]
    fn evaluate(&mut self, q: &[f64; N], v: &[f64; N], into: &mut [f64; N]) {
        self.place(q);
        self.accelerations(v, into);
    }

    /// What moves the angles onto the rows, in the metric of M.
    fn missing_positions(&self) -> [f64; N];

    /// What moves the rates onto the rows, in the metric of M.
    fn missing_velocities(&self, v: &[f64; N]) -> [f64; N];

    /// T + V, J.
    fn energy(q: &[f64; N], v: &[f64; N]) -> f64;
}
