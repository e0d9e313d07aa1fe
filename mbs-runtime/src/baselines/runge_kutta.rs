//! Explicit Runge–Kutta steps of the equations at acceleration level.
//!
//! Velocities are integrated as they are. Positions go through increments θ in the tangent space at the start of the step,
//! q = q₀ ⊕ θ with θ̇ = T(θ)⁻¹ v (Munthe-Kaas, Appl. Numer. Math. 29, 1999, 115–127): θ̇ = v but for rotations.

use super::bench::Bench;
use super::index1::Index1;
use super::stage_poses::StagePoses;
use super::tableau::Tableau;
use crate::System;
use crate::estimate::Estimate;
use crate::fault::Fault;
use crate::flow::unroll;
use crate::linear::{add_scaled, added, array, entries, entries_mut, scaled};
use nalgebra::SVector;

/// The part of e₃ that e₅ exceeds where a force jumps or bends. There it was 0.3 to 2, in smooth motion 0.06 at most (three
/// mechanisms at accuracies of 1e-2 to 1e-7, but for one step).
const ROUGH: f64 = 0.1;

/// Room for the stages of a step.
#[derive(Clone)]
pub(crate) struct RungeKutta<const Q: usize, const N: usize> {
    pub(crate) tableau: &'static Tableau,
    /// θ̇ and v̇ of each stage.
    slopes: Box<[[[f64; N]; 2]]>,
    /// The power of forces without potential in each stage that has a weight, W, of driven mechanisms.
    powers: Box<[f64]>,
    /// a from the second stage on, and b.
    sums: Box<[Sum]>,
    /// The differences of the embedded method, …
    error: Sum,
    /// … and of those of orders 5 and 3.
    embedded: Option<Embedded>,
    /// How near the stages of the last step were to singular poses.
    pub(crate) poses: StagePoses,
}

/// Σ c_j k_j over the first stage and a range of others: stages that a sum leaves out come next to the first.
#[derive(Clone)]
struct Sum {
    first: f64,
    from: usize,
    others: Box<[f64]>,
}

impl Sum {
    fn new(coefficients: &[f64]) -> Self {
        let used = |&j: &usize| coefficients[j] != 0.0;
        let mut others = 1..coefficients.len().max(1);
        let from = others.clone().find(used).unwrap_or(others.end);
        let end = others.rfind(used).map_or(from, |last| last + 1);
        Sum {
            first: coefficients.first().copied().unwrap_or(0.0),
            from,
            others: coefficients.get(from..end).unwrap_or_default().into(),
        }
    }
}

/// Two sums over the same stages.
#[derive(Clone)]
struct Embedded {
    stages: [usize; MOST],
    factors: [[f64; 2]; MOST],
}

impl Embedded {
    fn new([one, other]: [&[f64]; 2]) -> Self {
        let all = one.iter().zip(other).map(|(&one, &other)| [one, other]);
        let used = all.enumerate().filter(|(_, both)| *both != [0.0; 2]);
        let (mut stages, mut factors) = ([0; MOST], [[0.0; 2]; MOST]);
        for (term, (stage, both)) in used.enumerate() {
            (stages[term], factors[term]) = (stage, both);
        }
        Embedded { stages, factors }
    }
}

/// Stages beside the first in the longest sum, that of order 8.
const MOST: usize = 8;

/// What is known where a step begins.
#[derive(Clone, Copy)]
pub(crate) struct FirstStage<const N: usize> {
    acceleration: SVector<f64, N>,
    powers: [f64; 2],
}

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
            powers: vec![0.0; tableau.nodes.len()].into_boxed_slice(),
            sums: sums.map(Sum::new).collect(),
            error: Sum::new(tableau.error),
            embedded: tableau.embedded.map(Embedded::new),
            poses: StagePoses::new(tableau.nodes),
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
        self.step_from::<S, R, false>(bench, equations, h, &mut None)
    }

    /// The same, with the first stage if it is known; it is afterwards. `KEEPS` says whether there is such a stage: other
    /// methods do not copy it.
    #[inline]
    pub(crate) fn step_from<S: System<Q, N, R>, const R: usize, const KEEPS: bool>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        equations: &mut Index1<N, R>,
        h: f64,
        first: &mut Option<FirstStage<N>>,
    ) -> Result<End<Q, N>, Fault> {
        let (t0, q0, v0) = (
            bench.state.time,
            bench.state.positions,
            bench.state.velocities,
        );
        let tableau = self.tableau;
        let stages = tableau.nodes.iter().zip(tableau.weights);
        let (mut turn, mut q, mut v) = (SVector::zeros(), q0, v0);
        if R > 0 {
            self.poses.begin();
        }
        for (stage, (&node, &weight)) in stages.enumerate() {
            let t = t0 + node * h;
            let acceleration = match first {
                Some(first) if const { KEEPS } && stage == 0 => {
                    self.powers[stage] = first.powers[0];
                    bench.add_works(h * weight, first.powers);
                    first.acceleration
                }
                _ => {
                    let acceleration = equations.evaluate(bench, t, &q, &v)?;
                    if R > 0 {
                        self.poses.note(stage, equations.last);
                    }
                    if weight != 0.0 {
                        let powers = bench.powers(t, &q, &v, &equations.lambda);
                        bench.add_works(h * weight, powers);
                        if const { S::STRUCTURE.rheonomic } {
                            self.powers[stage] = powers[0];
                        }
                        if const { KEEPS } && stage == 0 {
                            *first = Some(FirstStage {
                                acceleration,
                                powers,
                            });
                        }
                    }
                    acceleration
                }
            };
            unroll::<S, Q, N, R>(&turn, &mut v);
            self.slopes[stage] = [*entries(&v), *entries(&acceleration)];
            self.combine(&self.sums[stage], h, &v0, [&mut turn, &mut v]);
            q = bench.system.advance(&q0, &turn, 1.0);
        }
        Ok(End { q, v })
    }

    /// The last stage as the first one of the next step: where the method ends at its last stage.
    pub(crate) fn last_stage<S: System<Q, N, R>, const R: usize>(
        &self,
        bench: &Bench<S, Q, N, R>,
        equations: &Index1<N, R>,
        (t, end): (f64, &End<Q, N>),
    ) -> Option<FirstStage<N>> {
        let [_, acceleration] = self.slopes.last()?;
        Some(FirstStage {
            acceleration: SVector::from(*acceleration),
            powers: bench.powers(t, &end.q, &end.v, &equations.lambda),
        })
    }

    /// v̇ where the last step began.
    pub(crate) fn first_acceleration(&self) -> SVector<f64, N> {
        SVector::from(self.slopes[0][1])
    }

    /// h Σ (b − b̂)_i k_i of the last step: what its error in θ and v may be.
    pub(crate) fn error(&self, h: f64) -> [SVector<f64, N>; 2] {
        let [mut turn, mut change] = [SVector::zeros(); 2];
        self.combine(&self.error, h, &SVector::zeros(), [&mut turn, &mut change]);
        [turn, change]
    }

    /// An estimate of the error of the last step, which was one of h, in sizes of the mechanism and radians, with `size` of rates of
    /// θ and v, in sizes and radians a second; `None` where the method has none.
    ///
    /// ```text
    /// h e₅ · max((h e₅)^⅓, min(1, 10 e₅/e₃)^(3/2))
    /// ```
    ///
    /// with the differences e₅ and e₃ of the embedded methods of the code DOP853 (Hairer, Nørsett, Wanner: Solving Ordinary
    /// Differential Equations I, II.10), which vary as h⁵ and h³. In smooth motion the first term counts, and the estimate varies
    /// as h⁸. Where e₅ is not small beside e₃ the step is long for the fastest parts of the motion, and the error is hardly less than
    /// h e₅. (In ten scenes at tolerances of 1e-2 to 1e-8, log₂ of the ratio of error and estimate has a standard deviation of 1.1; with
    /// the estimate of DOP853, h e₅²/√(e₅² + e₃²/100), it has 1.3. Of the exponents 1.25 to 1.5 in the place of 4/3 none is better.)
    ///
    /// The first term is not proportional to the motion: where this is smaller than the mechanism by a factor a, the ratio of error and
    /// estimate is larger by a^(−⅓). Comparisons find it.
    ///
    /// No comparison is made for the error of the work of forces without potential: it has the estimate of DOP853.
    pub(crate) fn estimate(
        &self,
        h: f64,
        size: impl Fn(&SVector<f64, N>, &SVector<f64, N>) -> f64,
    ) -> Option<Estimate> {
        let Embedded { stages, factors } = self.embedded.as_ref()?;
        let (mut sums, mut powers) = ([[[0.0; N]; 2]; 2], [0.0; 2]);
        for (&stage, [one, other]) in stages.iter().zip(factors) {
            let slope = &self.slopes[stage];
            powers[0] += one * self.powers[stage];
            powers[1] += other * self.powers[stage];
            for part in 0..2 {
                for i in 0..N {
                    sums[0][part][i] += one * slope[part][i];
                    sums[1][part][i] += other * slope[part][i];
                }
            }
        }
        let [fifth, third] = sums.map(|[turn, change]| size(&turn.into(), &change.into()));
        let error = h * fifth;
        // At rest 0/0 is not a number, of which `min` makes 1: the estimate is zero.
        let roughness = (fifth / (ROUGH * third)).min(1.0);
        let [fifth_power, third_power] = powers;
        let power = fifth_power * fifth_power / fifth_power.hypot(ROUGH * third_power);
        Some(Estimate {
            error: error * error.cbrt().max(roughness * roughness.sqrt()),
            // At rest 0/0 is not a number.
            work: if power > 0.0 { h * power } else { 0.0 },
            is_rough: fifth > ROUGH * third,
            of_states: [0.0; 2],
        })
    }

    /// θ = h Σ c_j θ̇_j and v₀ + h Σ c_j v̇_j. (Each entry stays in a register while the terms are added to it, one after the
    /// other: for this their number has to be known.)
    #[inline(always)]
    fn combine(&self, sum: &Sum, h: f64, v0: &SVector<f64, N>, into: [&mut SVector<f64, N>; 2]) {
        match sum.others.len() {
            0 => self.add::<0>(sum, h, v0, into),
            1 => self.add::<1>(sum, h, v0, into),
            2 => self.add::<2>(sum, h, v0, into),
            3 => self.add::<3>(sum, h, v0, into),
            4 => self.add::<4>(sum, h, v0, into),
            5 => self.add::<5>(sum, h, v0, into),
            6 => self.add::<6>(sum, h, v0, into),
            7 => self.add::<7>(sum, h, v0, into),
            _ => self.add::<MOST>(sum, h, v0, into),
        }
    }

    /// [`Self::combine`] with K stages beside the first.
    #[inline(always)]
    fn add<const K: usize>(
        &self,
        sum: &Sum,
        h: f64,
        v0: &SVector<f64, N>,
        [turn, v]: [&mut SVector<f64, N>; 2],
    ) {
        let (first, others) = (&self.slopes[0], &self.slopes[sum.from..][..K]);
        let coefficients = &sum.others[..K];
        let scale = h * sum.first;
        let scales: [f64; K] = array(|k| h * coefficients[k]);
        let entry = |start: f64, part: usize, i: usize| {
            let mut entry = start + scale * first[part][i];
            for k in 0..K {
                entry += scales[k] * others[k][part][i];
            }
            entry
        };
        for (i, turned) in entries_mut(turn).iter_mut().enumerate() {
            *turned = entry(0.0, 0, i);
        }
        let starts = entries(v0).iter().zip(entries_mut(v));
        for (i, (&start, end)) in starts.enumerate() {
            *end = entry(start, 1, i);
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
