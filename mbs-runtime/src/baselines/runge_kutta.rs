//! Explicit Runge–Kutta steps of the equations at acceleration level.
//!
//! Velocities are integrated as they are. Positions go through increments θ in the tangent space at the start of the step,
//! q = q₀ ⊕ θ with θ̇ = T(θ)⁻¹ v (Munthe-Kaas, Appl. Numer. Math. 29, 1999, 115–127): θ̇ = v but for rotations.

use super::bench::Bench;
use super::index1::Index1;
use super::tableau::Tableau;
use crate::System;
use crate::fault::Fault;
use crate::flow::unroll;
use crate::linear::{add_scaled, added, scaled};
use nalgebra::SVector;

/// Room for the stages of a step.
#[derive(Clone)]
pub(crate) struct RungeKutta<const Q: usize, const N: usize> {
    pub(crate) tableau: &'static Tableau,
    /// θ̇ and v̇ of each stage.
    slopes: Box<[[SVector<f64, N>; 2]]>,
}

/// Where a step ends.
pub(crate) struct End<const Q: usize, const N: usize> {
    pub(crate) q: SVector<f64, Q>,
    pub(crate) v: SVector<f64, N>,
}

impl<const Q: usize, const N: usize> RungeKutta<Q, N> {
    pub(crate) fn new(tableau: &'static Tableau) -> Self {
        RungeKutta {
            tableau,
            slopes: vec![[SVector::zeros(); 2]; tableau.nodes.len()].into_boxed_slice(),
        }
    }

    /// A step of h from the state of the bench.
    #[inline]
    pub(crate) fn step<S: System<Q, N, R>, const R: usize>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        equations: &mut Index1<N, R>,
        h: f64,
    ) -> Result<End<Q, N>, Fault> {
        let (t0, q0, v0) = (
            bench.state.time,
            bench.state.positions,
            bench.state.velocities,
        );
        let tableau = self.tableau;
        for stage in 0..tableau.nodes.len() {
            let t = t0 + tableau.nodes[stage] * h;
            let (mut turn, mut q, mut v) = (SVector::zeros(), q0, v0);
            if stage > 0 {
                self.combine(tableau.stages[stage - 1], h, &mut turn, &mut v);
                q = bench.system.advance(&q0, &turn, 1.0);
            }
            let acceleration = equations.evaluate(bench, t, &q, &v)?;
            let weight = h * tableau.weights[stage];
            bench.add_works(weight, bench.powers(t, &q, &v, &equations.lambda));
            unroll::<S, Q, N, R>(&turn, &mut v);
            self.slopes[stage] = [v, acceleration];
        }
        let (mut turn, mut v) = (SVector::zeros(), v0);
        self.combine(tableau.weights, h, &mut turn, &mut v);
        let q = bench.system.advance(&q0, &turn, 1.0);
        Ok(End { q, v })
    }

    /// v̇ where the last step began.
    pub(crate) fn first_acceleration(&self) -> &SVector<f64, N> {
        &self.slopes[0][1]
    }

    /// h Σ (b − b̂)_i k_i of the last step: what its error in θ and v may be.
    pub(crate) fn error(&self, h: f64) -> [SVector<f64, N>; 2] {
        let [mut turn, mut change] = [SVector::zeros(); 2];
        self.combine(self.tableau.error, h, &mut turn, &mut change);
        [turn, change]
    }

    /// An estimate of the error of the last step, as that of the code DOP853 (Hairer, Nørsett, Wanner: Solving Ordinary
    /// Differential Equations I, II.10), e₅²/√(e₅² + e₃²/100), with `size` of a change of θ and v; `None` where the method
    /// has none.
    pub(crate) fn estimate(
        &self,
        h: f64,
        size: impl Fn(&SVector<f64, N>, &SVector<f64, N>) -> f64,
    ) -> Option<f64> {
        let [fifth, third] = self.tableau.embedded?.map(|differences| {
            let [mut turn, mut change] = [SVector::zeros(); 2];
            self.combine(differences, h, &mut turn, &mut change);
            size(&turn, &change)
        });
        let both = (fifth * fifth + 0.01 * third * third).sqrt();
        Some(if both > 0.0 {
            fifth * fifth / both
        } else {
            0.0
        })
    }

    /// θ and v ← + h Σ c_j k_j.
    #[inline(always)]
    fn combine(
        &self,
        coefficients: &[f64],
        h: f64,
        turn: &mut SVector<f64, N>,
        v: &mut SVector<f64, N>,
    ) {
        for (c, [rate, acceleration]) in coefficients.iter().zip(&*self.slopes) {
            if *c != 0.0 {
                add_scaled(turn, h * c, rate);
                add_scaled(v, h * c, acceleration);
            }
        }
    }
}

/// The classical step of order 4, with its sums written out.
#[inline]
pub(crate) fn classical<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    bench: &mut Bench<S, Q, N, R>,
    equations: &mut Index1<N, R>,
    h: f64,
) -> Result<End<Q, N>, Fault> {
    let (t0, q0, v0) = (
        bench.state.time,
        bench.state.positions,
        bench.state.velocities,
    );
    let mut slope = [v0, equations.evaluate(bench, t0, &q0, &v0)?];
    bench.add_works(h / 6.0, bench.powers(t0, &q0, &v0, &equations.lambda));
    let mut sum = slope;
    for (c, weight) in [(0.5, 2.0), (0.5, 2.0), (1.0, 1.0)] {
        let (t, step) = (t0 + c * h, c * h);
        let turn = scaled(step, &slope[0]);
        let mut v = added(&v0, step, &slope[1]);
        let q = bench.system.advance(&q0, &turn, 1.0);
        let acceleration = equations.evaluate(bench, t, &q, &v)?;
        let powers = bench.powers(t, &q, &v, &equations.lambda);
        bench.add_works(weight * h / 6.0, powers);
        unroll::<S, Q, N, R>(&turn, &mut v);
        slope = [v, acceleration];
        add_scaled(&mut sum[0], weight, &v);
        add_scaled(&mut sum[1], weight, &acceleration);
    }
    Ok(End {
        q: bench.system.advance(&q0, &sum[0], h / 6.0),
        v: added(&v0, h / 6.0, &sum[1]),
    })
}
