//! What all baselines work on.

use crate::alf3f::Counters;
use crate::constraint_geometry::ConstraintGeometry;
use crate::fault::Fault;
use crate::linear::finite;
use crate::sink::Discard;
use crate::yardstick::Yardstick;
use crate::{MatrixSink, State, System};
use nalgebra::SVector;

/// System, state, and the constraint geometry where the state is.
#[derive(Clone)]
pub(crate) struct Bench<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    pub(crate) system: S,
    pub(crate) state: State<Q, N, R>,
    pub(crate) geometry: Box<ConstraintGeometry<S, Q, N, R>>,
    /// φ at `geometry`.
    pub(crate) phi: SVector<f64, R>,
    /// Whether `geometry` and `phi` are those of `state`.
    pub(crate) settled: bool,
    /// Whether A and the metric are not needed: the method has planned eliminations, with arrays of their own.
    pub(crate) rows_alone: bool,
    pub(crate) counters: Counters,
    pub(crate) works: Works,
    /// λ of the last step, of methods that have such an unknown: at its end, of RATTLE the mean.
    pub(crate) multipliers: Option<SVector<f64, R>>,
    pub(crate) max_iterations: usize,
    pub(crate) yardstick: Box<Yardstick<Q, N>>,
}

/// Adds up the product of the matrix written to it and v.
struct Rates<'a, const N: usize, const R: usize> {
    v: &'a SVector<f64, N>,
    rates: SVector<f64, R>,
}

impl<const N: usize, const R: usize> MatrixSink for Rates<'_, N, R> {
    #[inline(always)]
    fn set(&mut self, row: usize, column: usize, value: f64) {
        self.rates[row] += value * self.v[column];
    }
}

/// Works of the last step, J.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Works {
    /// Of the forces without potential.
    pub(crate) nonconservative: f64,
    /// Of the rheonomic rows.
    pub(crate) drive: f64,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Bench<S, Q, N, R> {
    /// Evaluates φ and b, and A and the metric where they are needed, at the state, unless they are those already.
    pub(crate) fn settle(&mut self) -> Result<(), Fault> {
        if self.settled {
            return Ok(());
        }
        let State {
            time, positions, ..
        } = &self.state;
        let (geometry, phi) = (&mut self.geometry, &mut self.phi);
        if self.rows_alone {
            (self.system).constraints(*time, positions, phi, &mut Discard, &mut geometry.b);
        } else {
            geometry.evaluate(&self.system, *time, positions, phi)?;
        }
        self.settled = true;
        Ok(())
    }

    /// A v + b at the state.
    pub(crate) fn velocity_rows(&self) -> SVector<f64, R> {
        let State {
            time,
            positions,
            velocities,
            ..
        } = &self.state;
        if !self.rows_alone {
            return self.geometry.velocity_rows(&self.system, velocities);
        }
        let [mut phi, mut b] = [SVector::zeros(); 2];
        let mut rates = Rates {
            v: velocities,
            rates: SVector::zeros(),
        };
        (self.system).constraints(*time, positions, &mut phi, &mut rates, &mut b);
        rates.rates + b
    }

    /// The step ends here; `settled`: whether `geometry` and `phi` are those of its end.
    #[inline(always)]
    pub(crate) fn commit(
        &mut self,
        time: f64,
        q: SVector<f64, Q>,
        v: SVector<f64, N>,
        settled: bool,
    ) -> Result<(), Fault> {
        if !finite(&q) {
            return Err(Fault::NonFinite("positions"));
        }
        if !finite(&v) {
            return Err(Fault::NonFinite("velocities"));
        }
        let state = &mut self.state;
        (state.time, state.positions, state.velocities) = (time, q, v);
        self.settled = settled;
        Ok(())
    }

    /// Power of the forces without potential and of the rheonomic rows with multipliers λ, W, where `geometry` is.
    #[inline(always)]
    pub(crate) fn powers(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
        lambda: &SVector<f64, R>,
    ) -> [f64; 2] {
        let applied = self.system.nonconservative_power(t, q, v);
        let drive = if S::STRUCTURE.rheonomic {
            -crate::linear::dot(lambda, &self.geometry.b)
        } else {
            0.0
        };
        [applied, drive]
    }

    /// The works of a step by the trapezoidal rule, with the multipliers at its two ends; `geometry` is at the end.
    pub(crate) fn trapezoid_works(
        &mut self,
        t: f64,
        h: f64,
        start: (&SVector<f64, Q>, &SVector<f64, N>),
        end: (&SVector<f64, Q>, &SVector<f64, N>),
        lambda: [&SVector<f64, R>; 2],
    ) {
        let powers = self.powers(t + h, end.0, end.1, lambda[1]);
        self.add_works(0.5 * h, powers);
        if S::STRUCTURE.rheonomic && R > 0 {
            let b = self.geometry.b;
            self.system.constraints(
                t,
                start.0,
                &mut SVector::zeros(),
                &mut crate::sink::Discard,
                &mut self.geometry.b,
            );
            let powers = self.powers(t, start.0, start.1, lambda[0]);
            self.add_works(0.5 * h, powers);
            self.geometry.b = b;
        } else {
            let applied = self.system.nonconservative_power(t, start.0, start.1);
            self.add_works(0.5 * h, [applied, 0.0]);
        }
    }

    /// Adds a quadrature weight (s) times these powers to the works of the step.
    #[inline(always)]
    pub(crate) fn add_works(&mut self, weight: f64, [applied, drive]: [f64; 2]) {
        self.works.nonconservative += weight * applied;
        if const { S::STRUCTURE.rheonomic } {
            self.works.drive += weight * drive;
        }
    }
}
