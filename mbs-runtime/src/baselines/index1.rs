//! The equations at acceleration level (index 1): M v̇ + Γvv = f + Aᵀλ, A v̇ + γ = 0.

use super::bench::Bench;
use crate::System;
use crate::alf3f::Fault;
use crate::free::free;
use crate::linear::{Independence, SymmetricDual, accumulate};
use crate::sink::Discard;

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
    weakness: [f64; R],
    /// The least and the largest 1/σ² of the evaluations since [`Self::begin`], with the smallest singular value σ of the
    /// rows.
    range: [f64; 2],
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
            weakness: [0.0; R],
            range: [f64::INFINITY, 0.0],
        }
    }

    /// A step begins.
    pub(crate) fn begin(&mut self) {
        self.range = [f64::INFINITY, 0.0];
    }

    /// The smallest σ of the evaluations since [`Self::begin`] as a fraction of the largest: near 0 if one of them was
    /// beside a singular pose. What the intermediate states of a step violate of A v = 0 acts there as 1/σ².
    pub(crate) fn clearance(&self) -> f64 {
        let [least, most] = self.range;
        if most > 0.0 {
            (least / most).sqrt()
        } else {
            f64::INFINITY
        }
    }

    #[inline(always)]
    fn note(&mut self, inverse_square: f64) {
        let [least, most] = &mut self.range;
        *least = least.min(inverse_square);
        *most = most.max(inverse_square);
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
            let (system, weakness) = (&bench.system, &mut self.weakness);
            let (into, lambda) = (&mut acceleration, &mut self.lambda);
            if system.accelerations(t, q, v, &correction, into, lambda, weakness) {
                let mut most: f64 = 0.0;
                for &weakness in &*weakness {
                    let lost = weakness == 0.0;
                    most = most.max(if lost { f64::INFINITY } else { weakness });
                }
                if R > 0 {
                    self.note(most);
                }
                return Ok(acceleration);
            }
        }
        self.place(bench, t, q)?;
        if let Some(now) = self.independence(bench) {
            self.note(1.0 / (now.least * now.least));
        }
        Ok(self.acceleration(bench, t, q, v))
    }

    /// How independent the holonomic rows are where the bench was placed; `None` without such rows.
    pub(crate) fn independence<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &Bench<S, Q, N, R>,
    ) -> Option<Independence> {
        let rows = S::STRUCTURE.holonomic_rows;
        (rows > 0).then(|| self.dual.independence(&bench.node.gram, rows))
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
