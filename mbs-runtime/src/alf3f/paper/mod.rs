//! Algorithm 1 of the paper, to the letter: three fields, penalties in the primal, halving of the step.
//!
//! Linear shape functions in time and the trapezoidal rule turn (26)–(31) into, per step,
//!
//! ```text
//! η(v₁) = M₁v₁ − A₁ᵀM̄μ̄ − π₀ − h/2 (F₀ + F₁) = 0,    μ̄ = μ − Ξψ̇,  λ̄ = λ − Ξφ     (74), (75)
//! q₁ = q₀ ⊕ h/2 (v₀ + v₁),    λ₁ = λ₀ + h/2 (μ₀ + μ₁)                               (28), (29)
//! ```
//!
//! The impulse of a row over a step is that of the last term of (21), [M̄μ] + h/2 Σ (c̄μ + k̄λ − f̄).
//!
//! The modified augmented Lagrangian (M-ALF) that section 7.2 compares with is the same algorithm with other
//! coefficients ([`RowMotion::Static`]). The force of its rows depends on λ alone. So λ₁ is updated with μ₁ within
//! Newton's method, multipliers are never reset, and the first ones are those of the equations at acceleration level.
//! The term Ξφ of λ̄ is left out: as ψ̇ = 0 is the condition, it would only shift λ.
//!
//! The numbers in the comments are the lines of Algorithm 1. At singular poses the impulse acts along the row of
//! mid-step and the row is tested at the end of the step: with tight tolerances or long steps no multiplier satisfies it.

mod residual;
mod rows;
mod start;

use nalgebra::SVector;
use std::fmt;

use self::rows::{Instant, Jacobian, RowMotion, Unknowns};
use self::start::Origin;
use super::closing;
use super::step_context::Counters;
use crate::PaperSettings;
use crate::fault::Fault;
use crate::flow::trapezoid;
use crate::linear::{Pivoted, finite, largest, vector};
use crate::yardstick::Yardstick;
use crate::{Method, Settings, SimulationError, State, System};

/// The integrator of the paper by itself.
#[derive(Clone)]
pub struct PaperStepper<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    pub(crate) system: S,
    pub(crate) state: State<Q, N, R>,
    settings: PaperSettings,
    start: Box<Instant<S, Q, N, R>>,
    end: Box<Instant<S, Q, N, R>>,
    jacobian: Box<(Jacobian<N>, Pivoted<N>)>,
    motion: RowMotion,
    yardstick: Box<Yardstick<Q, N>>,
    /// Impulse of each row during the last step, N s.
    impulse: SVector<f64, R>,
    /// The length of that step, s.
    length: f64,
    /// Work of each row against b during it, J.
    drive: SVector<f64, R>,
    counters: Counters,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> PaperStepper<S, Q, N, R> {
    /// An integrator that starts from `state`, which has to satisfy the constraints.
    ///
    /// # Errors
    /// Settings that cannot be used, or a mass matrix that is not positive definite at the state.
    pub fn new(
        system: S,
        state: State<Q, N, R>,
        settings: &Settings,
    ) -> Result<Self, SimulationError> {
        settings.check()?;
        let (motion, paper) = match settings.method {
            Method::MAlf(paper) => (RowMotion::Static, paper),
            Method::Paper(paper) => (RowMotion::Own, paper),
            other => {
                return Err(SimulationError::OtherMethod {
                    method: other.name(),
                    wanted: "`Method::Paper` or `Method::MAlf`",
                });
            }
        };
        let instant = |system: &S| {
            Instant::new(system, &state.positions, motion)
                .map(Box::new)
                .map_err(|fault| {
                    SimulationError::from_fault(fault, S::MODEL, state.time, settings.step)
                })
        };
        let mut stepper = PaperStepper {
            start: instant(&system)?,
            end: instant(&system)?,
            jacobian: Box::new((Jacobian::new(), Pivoted::new())),
            motion,
            impulse: SVector::zeros(),
            length: 0.0,
            drive: SVector::zeros(),
            counters: Counters::default(),
            settings: paper,
            yardstick: Box::new(Yardstick::new(&system, settings.step)),
            system,
            state,
        };
        let time = stepper.state.time;
        stepper
            .refresh()
            .map_err(|fault| SimulationError::from_fault(fault, S::MODEL, time, settings.step))?;
        Ok(stepper)
    }

    /// Advances by h seconds, in smaller steps if Algorithm 1 halves them.
    ///
    /// # Errors
    /// [`SimulationError::StepUnderflow`] with the row that cannot be satisfied.
    pub fn step(&mut self, h: f64) -> Result<(), SimulationError> {
        self.advance(h)
            .map_err(|fault| SimulationError::from_fault(fault, S::MODEL, self.state.time, h))
    }

    /// The current state.
    pub fn state(&self) -> &State<Q, N, R> {
        &self.state
    }

    pub(crate) fn counters(&self) -> Counters {
        self.counters
    }

    pub(crate) fn drive(&self) -> SVector<f64, R> {
        self.drive
    }

    /// The mean forces of the rows over the last step; `None` before the first one.
    pub(crate) fn multipliers(&self) -> Option<SVector<f64, R>> {
        (self.length > 0.0).then(|| vector(|i| self.impulse[i] / self.length))
    }

    pub(crate) fn phi(&self) -> &SVector<f64, R> {
        &self.start.phi
    }

    /// A v + b now.
    pub(crate) fn rates(&self) -> SVector<f64, R> {
        self.start
            .geometry
            .velocity_rows(&self.system, &self.state.velocities)
    }

    /// Recomputes what is known of the current instant.
    pub(crate) fn refresh(&mut self) -> Result<(), Fault> {
        let State {
            time,
            positions,
            velocities,
            ..
        } = &self.state;
        self.start
            .place(&self.system, &self.settings, *time, positions, velocities)?;
        if self.state.fields.length == 0.0 && !self.state.fields.started {
            start::begin(&self.system, &mut self.start, self.motion, &mut self.state)?;
        }
        Ok(())
    }

    /// Lines 1 and 2 with the step control of the algorithm: the step is halved after a failure and doubled again after
    /// a success.
    fn advance(&mut self, h: f64) -> Result<(), Fault> {
        Fault::check_length(h, false)?;
        let end = self.state.time + h;
        (self.impulse, self.drive) = (SVector::zeros(), SVector::zeros());
        self.length = h;
        self.state.fields.shortest = h;
        let mut left = h;
        let mut size = if self.state.fields.step > 0.0 {
            self.state.fields.step.min(h)
        } else {
            h
        };
        while left > 0.0 {
            // Steps are h/2ⁿ, so that sums of them meet the end exactly.
            let trial = size.min(left);
            match self.try_step(trial) {
                Ok(()) => {
                    let fields = &mut self.state.fields;
                    // The remainder of the nominal step may be shorter.
                    fields.shortest = fields.shortest.min(size);
                    left -= trial;
                    if left < 1e-9 * h {
                        left = 0.0;
                        self.state.time = end;
                    }
                    size = (2.0 * size).min(h);
                }
                Err(fault) => {
                    self.counters.rejected += 1;
                    size = 0.5 * trial;
                    if size < self.settings.smallest_step {
                        let row = match fault {
                            Fault::Row { row, .. } => Some(row),
                            Fault::Flow { .. } => None,
                            other => return Err(other),
                        };
                        return Err(Fault::Underflow { row, step: trial });
                    }
                }
            }
            self.state.fields.step = if size < h { size } else { 0.0 };
        }
        Ok(())
    }

    /// Algorithm 1 for one step.
    fn try_step(&mut self, h: f64) -> Result<(), Fault> {
        let settings = self.settings;
        let (t0, q0, v0) = (self.state.time, self.state.positions, self.state.velocities);
        let t1 = t0 + h;
        // 3, 4
        let origin = Origin::new(&self.system, &self.state, settings.carried_fields);
        let mut x = start::estimate(
            &self.system,
            &settings,
            self.motion,
            &self.state,
            &origin,
            h,
        );
        let force0 = self
            .start
            .total_force(&self.system, t0, &q0, &v0, &origin.mu, &origin.lambda);
        let known = vector(|i| origin.momentum[i] + 0.5 * h * force0[i]);
        let integrated = match self.motion {
            RowMotion::Own => S::STRUCTURE.holonomic_rows,
            RowMotion::Static => R,
        };
        let mut k = 0;
        // 6: outer loop
        self.end.place(&self.system, &settings, t1, &x.q, &x.v)?;
        loop {
            self.satisfy_rows(t1, h, &known, &mut x)?;
            // 30
            x.q = trapezoid(&self.system, &q0, &v0, &x.v, h);
            for i in 0..integrated {
                x.lambda[i] = origin.lambda[i] + 0.5 * h * (origin.mu[i] + x.mu[i]);
            }
            k += 1;
            // 32
            self.end.place(&self.system, &settings, t1, &x.q, &x.v)?;
            if k >= settings.min_updates && self.is_settled(t1, h, &known, &x) {
                break;
            }
            if k == settings.max_updates {
                return Err(self.worst_row(&x.v, k));
            }
        }

        // 33: π, σ
        let momentum = self.end.momentum(&self.system, &x.q, &x.v, &x.mu);
        if !finite(&x.v) || !finite(&x.q) || !finite(&momentum) {
            return Err(Fault::NonFinite("velocities"));
        }
        let rates = self.end.geometry.velocity_rows(&self.system, &x.v);
        for i in 0..R {
            let (start, end) = (&self.start, &self.end);
            let impulse = end.constraint_mass[i] * x.mu[i]
                - start.constraint_mass[i] * origin.mu[i]
                + 0.5
                    * h
                    * (start.row_force(i, &origin.mu, &origin.lambda)
                        + end.row_force(i, &x.mu, &x.lambda));
            self.impulse[i] += impulse;
            self.drive[i] -= 0.5 * impulse * (start.geometry.b[i] + end.geometry.b[i]);
        }
        let State {
            time,
            positions,
            velocities,
            fields,
            ..
        } = &mut self.state;
        (*time, *positions, *velocities) = (t1, x.q, x.v);
        fields.momentum = momentum;
        fields.constraint_momentum = vector(|i| self.end.constraint_mass[i] * rates[i]);
        fields.change = match self.motion {
            RowMotion::Own => vector(|i| x.mu[i] - origin.mu[i]),
            RowMotion::Static => vector(|i| x.lambda[i] - origin.lambda[i]),
        };
        fields.length = h;
        (fields.mu, fields.lambda, fields.penalty) = (x.mu, x.lambda, x.penalty);
        fields.started = true;
        std::mem::swap(&mut self.start, &mut self.end);
        self.counters.stages += 1;
        Ok(())
    }

    /// Lines 7–28 at fixed q₁: velocities and multipliers.
    fn satisfy_rows(
        &mut self,
        t1: f64,
        h: f64,
        known: &SVector<f64, N>,
        x: &mut Unknowns<Q, N, R>,
    ) -> Result<(), Fault> {
        let settings = self.settings;
        let tolerance = settings.velocity_tolerance;
        let mut before = self.defects(h, &x.v);
        for _ in 0..settings.max_augmentations {
            self.newton(t1, h, known, x)?;
            let rates = self.defects(h, &x.v);
            let augmentable = |i: usize| {
                rates[i].abs() <= tolerance
                    || rates[i].abs() <= settings.augmentation_ratio * before[i].abs()
            };
            // 15–27
            if (0..R).all(augmentable) {
                for i in 0..R {
                    let change = -x.penalty[i] * rates[i];
                    x.mu[i] += change;
                    if self.motion == RowMotion::Static {
                        x.lambda[i] += 0.5 * h * change;
                    }
                }
            } else {
                for i in (0..R).filter(|&i| !augmentable(i)) {
                    x.penalty[i] =
                        (settings.penalty_growth * x.penalty[i]).min(settings.max_penalty);
                }
            }
            before = rates;
            // 28
            if largest(&rates) <= tolerance {
                return Ok(());
            }
        }
        Err(self.worst_row(&x.v, settings.max_augmentations))
    }

    /// Lines 9–14: η(v₁) = 0.
    fn newton(
        &mut self,
        t1: f64,
        h: f64,
        known: &SVector<f64, N>,
        x: &mut Unknowns<Q, N, R>,
    ) -> Result<(), Fault> {
        let mut size = 0.0;
        for iterations in 0..self.settings.max_newton_iterations {
            let rates = self.defects(h, &x.v);
            let mu: SVector<f64, R> = vector(|r| x.mu[r] - x.penalty[r] * rates[r]);
            let lambda = self.lifted_lambda(h, x, &mu);
            let mut change = self.residual(t1, h, known, x, &mu, &lambda);
            let (jacobian, factors) = &mut *self.jacobian;
            self.end.jacobian(&self.system, t1, h, x, jacobian);
            // Also of forces that are not numbers, and of dampers that feed more than the masses take up.
            if !factors.factor(&jacobian.total) {
                return Err(Fault::Flow {
                    residual: f64::INFINITY,
                    iterations,
                });
            }
            factors.solve(&mut change);
            for n in 0..N {
                x.v[n] += change[n];
            }
            self.counters.iterations += 1;
            let tolerance = self.settings.newton_tolerance;
            let floor = self.yardstick.imperceptible(&x.q, h);
            let speed = self.yardstick.measure(&x.v);
            let whole = || speed.max(floor / tolerance);
            size = (self.yardstick).correction(self.system.states(), (&change, &x.v), whole);
            if size <= (tolerance * speed).max(floor) {
                return Ok(());
            }
            if !size.is_finite() {
                break;
            }
        }
        Err(Fault::Flow {
            residual: size,
            iterations: self.settings.max_newton_iterations,
        })
    }

    /// The row furthest from ψ̇ = 0.
    fn worst_row(&self, v: &SVector<f64, N>, iterations: usize) -> Fault {
        let rates = self.end.geometry.velocity_rows(&self.system, v);
        closing::not_converged(&rates, &SVector::repeat(1.0), iterations)
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> fmt::Debug
    for PaperStepper<S, Q, N, R>
{
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_struct("PaperStepper")
            .field("mechanism", &S::MODEL.name)
            .field("state", &self.state)
            .finish_non_exhaustive()
    }
}
