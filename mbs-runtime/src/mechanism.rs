//! The contract between generated code and the runtime.
//!
//! `mechanism!` generates two types. The one that carries the declared name holds the **parameters** as public fields
//! and implements [`Mechanism`]. [`Mechanism::prepare`] turns it into a **system**, in which everything that depends on
//! parameters alone has been computed once; it implements [`System`]. Integrators see these traits, never the types.
//!
//! | symbol | shape | meaning |
//! |---|---|---|
//! | q | Q | generalized coordinates; rotations as unit quaternions (w, x, y, z) that take body axes to space axes |
//! | v | N | generalized velocities, q̇ = G(q) v: rates of translations and angles; angular velocities in body axes |
//! | M | N × N | mass matrix |
//! | φ, ψ̇ | R | constraint rows: holonomic (first [`Structure::holonomic_rows`]), then nonholonomic |
//! | A | R × N | constraint Jacobian: ∂φ/∂q · G, then the coefficients of ψ̇ = N v + n |
//! | b | R | rheonomic part of the velocity rows: φ̇ = A v + b |
//!
//! Derivatives with respect to q are taken along velocities, D_j f = ∂f/∂q · G_j, and have N columns. In the plane G is
//! the identity and Q = N.

use crate::generated::Elimination;
use crate::{MatrixSink, Model, ParameterError, Structure, TensorSink, UnknownName};

/// A declared mechanism: its parameters, before anything was computed from them.
pub trait Mechanism: Clone + Default {
    /// The prepared form.
    type System: Clone;
    /// What was modelled.
    const MODEL: &'static Model;

    /// Checks the parameters and computes all that depends on them alone.
    ///
    /// # Errors
    /// A parameter that is not finite, or parameters for which M is constant and not positive definite.
    fn prepare(&self) -> Result<Self::System, ParameterError>;

    /// The parameter of this name.
    fn parameter(&self, name: &str) -> Option<f64>;

    /// Sets a parameter by name.
    ///
    /// # Errors
    /// No parameter has this name.
    fn set_parameter(&mut self, name: &str, value: f64) -> Result<(), UnknownName>;
}

/// The equations of a mechanism for one set of parameters, with Q coordinates, N velocities and R constraint
/// rows.
///
/// Functions that fill arrays write structurally nonzero entries only: clear the array once, when it is made.
/// None of them allocates.
pub trait System<const Q: usize, const N: usize, const R: usize>: Clone {
    /// What was modelled.
    const MODEL: &'static Model;
    /// What the integrator may rely on.
    const STRUCTURE: Structure;
    /// For each unit quaternion, where its angular velocity begins in v.
    const ROTATIONS: &'static [usize];
    /// A factor of M(q): nothing where M is constant (its inverse is in the system), else D⁻¹ and the entries
    /// of L of M = L D Lᵀ, or a Cholesky factor of a long one.
    type Mass: Clone;
    /// Elimination without zeros, for large mechanisms to which it applies.
    const ELIMINATION: Option<&'static Elimination<N, R>> = None;

    /// The current values of the `Input`s, in the order of [`Model::inputs`].
    fn inputs(&self) -> &[f64];
    /// The current values of the `Input`s, to be set.
    fn inputs_mut(&mut self) -> &mut [f64];
    /// Declared guesses of q and v at time 0; they need not satisfy the constraints.
    fn guess(&self) -> ([f64; Q], [f64; N]);

    /// q ⊕ h v: translations q + h v, unit quaternions q ∘ exp(h ω/2) (ω in body axes), renormalised.
    fn advance(&self, q: &[f64; Q], v: &[f64; N], h: f64) -> [f64; Q];
    /// v of unit time that leads from one configuration to another: `advance(from, difference(from, to), 1.0)` is `to`.
    fn difference(&self, from: &[f64; Q], to: &[f64; Q]) -> [f64; N];
    /// Free flight of all bodies over h: translations q + h v; rotations by the symmetric splitting into principal-axis
    /// rotations, which changes ω (body axes) at constant angular momentum.
    fn free_flight(&self, q: &mut [f64; Q], v: &mut [f64; N], h: f64);

    /// M(q), both triangles.
    fn mass_matrix(&self, q: &[f64; Q], mass: &mut impl MatrixSink);
    /// A factor of M(q); `None` if M is not positive definite there.
    fn factor_mass(&self, q: &[f64; Q]) -> Option<Self::Mass>;
    /// x ← M⁻¹ x.
    fn solve_mass(&self, mass: &Self::Mass, x: &mut [f64; N]);
    /// Row by row w = M⁻¹ a; `a` has the zero pattern of A.
    fn solve_mass_rows(&self, mass: &Self::Mass, a: &[[f64; N]; R], w: &mut [[f64; N]; R]);
    /// `delassus[i][j]` = a_i · w_j, where `a` has the zero pattern of A.
    fn delassus(&self, a: &[[f64; N]; R], w: &[[f64; N]; R], delassus: &mut [[f64; R]; R]);
    /// `w` = M⁻¹ a row by row and `delassus` = A M⁻¹ Aᵀ, where `a` is A(q, t) and `mass` the factor of M(q). Generated where
    /// one fused function is cheaper than the two it stands for.
    #[inline(always)]
    #[allow(clippy::too_many_arguments)]
    fn metric(
        &self,
        mass: &Self::Mass,
        t: f64,
        q: &[f64; Q],
        a: &[[f64; N]; R],
        w: &mut [[f64; N]; R],
        delassus: &mut [[f64; R]; R],
    ) {
        let _ = (t, q);
        self.solve_mass_rows(mass, a, w);
        self.delassus(a, w, delassus);
    }
    /// A v, where `a` has the zero pattern of A.
    #[inline(always)]
    fn row_rates(&self, a: &[[f64; N]; R], v: &[f64; N], rates: &mut [f64; R]) {
        for (rate, a) in rates.iter_mut().zip(a) {
            *rate = crate::linear::dot(a, v);
        }
    }
    /// p = M(q) v.
    fn momentum(&self, q: &[f64; Q], v: &[f64; N], p: &mut [f64; N]);
    /// Christoffel affinities of the first kind, Γ_ijk = ½ (∂M_ij/∂q_k + ∂M_ik/∂q_j − ∂M_jk/∂q_i), and the structure
    /// constants of the rotations (ω × Jω), so that d(M v)/dt − ∂T/∂q = M v̇ + Γ_ijk v_j v_k.
    ///
    /// Generated where they take at most 2500 operations. Elsewhere they are read off ∂p/∂q and M at run time: for checks,
    /// not for steps, as it allocates.
    fn affinities(&self, q: &[f64; Q], gamma: &mut impl TensorSink) {
        crate::affinities::by_tangents(self, q, gamma);
    }

    /// φ(q, t), the holonomic rows only.
    fn holonomic(&self, t: f64, q: &[f64; Q], phi: &mut [f64; R]);
    /// φ (holonomic rows only), A and b.
    fn constraints(
        &self,
        t: f64,
        q: &[f64; Q],
        phi: &mut [f64; R],
        a: &mut impl MatrixSink,
        b: &mut [f64; R],
    );
    /// The same with A in the array of K, where there is an [`Self::ELIMINATION`].
    #[inline(always)]
    fn sparse_constraints(
        &self,
        t: f64,
        q: &[f64; Q],
        phi: &mut [f64; R],
        k: &mut [f64],
        b: &mut [f64; R],
    ) {
        let _ = (t, q, phi, k, b);
    }
    /// Ȧ along v, and γ = d(A v + b)/dt at constant v: the rows at acceleration level are A v̇ + γ = 0.
    fn constraint_rates(
        &self,
        t: f64,
        q: &[f64; Q],
        v: &[f64; N],
        a_rate: &mut impl MatrixSink,
        gamma: &mut [f64; R],
    );

    /// Applied generalized forces f(q, v, t): gravity, springs, dampers, forces, torques.
    fn applied_forces(&self, t: f64, q: &[f64; Q], v: &[f64; N], f: &mut [f64; N]);
    /// F = f + ∂T/∂q + (Jω) × ω of the rotations, the right-hand side of ṗ = F + Aᵀλ.
    fn forces(&self, t: f64, q: &[f64; Q], v: &[f64; N], f: &mut [f64; N]);
    /// ∂f/∂q and ∂f/∂v of the applied forces.
    fn applied_force_tangents(
        &self,
        t: f64,
        q: &[f64; Q],
        v: &[f64; N],
        f_q: &mut impl MatrixSink,
        f_v: &mut impl MatrixSink,
    );
    /// ∂F/∂q, ∂F/∂v and ∂p/∂q (the last is zero where M is constant).
    fn force_tangents(
        &self,
        t: f64,
        q: &[f64; Q],
        v: &[f64; N],
        f_q: &mut impl MatrixSink,
        f_v: &mut impl MatrixSink,
        p_q: &mut impl MatrixSink,
    );
    /// p and F at once: generated where M varies, so that what they share is computed once.
    #[inline(always)]
    fn balance(&self, t: f64, q: &[f64; Q], v: &[f64; N], p: &mut [f64; N], f: &mut [f64; N]) {
        self.momentum(q, v, p);
        self.forces(t, q, v, f);
    }
    /// M, ∂F/∂q, ∂F/∂v and ∂p/∂q at once: generated where M varies.
    #[inline(always)]
    #[allow(clippy::too_many_arguments)]
    fn balance_tangents(
        &self,
        t: f64,
        q: &[f64; Q],
        v: &[f64; N],
        mass: &mut impl MatrixSink,
        f_q: &mut impl MatrixSink,
        f_v: &mut impl MatrixSink,
        p_q: &mut impl MatrixSink,
    ) {
        self.mass_matrix(q, mass);
        self.force_tangents(t, q, v, f_q, f_v, p_q);
    }
    /// M⁻¹ f(q, t) of the applied forces, where M is constant and forces do not depend on velocities; zero elsewhere (it is not used there).
    fn acceleration(&self, t: f64, q: &[f64; Q], acceleration: &mut [f64; N]);

    /// v̇ and λ of M v̇ + ṗ|_v = F + Aᵀλ, A v̇ + γ + `correction` = 0. A row that follows from others ([`Model::mobility`], or
    /// a singular pose) has λ = 0 and is not asked for: v̇ is the same whatever the division of the work, λ is not that of
    /// minimum norm. `pivot_loss` of a row is what its pivot in A M⁻¹Aᵀ began with, divided by the pivot: 1 if the row is
    /// orthogonal to those before it, or always redundant; 0 if it was passed over here. Generated where it is straight-line code
    /// of bearable length; else it computes nothing and answers `false`.
    #[inline(always)]
    #[allow(clippy::too_many_arguments)]
    fn accelerations(
        &self,
        t: f64,
        q: &[f64; Q],
        v: &[f64; N],
        correction: &[f64; R],
        acceleration: &mut [f64; N],
        lambda: &mut [f64; R],
        pivot_loss: &mut [f64; R],
    ) -> bool {
        let _ = (t, q, v, correction, acceleration, lambda, pivot_loss);
        false
    }

    /// T(q, v), J.
    fn kinetic_energy(&self, q: &[f64; Q], v: &[f64; N]) -> f64;
    /// V(q) of gravity and springs, J.
    fn potential_energy(&self, q: &[f64; Q]) -> f64;
    /// Power of the applied forces that have no potential, W.
    fn nonconservative_power(&self, t: f64, q: &[f64; Q], v: &[f64; N]) -> f64;

    /// `Output`s, in the order of [`Model::outputs`] (a shorter slice receives the first ones).
    fn outputs(&self, t: f64, q: &[f64; Q], v: &[f64; N], outputs: &mut [f64]);
    /// `Event` expressions, in the order of [`Model::events`].
    fn events(&self, t: f64, q: &[f64; Q], v: &[f64; N], events: &mut [f64]);
    /// Points in world axes, m, in the order of [`Model::points`].
    fn points(&self, t: f64, q: &[f64; Q], points: &mut [[f64; 3]]);
    /// Joint reactions from accelerations v̇ and multipliers λ (of M v̇ + Γvv = f + Aᵀλ), in the order of
    /// [`Model::reactions`].
    fn reactions(
        &self,
        t: f64,
        q: &[f64; Q],
        v: &[f64; N],
        acceleration: &[f64; N],
        lambda: &[f64; R],
        reactions: &mut [f64],
    );
}
