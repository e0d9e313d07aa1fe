//! q, v and the motion along velocities.

use nalgebra::SVector;

/// The configuration of a mechanism with Q coordinates and N velocities.
pub trait Configuration<const Q: usize, const N: usize>: Clone {
    /// For each unit quaternion the index in v at which its angular velocity begins.
    const ROTATIONS: &'static [usize];

    /// Declared guesses of q and v at time 0; they need not satisfy the constraints.
    fn guess(&self) -> (SVector<f64, Q>, SVector<f64, N>);

    /// q ⊕ h v: translations q + h v, unit quaternions q ∘ exp(h ω/2) (ω in body axes), renormalised.
    fn advance(&self, q: &SVector<f64, Q>, v: &SVector<f64, N>, h: f64) -> SVector<f64, Q>;
    /// v of unit time that leads from one configuration to another: `advance(from, difference(from, to), 1.0)` is `to`.
    fn difference(&self, from: &SVector<f64, Q>, to: &SVector<f64, Q>) -> SVector<f64, N>;
    /// Free flight of all bodies over h: translations q + h v; rotations by the symmetric splitting into principal-axis
    /// rotations, which changes ω (body axes) at constant angular momentum.
    fn free_flight(&self, q: &mut SVector<f64, Q>, v: &mut SVector<f64, N>, h: f64);
}
