//! Running to a time or to an event.

use super::Simulation;
use super::books::Books;
use super::hermite::Hermite;
use crate::integrator::Integrator;
use crate::samples::{is_counted, is_past};
use crate::state::rounding;
use crate::{SimulationError, State, System, UnknownName};
use nalgebra::SVector;

/// A remainder below this fraction of a given step, and of the run, is no step: the next one makes up for it. It is larger than the
/// rounding error of a sum of 1e8 steps.
const SLIVER: f64 = 1e-6;
/// The part of a step after which an event that was 0 at its beginning has the sign with which it leaves, and the part of its
/// value at the end below which it has none.
const JUST_LEFT: f64 = 1.0 / 64.0;
const OF_ROUND_OFF: f64 = 1e-12;
/// Bisections on the cubic of a step: its own error is larger than what they leave.
const BISECTIONS: usize = 40;
/// The factor by which a correction of the predicted instant is enlarged.
const BEYOND: f64 = 1.5;

/// The end of a run.
#[derive(Clone, Copy)]
pub(super) struct End {
    time: f64,
    /// The remainder before it that is no step, s.
    sliver: f64,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// Runs to `time` exactly: the last step is shortened. (What is less than a millionth of a given step and of the run is left to the
    /// next step or run; the time is that which was asked for.)
    ///
    /// # Errors
    /// A time in the past or not finite; otherwise as [`Simulation::step`].
    pub fn run_until(&mut self, time: f64) -> Result<(), SimulationError> {
        self.check_target(time)?;
        if time <= self.time() {
            return Ok(());
        }
        self.check_inputs()?;
        self.last_step_start.time = f64::INFINITY;
        let end = self.end(time);
        while let Some(h) = self.next_step(end) {
            self.forward(h, self.left(time))?;
        }
        self.land(end)
    }

    /// Refuses times that cannot be run to.
    pub(super) fn check_target(&self, wanted: f64) -> Result<(), SimulationError> {
        let now = self.time();
        let step = self.nominal();
        // A part of a step may be longer than all that has been run.
        let is_past = is_past(wanted, now) && wanted < now - self.sliver(now, now.abs());
        if !wanted.is_finite() || is_past {
            return Err(SimulationError::Time { now, wanted });
        }
        // Such a run would not end: its steps are below the round-off of the time. With a tolerance they grow.
        let is_given = self.settings.tolerance.is_none();
        if is_given && wanted > now && !is_counted(step, [now, wanted]) {
            let wanted = "a step that the clock can count to the end of the run, above 1e-13 of its duration";
            return Err(SimulationError::Setting {
                name: "step",
                value: step,
                wanted,
            });
        }
        Ok(())
    }

    /// The end of a run that begins now.
    pub(super) fn end(&self, time: f64) -> End {
        let length = time - self.time();
        let length = match is_past(self.time(), time) {
            true => length,
            // The round-off of a sum of times: such a run goes nowhere, and what earlier ones have left out stays so.
            false => f64::INFINITY,
        };
        let sliver = self.sliver(time, length);
        End { time, sliver }
    }

    /// The step to take towards the end of a run; `None` on arrival.
    pub(super) fn next_step(&self, End { time, sliver }: End) -> Option<f64> {
        let (left, step) = (self.left(time), self.nominal());
        let rounding = rounding(time);
        if left <= sliver {
            None
        } else if (left - step).abs() <= rounding {
            // A whole step, as those before.
            Some(step)
        } else if left <= step + sliver {
            Some(left)
        } else {
            Some(step)
        }
    }

    /// The time that is left, s. What the last runs have left out of it counts, so that many short runs go as far as a long one.
    pub(super) fn left(&self, time: f64) -> f64 {
        let State {
            time: now, clock, ..
        } = self.state();
        time - now - clock
    }

    /// The remainder of a run of this length that is no step, s. With a tolerance the last steps end at the time that was asked for,
    /// and a mechanism at rest may have steps of any length.
    fn sliver(&self, time: f64, length: f64) -> f64 {
        match self.settings.tolerance {
            // At large times the round-off of the time is larger than such a remainder.
            None => (SLIVER * self.settings.step.min(length)).max(rounding(time)),
            Some(_) => rounding(time),
        }
    }

    /// Removes the rounding of the sum of steps from the clock; the next step makes up for a remainder that was no step.
    pub(super) fn land(&mut self, end: End) -> Result<(), SimulationError> {
        if self.next_step(end).is_some() {
            return Ok(());
        }
        let time = end.time;
        let behind = -self.left(time);
        let state = self.integrator.state_mut();
        let is_moved = state.time != time;
        (state.time, state.clock) = (time, behind);
        // A run that is resumed from this state evaluates rows and forces at its time.
        if const { S::STRUCTURE.time_dependent } && is_moved && !self.settings.method.has_memory() {
            self.integrator.refresh(&self.settings)?;
            self.take_stock();
        }
        Ok(())
    }

    /// Runs until the expression of `event` changes sign or becomes 0, but not beyond `latest`; the time of the event, or `None`.
    ///
    /// An expression that stays 0 is an event at the first instant at which it is; leaving 0 is none.
    ///
    /// The state is then that just after the change: a further call finds the next one. With a method that has a memory of earlier steps
    /// ([`Method`](crate::Method) lists them) the search allocates.
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
        self.check_inputs()?;
        let mut before = self.event(index)?;
        let end = self.end(latest);
        while let Some(h) = self.next_step(end) {
            self.leave_behind();
            let books = self.books;
            self.forward(h, self.left(latest))?;
            self.land(end)?;
            let after = self.event(index)?;
            if before == 0.0 && after != 0.0 {
                before = self.left_zero(index, after)?;
            }
            if before != 0.0 && (after == 0.0 || !has_sign_of(before, after)) {
                self.locate(index, books, before, after)?;
                // The end of the step, where it led to, is no longer ahead.
                self.last_step_start.time = f64::INFINITY;
                return Ok(Some(self.time()));
            }
            before = after;
        }
        Ok(None)
    }

    /// The value just after the beginning of the last step, where it was 0; 0 if it may be round-off.
    fn left_zero(&mut self, index: usize, after: f64) -> Result<f64, SimulationError> {
        let known = |value: f64| match value.abs() > OF_ROUND_OFF * after.abs() {
            true => value,
            false => 0.0,
        };
        let cubic = Hermite::new(self.system(), &self.last_step_start, self.state());
        let (t, q, v) = cubic.at(self.system(), JUST_LEFT);
        let value = known(self.event_at(index, t, &q, &v));
        if value == 0.0 || has_sign_of(value, after) {
            return Ok(value);
        }
        // The cubic leaves 0 with the other sign where the motion does as the fourth power of time: a step decides.
        let (mut q, mut v) = (q, v);
        self.look_at(t, &mut |then| {
            q.copy_from_slice(&then.coordinates());
            v.copy_from_slice(&then.velocities());
        })?;
        Ok(known(self.event_at(index, t, &q, &v)))
    }

    /// Steps again from the beginning of the last step, with shorter ones, until the sign change is bracketed to
    /// round-off. The first estimate is from the cubic between the ends.
    fn locate(
        &mut self,
        index: usize,
        books: Books,
        before: f64,
        after: f64,
    ) -> Result<(), SimulationError> {
        let h = self.time() - self.last_step_start.time;
        let (mut low, mut high) = (0.0, h);
        let (mut f_low, mut f_high) = (before, after);
        let resolution = rounding(self.last_step_start.time).max(1e-12 * h);
        let mut guess = Some(self.event_on_cubic(index, before));
        let mut current = h;
        let (mut last, mut probed) = (None, false);
        let longest = self.longest_part();
        // Steps of a method with a memory depend on those before, also on the trials of this search.
        let memory = self.memory();
        for iteration in 0..200 {
            if high - low <= resolution {
                break;
            }
            // Illinois' false position; every third step a bisection, so that the bracket shrinks surely.
            let secant = low + (high - low) * f_low / (f_low - f_high);
            let middle = 0.5 * (low + high);
            let tried = guess.take().unwrap_or(secant);
            let inside = tried > low && tried < high && iteration % 4 != 3;
            current = if inside { tried } else { middle };
            if current <= low || current >= high {
                break;
            }
            self.rewind(books, memory.as_ref())?;
            self.reach(current, longest)?;
            let value = self.event(index)?;
            if value == 0.0 && !probed {
                // A simple root, found exactly, if the sign is still the old one just before.
                (guess, probed) = (Some(current - 0.9 * resolution), true);
            } else if iteration == 0 {
                // The cubic is off by a little: a step beyond its own error brackets the change tightly.
                guess = Some(current - BEYOND * value * (high - low) / (f_high - f_low));
            }
            let raised = value != 0.0 && has_sign_of(before, value);
            // The value at an end that stays for the second time is halved.
            let weight = if last == Some(raised) { 0.5 } else { 1.0 };
            last = Some(raised);
            if raised {
                (low, f_low) = (current, value);
                f_high *= weight;
            } else {
                (high, f_high) = (current, value);
                f_low *= weight;
            }
        }
        if current != high {
            self.rewind(books, memory.as_ref())?;
            self.reach(high, longest)?;
        }
        self.watch();
        Ok(())
    }

    /// When the event happens on the cubic of the last step, s after its beginning.
    fn event_on_cubic(&mut self, index: usize, before: f64) -> f64 {
        let cubic = Hermite::new(self.system(), &self.last_step_start, self.state());
        let h = self.time() - self.last_step_start.time;
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (low + high);
            let (t, q, v) = cubic.at(self.system(), middle);
            let value = self.event_at(index, t, &q, &v);
            match value != 0.0 && has_sign_of(before, value) {
                true => low = middle,
                false => high = middle,
            }
        }
        0.5 * (low + high) * h
    }

    fn rewind(
        &mut self,
        books: Books,
        memory: Option<&Integrator<S, Q, N, R>>,
    ) -> Result<(), SimulationError> {
        if let Some(memory) = memory {
            self.integrator = memory.clone();
        }
        self.integrator.state_mut().copy_from(&self.last_step_start);
        self.books = books;
        self.integrator.refresh(&self.settings)?;
        self.take_stock();
        Ok(())
    }

    /// The value of an event expression now.
    fn event(&mut self, index: usize) -> Result<f64, SimulationError> {
        let (t, q, v) = (self.time(), *self.positions(), *self.velocities());
        let value = self.event_at(index, t, &q, &v);
        match value.is_nan() {
            true => Err(SimulationError::Event {
                time: t,
                event: S::MODEL.events[index],
            }),
            false => Ok(value),
        }
    }

    fn event_at(&mut self, index: usize, t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>) -> f64 {
        let mut values = std::mem::take(&mut self.events);
        self.system().events(t, q, v, &mut values);
        self.events = values;
        self.events.get(index).copied().unwrap_or(0.0)
    }
}

/// Whether two values have the same sign. (The product of small ones vanishes.)
fn has_sign_of(value: f64, other: f64) -> bool {
    (value < 0.0) == (other < 0.0)
}
