//! The equations at acceleration level (index 1): M v̇ + Γvv = f + Aᵀλ, A v̇ + γ = 0.

use super::bench::Bench;
use crate::alf3f::Fault;
use crate::linear::{SymmetricDual, accumulate};
use crate::sink::Discard;
use crate::{MatrixSink, System};

/// Accelerations and multipliers, with the stabilising terms of Baumgarte where they are asked for:
///
/// ```text
/// A v̇ + γ + 2α (A v + b) + β² φ = 0
/// ```
pub(crate) struct Index1<const N: usize, const R: usize> {
    pub(crate) dual: Box<SymmetricDual<R>>,
    /// 2α, 1/s.
    damping: f64,
    /// β², 1/s².
    stiffness: f64,
    gamma: [f64; R],
    /// λ of the last acceleration.
    pub(crate) lambda: [f64; R],
}

impl<const N: usize, const R: usize> Index1<N, R> {
    /// With α = β = `gain`, 1/s.
    pub(crate) fn new(gain: f64) -> Self {
        Index1 {
            dual: Box::new(SymmetricDual::new()),
            damping: 2.0 * gain,
            stiffness: gain * gain,
            gamma: [0.0; R],
            lambda: [0.0; R],
        }
    }

    /// v̇ at (t, q, v): by the generated function where there is one.
    #[inline(always)]
    pub(crate) fn evaluate<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        t: f64,
        q: &[f64; Q],
        v: &[f64; N],
    ) -> Result<[f64; N], Fault> {
        let mut acceleration = [0.0; N];
        // The works of drives ask for b.
        if !S::STRUCTURE.time_dependent {
            let correction = self.stabilisation(bench, t, q, v);
            let lambda = &mut self.lambda;
            let system = &bench.system;
            if system.accelerations(t, q, v, &correction, &mut acceleration, lambda) {
                return Ok(acceleration);
            }
        }
        self.place(bench, t, q)?;
        Ok(self.acceleration(bench, t, q, v))
    }

    /// 2α (A v + b) + β² φ.
    #[inline(always)]
    fn stabilisation<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        t: f64,
        q: &[f64; Q],
        v: &[f64; N],
    ) -> [f64; R] {
        if self.damping == 0.0 && self.stiffness == 0.0 {
            return [0.0; R];
        }
        let Bench {
            system, node, phi, ..
        } = bench;
        system.constraints(t, q, phi, &mut *node.a, &mut node.b);
        let rates = node.velocity_rows(system, v);
        std::array::from_fn(|i| self.damping * rates[i] + self.stiffness * phi[i])
    }

    /// Constraints and metric at (t, q), with S factored.
    #[inline(always)]
    pub(crate) fn place<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        t: f64,
        q: &[f64; Q],
    ) -> Result<(), Fault> {
        let Bench {
            system, node, phi, ..
        } = bench;
        system.constraints(t, q, phi, &mut *node.a, &mut node.b);
        node.metric(system, t, q)?;
        self.dual.factor(&node.gram);
        bench.counters.regularised += u64::from(self.dual.regularised);
        Ok(())
    }

    /// v̇ where the bench was placed.
    #[inline(always)]
    pub(crate) fn acceleration<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &Bench<S, Q, N, R>,
        t: f64,
        q: &[f64; Q],
        v: &[f64; N],
    ) -> [f64; N] {
        let (system, node) = (&bench.system, &bench.node);
        let mut acceleration = free(system, &node.mass, t, q, v);
        if R == 0 {
            return acceleration;
        }
        system.constraint_rates(t, q, v, &mut Discard, &mut self.gamma);
        // A v̇ + 2α A v in one product.
        let along = std::array::from_fn(|i| acceleration[i] + self.damping * v[i]);
        let mut rates = [0.0; R];
        system.row_rates(&node.a, &along, &mut rates);
        for i in 0..R {
            self.lambda[i] = -(rates[i]
                + self.gamma[i]
                + self.damping * node.b[i]
                + self.stiffness * bench.phi[i]);
        }
        self.dual.solve(&mut self.lambda);
        accumulate(&mut acceleration, &node.w, &self.lambda);
        acceleration
    }
}

/// M⁻¹(f − Γvv), the acceleration without rows.
#[inline(always)]
pub(crate) fn free<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    mass: &S::Mass,
    t: f64,
    q: &[f64; Q],
    v: &[f64; N],
) -> [f64; N] {
    let mut result = [0.0; N];
    if S::STRUCTURE.constant_mass && !S::STRUCTURE.velocity_forces && S::ROTATIONS.is_empty() {
        system.acceleration(t, q, &mut result);
        return result;
    }
    system.forces(t, q, v, &mut result);
    if !S::STRUCTURE.constant_mass {
        // ṗ = M v̇ + (∂p/∂q) v.
        let mut change = Product {
            v,
            result: &mut result,
        };
        system.force_tangents(t, q, v, &mut Discard, &mut Discard, &mut change);
    }
    system.solve_mass(mass, &mut result);
    result
}

/// Subtracts the product of the matrix written to it and v.
struct Product<'a, const N: usize> {
    v: &'a [f64; N],
    result: &'a mut [f64; N],
}

impl<const N: usize> MatrixSink for Product<'_, N> {
    #[inline(always)]
    fn set(&mut self, row: usize, column: usize, value: f64) {
        self.result[row] -= value * self.v[column];
    }
}
