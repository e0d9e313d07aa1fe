//! Running to a time or to an event.

use super::Simulation;
use crate::{Report, SimulationError, State, System, UnknownName};

/// A remainder of this fraction of a step is merged with the last step instead of being taken as a sliver. It covers the
/// rounding of a clock that has added up 1e8 steps.
const SLIVER: f64 = 1e-6;

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// Runs to `time` and lands exactly on it: the last step is shortened.
    ///
    /// # Errors
    /// A time in the past or not finite; otherwise as [`Simulation::step`].
    pub fn run_until(&mut self, time: f64) -> Result<(), SimulationError> {
        self.check_target(time)?;
        while let Some(h) = self.next_step(time) {
            self.place(h, time - self.time())?;
        }
        self.land(time);
        Ok(())
    }

    /// Refuses times that cannot be run to.
    fn check_target(&self, wanted: f64) -> Result<(), SimulationError> {
        let now = self.time();
        let step = self.settings.step;
        if !(wanted.is_finite() && wanted >= now - SLIVER * step) {
            return Err(SimulationError::Time { now, wanted });
        }
        // Such a run would not end, and the clock would not feel its steps.
        if wanted > now && step < 1e-13 * (wanted - now).max(now.abs()) {
            let wanted = "a step that the clock can count to the end of the run, above 1e-13 of its duration";
            return Err(SimulationError::Setting {
                name: "step",
                value: step,
                wanted,
            });
        }
        Ok(())
    }

    /// The step to take towards `time`; `None` on arrival.
    fn next_step(&self, time: f64) -> Option<f64> {
        let left = time - self.time();
        let step = self.settings.step;
        // Beside a large time the clock itself is coarser than a sliver.
        let sliver = (SLIVER * step).max(4.0 * f64::EPSILON * time.abs());
        if left <= sliver {
            None
        } else if left <= step + sliver {
            Some(left)
        } else {
            Some(step)
        }
    }

    /// Removes the rounding of the sum of steps from the clock.
    fn land(&mut self, time: f64) {
        if self.next_step(time).is_none() {
            self.integrator.state_mut().time = time;
        }
    }

    /// Runs until the expression of `event` changes sign, but not beyond `latest`; the time of the event, or `None`.
    ///
    /// The state is then that just after the change: a further call looks for the next one.
    ///
    /// # Errors
    /// An unknown event; otherwise as [`Simulation::run_until`].
    pub fn run_to_event(
        &mut self,
        event: &str,
        latest: f64,
    ) -> Result<Option<f64>, SimulationError> {
        let known = S::MODEL.events;
        let index = known
            .iter()
            .position(|name| *name == event)
            .ok_or_else(|| UnknownName::new("event", event, known.iter().copied()))?;
        self.check_target(latest)?;
        let mut before = self.event(index);
        while let Some(h) = self.next_step(latest) {
            let state = self.state().clone();
            let report = self.report;
            let h = self.place(h, latest - self.time())?;
            self.land(latest);
            let after = self.event(index);
            if before * after < 0.0 || (after == 0.0 && before != 0.0) {
                self.locate(index, &state, report, h, before, after)?;
                return Ok(Some(self.time()));
            }
            before = after;
        }
        Ok(None)
    }

    /// Steps again from `state`, with steps shorter than h, until the sign change is bracketed to round-off.
    fn locate(
        &mut self,
        index: usize,
        state: &State<Q, N, R>,
        report: Report,
        h: f64,
        before: f64,
        after: f64,
    ) -> Result<(), SimulationError> {
        let (mut low, mut high) = (0.0, h);
        let (mut f_low, mut f_high) = (before, after);
        let resolution = 1e-12 * state.time.abs().max(h);
        let mut current = h;
        for iteration in 0..200 {
            if high - low <= resolution || f_high == 0.0 {
                break;
            }
            // Illinois' false position; every third step a bisection, so that the bracket shrinks surely.
            let secant = low + (high - low) * f_low / (f_low - f_high);
            let middle = 0.5 * (low + high);
            let inside = secant > low && secant < high && iteration % 3 != 2;
            current = if inside { secant } else { middle };
            if current <= low || current >= high {
                break;
            }
            self.rewind(state, report)?;
            self.advance(current)?;
            let value = self.event(index);
            if before * value > 0.0 {
                (low, f_low) = (current, value);
                f_high *= 0.5;
            } else {
                (high, f_high) = (current, value);
                f_low *= 0.5;
            }
        }
        if current != high {
            self.rewind(state, report)?;
            self.advance(high)?;
        }
        self.watch();
        Ok(())
    }

    fn rewind(&mut self, state: &State<Q, N, R>, report: Report) -> Result<(), SimulationError> {
        *self.integrator.state_mut() = state.clone();
        self.report = report;
        self.integrator.refresh(&self.settings)?;
        self.take_stock();
        Ok(())
    }

    /// The value of an event expression now.
    fn event(&mut self, index: usize) -> f64 {
        let mut values = std::mem::take(&mut self.events);
        let state = self.state();
        self.system()
            .events(state.time, &state.positions, &state.velocities, &mut values);
        self.events = values;
        self.events.get(index).copied().unwrap_or(0.0)
    }
}
