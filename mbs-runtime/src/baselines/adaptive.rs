//! Baumgarte's form with error control: the pair of Dormand and Prince of orders 5 and 4.
//!
//! No published crate fits these equations: the available ones allocate in each step or need their own vector type,
//! and none supports quaternions. The pair is the one they all offer, with the controller of Hairer, Nørsett, Wanner:
//! Solving Ordinary Differential Equations I, II.4 and IV.2 (Gustafsson).

use super::bench::Bench;
use super::index1::Index1;
use super::rule::{AnyRule, Rule};
use super::runge_kutta::{FirstStage, RungeKutta};
use super::tableau::DORMAND_PRINCE5;
use crate::fault::Fault;
use crate::scalar_state;
use crate::{Method, Settings, System};
use nalgebra::SVector;

const SAFETY: f64 = 0.9;
/// Most and least change of a step.
const CHANGES: [f64; 2] = [0.2, 10.0];
/// β of the PI controller; the exponent of the error is −1/5 + 0.75 β.
const BETA: f64 = 0.04;
/// A step below this fraction of the given one is an error.
const SMALLEST: f64 = 1e-9;

#[derive(Clone)]
pub(crate) struct Adaptive<const Q: usize, const N: usize, const R: usize> {
    equations: Index1<N, R>,
    stages: RungeKutta<Q, N>,
    tolerance: f64,
    /// Error of the last accepted step, in tolerances.
    last: f64,
    /// The stage in which the next step begins, the last one of the step before or the first of one that was refused. (The
    /// stages of the pair end where the step does.)
    first: Option<FirstStage<N>>,
}

impl<const Q: usize, const N: usize, const R: usize> Adaptive<Q, N, R> {
    /// Baumgarte's method with a tolerance.
    pub(crate) fn rule<S: System<Q, N, R>>(
        bench: &Bench<S, Q, N, R>,
        settings: &Settings,
    ) -> Option<Result<AnyRule<S, Q, N, R>, Fault>> {
        let Method::Baumgarte(settings) = &settings.method else {
            return None;
        };
        Some(Ok(Box::new(Adaptive {
            equations: Index1::planned(bench, settings.gain),
            stages: RungeKutta::new(&DORMAND_PRINCE5),
            tolerance: settings.adaptive?,
            last: 1e-4,
            first: None,
        })))
    }

    /// Tries a step; returns its error in tolerances. It is taken if that is at most one.
    fn try_step<S: System<Q, N, R>>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        h: f64,
    ) -> Result<f64, Fault> {
        self.equations.begin();
        let known = u64::from(self.first.is_some());
        let (equations, first) = (&mut self.equations, &mut self.first);
        let end = self
            .stages
            .step_from::<S, R, true>(bench, equations, h, first)?;
        bench.counters.stages += DORMAND_PRINCE5.nodes.len() as u64 - known;
        let [turn, change] = self.stages.error(h);
        let (q, v) = (bench.state.positions, bench.state.velocities);
        let yardstick = &bench.yardstick;
        // At rest, the speed that the acceleration gives in the step, and that which moves no position.
        let gained = h.abs() * yardstick.measure(&self.stages.first_acceleration());
        let noise = yardstick.imperceptible(&q, h) / self.tolerance;
        let speed = yardstick.measure(&v).max(gained).max(noise);
        let scales = [yardstick.farthest(&q), speed];
        let square = |x: &SVector<f64, N>, scale: f64| match scale > 0.0 {
            true => yardstick.square(x) / (scale * scale),
            false => 0.0,
        };
        let states = scalar_state::square(bench.system.states(), &change, &v);
        let sum = square(&turn, scales[0]) + square(&change, scales[1]) + states;
        let error = (sum / (2 * N).max(1) as f64).sqrt() / self.tolerance;
        if error <= 1.0 {
            let t = bench.state.time + h;
            let next = self.stages.last_stage(bench, &self.equations, (t, &end));
            bench.commit(t, end.q, end.v, false)?;
            self.first = next;
        }
        Ok(if error.is_nan() { f64::INFINITY } else { error })
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Rule<S, Q, N, R>
    for Adaptive<Q, N, R>
{
    fn refresh(&mut self) {
        self.first = None;
    }

    /// In steps of its own. The length of the next one is kept in the state.
    fn advance(&mut self, bench: &mut Bench<S, Q, N, R>, h: f64) -> Result<(), Fault> {
        let end = bench.state.time + h;
        let mut left = h;
        let mut size = match bench.state.fields.step {
            kept if kept > 0.0 => kept,
            _ => h.abs(),
        };
        while left.abs() > SMALLEST * h.abs() {
            let whole = size >= left.abs();
            let trial = if whole { left } else { size.copysign(h) };
            let before = bench.works;
            // If M is not positive definite or values overflow in a trial, the step was too long.
            let error = self.try_step(bench, trial).unwrap_or(f64::INFINITY);
            let exponent = 0.2 - 0.75 * BETA;
            if error <= 1.0 {
                let factor = SAFETY * error.max(1e-10).powf(-exponent) * self.last.powf(BETA);
                let next = trial.abs() * factor.clamp(CHANGES[0], CHANGES[1]);
                // A step that was shortened to end at a given time does not change the planned length.
                size = if whole { size.max(next) } else { next };
                self.last = error.max(1e-4);
                left -= trial;
            } else {
                bench.works = before;
                bench.counters.rejected += 1;
                let factor = SAFETY * error.powf(-exponent);
                let factor = if factor > CHANGES[0] {
                    factor
                } else {
                    CHANGES[0]
                };
                size = trial.abs() * factor.min(0.9);
                if size < SMALLEST * h.abs() {
                    return Err(Fault::Underflow {
                        row: None,
                        step: trial,
                    });
                }
            }
        }
        bench.state.time = end;
        bench.state.fields.step = size;
        Ok(())
    }
}
