//! Instants between steps.
//!
//! The state at an instant within a step is computed by a shorter step from its beginning. It has the order of the
//! method, satisfies the constraints, has an energy balance, and is continuous at the ends of the step. The steps
//! themselves do not depend on it.

use super::Simulation;
use super::fixed_steps::SHORTEST;
use crate::{AnySimulation, Foreseen, SimulationError, System};

/// An end of a step.
#[derive(Clone, Copy)]
enum From {
    Begin,
    End,
}

/// Ways to reach an instant, for instants and stages beside a singular pose: from which end of the step, and the
/// fraction of the time for a first separate step.
const WAYS: [(From, f64); 5] = [
    (From::Begin, 1.0),
    (From::End, 1.0),
    (From::Begin, 0.4),
    (From::End, 0.4),
    (From::Begin, 0.7),
];
/// Placement lengthens steps up to this factor; such a step is not divided.
const STRETCH: f64 = 1.2;

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// Takes whole steps until `time` is reached or passed, none of them beyond `latest`.
    ///
    /// [`Simulation::look_at`] then shows any instant of the last step.
    ///
    /// # Errors
    /// As [`Simulation::run_until`], which ends exactly at `time`.
    pub fn run_past(&mut self, time: f64, latest: f64) -> Result<(), SimulationError> {
        if time <= self.time() {
            return Ok(());
        }
        if time.is_nan() {
            self.check_target(time)?;
        }
        let latest = latest.max(time);
        self.check_target(latest)?;
        self.check_inputs()?;
        let end = self.end(latest);
        while self.time() < time
            && let Some(h) = self.next_step(end)
        {
            self.leave_behind();
            self.forward(h, self.left(latest))?;
        }
        self.land(end)
    }

    /// A whole step begins here.
    pub(super) fn leave_behind(&mut self) {
        self.last_step_start.copy_from(self.integrator.state());
        self.books.shortest = f64::INFINITY;
    }

    /// Computes the state at an instant of the last step, passes it to the callback, and restores the state.
    ///
    /// ```
    /// # use mbs_runtime::{Settings, Simulation, mechanism};
    /// mechanism!(Pendulum {
    ///     world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    ///     rod: Bar(mass = 1.0_kg, length = 0.5_m, angle = 0.0_deg),
    ///     pivot: Revolute(ground.origin, rod.a),
    /// });
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let settings = Settings { tolerance: Some(1e-6), order: 6, ..Settings::default() };
    /// let mut simulation = Simulation::with_settings(Pendulum {}, settings)?;
    /// for instant in 1..=100 {
    ///     let time = 0.01 * f64::from(instant);
    ///     simulation.run_past(time, 1.0)?;
    ///     simulation.look_at(time, &mut |simulation| assert_eq!(simulation.time(), time))?;
    /// }
    /// assert!(simulation.report().steps < 100);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// Methods with a memory besides the state ([`Method`](crate::Method)) are copied before, which allocates.
    ///
    /// # Errors
    /// A time that is not in the last step of [`Simulation::run_past`], or any but the present one after [`Simulation::step`],
    /// [`Simulation::run_until`] or a change of inputs: the last step then belongs to the motion with the old ones. Otherwise as
    /// [`Simulation::step`].
    pub fn look_at(
        &mut self,
        time: f64,
        look: &mut dyn FnMut(&dyn AnySimulation),
    ) -> Result<(), SimulationError> {
        let now = self.time();
        if time == now {
            look(self);
            return Ok(());
        }
        if !(time < now
            && time >= self.last_step_start.time
            && self.last_step_start.time.is_finite())
        {
            return Err(SimulationError::Time { now, wanted: time });
        }
        self.pair_end.copy_from(self.integrator.state());
        let kept = self.keep();
        let with_memory = self.memory();
        let longest = self.longest_part();
        let shown = self.show(time, longest);
        if shown.is_ok() {
            let state = self.integrator.state_mut();
            (state.time, state.clock) = (time, 0.0);
            look(self);
        }
        match with_memory {
            Some(integrator) => {
                self.integrator = integrator;
                self.put_back(kept);
            }
            None => {
                self.integrator.state_mut().copy_from(&self.pair_end);
                self.restore(kept)?;
            }
        }
        shown
    }

    /// Moves to an instant of the last step, by the first of the ways with enough clearance and a balance like that at the end of
    /// the step, otherwise by the best.
    fn show(&mut self, time: f64, longest: f64) -> Result<(), SimulationError> {
        let end = self.balance;
        let mut best = (f64::NEG_INFINITY, WAYS[0]);
        let mut error = None;
        for way in WAYS {
            match self.approach(time, way, longest) {
                Ok(clearance) => {
                    let imbalance = self.imbalance_since(&end);
                    if clearance >= self.clear() && imbalance <= 1.0 {
                        return Ok(());
                    }
                    let merit = if imbalance <= 1.0 {
                        clearance
                    } else {
                        -imbalance
                    };
                    if merit > best.0 {
                        best = (merit, way);
                    }
                }
                Err(other) => error = Some(other),
            }
        }
        match error {
            Some(error) if best.0 == f64::NEG_INFINITY => Err(error),
            _ => self.approach(time, best.1, longest).map(drop),
        }
    }

    /// To an instant of the last step on one of the [`WAYS`]; the least clearance on it.
    fn approach(
        &mut self,
        time: f64,
        (from, first): (From, f64),
        longest: f64,
    ) -> Result<f64, SimulationError> {
        let start = match from {
            From::Begin => &self.last_step_start,
            From::End => &self.pair_end,
        };
        let span = time - start.time;
        self.integrator.state_mut().copy_from(start);
        self.integrator.refresh(&self.settings)?;
        self.take_stock();
        let clearance = self.reach(first * span, longest)?;
        match first < 1.0 {
            true => Ok(self.reach((1.0 - first) * span, longest)?.min(clearance)),
            false => Ok(clearance),
        }
    }

    /// The longest part of the last step that is taken at once, s: those in which it was taken, and hardly more than the step
    /// in use. A longer one may go another way than the motion.
    pub(super) fn longest_part(&self) -> f64 {
        STRETCH * self.nominal().min(self.books.shortest)
    }

    /// Steps over `span` seconds, negative for back in time, none of them longer than `longest`; returns the least clearance
    /// on the way.
    pub(super) fn reach(&mut self, span: f64, longest: f64) -> Result<f64, SimulationError> {
        let mut clearance = f64::INFINITY;
        if span == 0.0 {
            return Ok(clearance);
        }
        if let Some(Foreseen::Turn { rate, .. }) = self.foreseen() {
            let mut left = span;
            while left != 0.0 {
                let resolved = self.resolving(rate).max(SHORTEST * span.abs());
                let part = resolved.min(longest).copysign(span);
                let is_last = part.abs() > 0.7 * left.abs();
                let h = if is_last { left } else { part };
                clearance = clearance.min(self.advance(h)?);
                left = if is_last { 0.0 } else { left - h };
            }
            return Ok(clearance);
        }
        let parts = (span.abs() / longest).ceil().max(1.0);
        for _ in 0..parts as u64 {
            clearance = clearance.min(self.advance(span / parts)?);
        }
        Ok(clearance)
    }
}
