//! Results at regular instants.

use crate::{AnySimulation, Sample, SimulationError};

/// Part of an interval by which one of its multiples may miss the end of a run: round-off reaches it after some billion
/// intervals.
pub(crate) const SLACK: f64 = 1e-6;

/// The least interval, as a part of the duration of a run and of its times: the clock cannot count shorter ones.
const COUNTED: f64 = 1e-13;

/// Whether the clock can count steps or intervals of this length between two times.
pub(crate) fn is_counted(length: f64, [from, to]: [f64; 2]) -> bool {
    !(length < COUNTED * (to - from).max(from.abs()))
}

/// A sum of intervals may be before the time that steps have counted, by this part of it.
const SUMMED: f64 = 1e-12;

/// Whether a time is before now by more than the round-off of a sum.
pub(crate) fn is_past(time: f64, now: f64) -> bool {
    time < now - SUMMED * now.abs()
}

/// Refuses an interval that is not positive and finite, or that the clock cannot count between two times.
pub(crate) fn check_interval(
    name: &'static str,
    interval: f64,
    [from, to]: [f64; 2],
) -> Result<(), SimulationError> {
    let wanted = match interval > 0.0 && interval.is_finite() {
        false => "a positive finite value",
        true if to.is_finite() && !is_counted(interval, [from, to]) => {
            "one that the clock can count, above 1e-13 of the duration and of the time"
        }
        true => return Ok(()),
    };
    Err(SimulationError::Setting {
        name,
        value: interval,
        wanted,
    })
}

/// Iterator over samples; made by [`Simulation::samples`](crate::Simulation::samples).
///
/// Each item runs the simulation to the next sample; the iterator ends after the first error.
#[derive(Debug)]
pub struct Samples<'a> {
    simulation: &'a mut dyn AnySimulation,
    start: f64,
    until: f64,
    interval: f64,
    next: u64,
    ended: bool,
}

impl<'a> Samples<'a> {
    pub(crate) fn new(simulation: &'a mut dyn AnySimulation, until: f64, interval: f64) -> Self {
        let start = simulation.time();
        Samples {
            simulation,
            start,
            until,
            interval,
            next: 0,
            ended: false,
        }
    }

    fn advance(&mut self) -> Result<Option<Sample>, SimulationError> {
        check_interval("sample interval", self.interval, [self.start, self.until])?;
        if !self.until.is_finite() || is_past(self.until, self.start) {
            return Err(SimulationError::Time {
                now: self.start,
                wanted: self.until,
            });
        }
        // Multiples of the interval, not a running sum: the instants do not drift.
        let time = self.start + self.next as f64 * self.interval;
        let slack = SLACK * self.interval;
        if time > self.until + slack {
            return Ok(None);
        }
        self.next += 1;
        let simulation = &mut *self.simulation;
        let last = time + self.interval > self.until + slack;
        let time = time.min(self.until);
        if simulation.settings().tolerance.is_none() || last && simulation.time() <= time {
            simulation.run_until(time.max(simulation.time()))?;
            return Ok(Some(simulation.sample()));
        }
        // With a tolerance a step does not end at a sample, and may have gone beyond the last one.
        let mut sample = None;
        simulation.run_past(time, self.until)?;
        simulation.look_at(time, &mut |simulation| sample = Some(simulation.sample()))?;
        Ok(sample)
    }
}

impl Iterator for Samples<'_> {
    type Item = Result<Sample, SimulationError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.ended {
            return None;
        }
        let sample = self.advance().transpose();
        self.ended = !matches!(sample, Some(Ok(_)));
        sample
    }
}
