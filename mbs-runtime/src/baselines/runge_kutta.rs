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
use crate::linear::{add_scaled, added, array, entries, scaled};
use nalgebra::SVector;

/// Room for the stages of a step.
#[derive(Clone)]
pub(crate) struct RungeKutta<const Q: usize, const N: usize> {
    pub(crate) tableau: &'static Tableau,
    /// θ̇ and v̇ of each stage.
    slopes: Box<[[[f64; N]; 2]]>,
    /// What is not zero of a, by stages from the second on, and of b: stages and coefficients.
    sums: Box<[Terms]>,
    /// The same of the embedded methods.
    error: Terms,
    embedded: Option<[Terms; 2]>,
}

/// Stages and their coefficients.
type Terms = Box<[(usize, f64)]>;

/// Stages that are added to an entry while it is in a register.
const SEVERAL: usize = 4;

/// Where a step ends.
pub(crate) struct End<const Q: usize, const N: usize> {
    pub(crate) q: SVector<f64, Q>,
    pub(crate) v: SVector<f64, N>,
}

impl<const Q: usize, const N: usize> RungeKutta<Q, N> {
    pub(crate) fn new(tableau: &'static Tableau) -> Self {
        let sums = tableau.stages.iter().copied().chain([tableau.weights]);
        RungeKutta {
            tableau,
            slopes: vec![[[0.0; N]; 2]; tableau.nodes.len()].into_boxed_slice(),
            sums: sums.map(terms).collect(),
            error: terms(tableau.error),
            embedded: tableau.embedded.map(|two| two.map(terms)),
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
                [turn, v] = self.combine(&self.sums[stage - 1], h, &v0);
                q = bench.system.advance(&q0, &turn, 1.0);
            }
            let acceleration = equations.evaluate(bench, t, &q, &v)?;
            let weight = h * tableau.weights[stage];
            bench.add_works(weight, bench.powers(t, &q, &v, &equations.lambda));
            unroll::<S, Q, N, R>(&turn, &mut v);
            self.slopes[stage] = [*entries(&v), *entries(&acceleration)];
        }
        let [turn, v] = self.combine(&self.sums[tableau.stages.len()], h, &v0);
        let q = bench.system.advance(&q0, &turn, 1.0);
        Ok(End { q, v })
    }

    /// v̇ where the last step began.
    pub(crate) fn first_acceleration(&self) -> SVector<f64, N> {
        SVector::from(self.slopes[0][1])
    }

    /// h Σ (b − b̂)_i k_i of the last step: what its error in θ and v may be.
    pub(crate) fn error(&self, h: f64) -> [SVector<f64, N>; 2] {
        self.combine(&self.error, h, &SVector::zeros())
    }

    /// An estimate of the error of the last step, as that of the code DOP853 (Hairer, Nørsett, Wanner: Solving Ordinary
    /// Differential Equations I, II.10), e₅²/√(e₅² + e₃²/100), with `size` of a change of θ and v; `None` where the method
    /// has none.
    pub(crate) fn estimate(
        &self,
        h: f64,
        size: impl Fn(&SVector<f64, N>, &SVector<f64, N>) -> f64,
    ) -> Option<f64> {
        let [fifth, third] = self.embedded.as_ref()?.each_ref().map(|differences| {
            let [turn, change] = self.combine(differences, h, &SVector::zeros());
            size(&turn, &change)
        });
        let both = (fifth * fifth + 0.01 * third * third).sqrt();
        Some(if both > 0.0 {
            fifth * fifth / both
        } else {
            0.0
        })
    }

    /// 0 and v₀ + h Σ c_j k_j.
    #[inline(always)]
    fn combine(
        &self,
        terms: &[(usize, f64)],
        h: f64,
        v0: &SVector<f64, N>,
    ) -> [SVector<f64, N>; 2] {
        let mut ends = [[0.0; N], *entries(v0)];
        let several = terms.chunks_exact(SEVERAL);
        let rest = several.remainder();
        for terms in several {
            self.add::<SEVERAL>(terms, h, &mut ends);
        }
        for term in rest.chunks_exact(1) {
            self.add::<1>(term, h, &mut ends);
        }
        ends.map(SVector::from)
    }

    /// Adds K terms, one after the other, to each entry.
    #[inline(always)]
    fn add<const K: usize>(&self, terms: &[(usize, f64)], h: f64, ends: &mut [[f64; N]; 2]) {
        let factors: [f64; K] = array(|k| h * terms[k].1);
        let slopes: [&[[f64; N]; 2]; K] = std::array::from_fn(|k| &self.slopes[terms[k].0]);
        for part in 0..2 {
            for i in 0..N {
                let mut sum = ends[part][i];
                for k in 0..K {
                    sum += factors[k] * slopes[k][part][i];
                }
                ends[part][i] = sum;
            }
        }
    }
}

/// The coefficients that are not zero.
fn terms(coefficients: &[f64]) -> Terms {
    let all = coefficients.iter().copied().enumerate();
    all.filter(|&(_, c)| c != 0.0).collect()
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
