//! Runs that are recorded at regular instants.

use std::fmt;

use super::{Frame, ProgressBar};
use crate::samples::{SLACK, check_interval, is_past};
use crate::{AnySimulation, Model, Simulation, SimulationError, System};

/// The largest number of intervals where none is given.
const MOST: f64 = 2000.0;
/// The number of intervals where none is given and the instants lie between steps.
const LOOKS: f64 = 500.0;

/// A recorded run in preparation; made by [`Simulation::record`](crate::Simulation::record).
///
/// ```
/// # use mbs_runtime::{Simulation, mechanism};
/// # mechanism!(Pendulum {
/// #     world: Planar(gravity = [0.0, -9.81_m_per_s2]),
/// #     rod: Bar(mass = 1.0_kg, length = 1.0_m, angle = 0.0_deg),
/// #     pivot: Revolute(ground.origin, rod.a),
/// #     height: Output(rod.b.y),
/// # });
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let mut simulation = Simulation::new(Pendulum {})?;
/// let recording = simulation.record(2.0).every(0.01).progress_bar().run()?;
/// assert_eq!(recording.frames.len(), 201);
/// # let folder = std::env::temp_dir().join(format!("mbs-recording-{}", std::process::id()));
/// recording.save(&folder)?; // trajectory.csv and motion.html
/// # std::fs::remove_dir_all(&folder)?;
/// # Ok(())
/// # }
/// ```
#[must_use = "nothing runs before `run` or `save`"]
pub struct Record<'a> {
    pub(super) simulation: &'a mut dyn AnySimulation,
    pub(super) title: Option<String>,
    pub(super) with_npz: bool,
    until: f64,
    interval: Option<f64>,
    progress: Option<Box<dyn FnMut(Progress) + 'a>>,
}

/// How far a run is.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Progress {
    /// Where it began, s.
    pub start: f64,
    /// Where it is, s.
    pub time: f64,
    /// Where it ends, s.
    pub until: f64,
}

impl Progress {
    /// The part of the run that is done, from 0 to 1.
    pub fn fraction(&self) -> f64 {
        match self.until > self.start {
            true => ((self.time - self.start) / (self.until - self.start)).clamp(0.0, 1.0),
            false => 1.0,
        }
    }
}

/// The recorded instants of a run.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Recording {
    /// What moved.
    pub model: &'static Model,
    /// The heading of diagrams and of the animation; the name of the mechanism, until it is set to another text.
    pub title: String,
    /// The instants.
    pub frames: Vec<Frame>,
    /// Why the run ended before its end.
    pub stopped: Option<SimulationError>,
}

impl Recording {
    /// A recording that the program fills, as in a control loop, with the present instant.
    pub fn begin(simulation: &dyn AnySimulation) -> Self {
        let model = simulation.model();
        Recording {
            model,
            title: model.name.to_owned(),
            frames: vec![Frame::record(simulation)],
            stopped: None,
        }
    }

    /// Adds the present instant of the same simulation.
    pub fn add(&mut self, simulation: &dyn AnySimulation) {
        self.frames.push(Frame::record(simulation));
    }
}

/// A run that ended before its end, with all instants until then.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Interrupted {
    /// Why.
    pub error: SimulationError,
    /// The instants until then, with the same error.
    pub recording: Box<Recording>,
}

impl fmt::Display for Interrupted {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.error, out)
    }
}

impl std::error::Error for Interrupted {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        Some(&self.error)
    }
}

impl fmt::Debug for Record<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_struct("Record")
            .field("simulation", &self.simulation)
            .field("until", &self.until)
            .field("interval", &self.interval)
            .finish_non_exhaustive()
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// Records instants of the motion until a time, s, for a table, diagrams and an animation ([`Record`]).
    pub fn record(&mut self, until: f64) -> Record<'_> {
        Record::new(self, until)
    }
}

impl<'a> Record<'a> {
    /// Of the rest of the motion until a time, s.
    pub fn new(simulation: &'a mut dyn AnySimulation, until: f64) -> Self {
        Record {
            simulation,
            title: None,
            with_npz: false,
            until,
            interval: None,
            progress: None,
        }
    }

    /// The heading of diagrams and of the animation; without it the name of the mechanism.
    pub fn title(mut self, title: impl Into<String>) -> Self {
        self.title = Some(title.into());
        self
    }

    /// An instant every `interval` seconds, and one at the end. Without it, at most 2000 intervals of whole steps; with a
    /// tolerance 500.
    pub fn every(mut self, interval: f64) -> Self {
        self.interval = Some(interval);
        self
    }

    /// Calls `progress` at every recorded instant after the first one.
    pub fn progress(mut self, progress: impl FnMut(Progress) + 'a) -> Self {
        self.progress = Some(Box::new(progress));
        self
    }

    /// Shows a bar on stderr while the run lasts, if that is a terminal.
    pub fn progress_bar(self) -> Self {
        let mut bar = ProgressBar::new();
        self.progress(move |progress| bar.show(&progress))
    }

    /// Runs and records. A step ends at each instant, but for runs with a tolerance, where instants lie between steps.
    ///
    /// # Errors
    /// An interval that is not positive and finite, or that the clock cannot count; otherwise as [`Simulation::run_until`](crate::Simulation::run_until).
    /// The error has all instants until then, and as the last one the state after the last good step.
    pub fn run(mut self) -> Result<Recording, Interrupted> {
        let mut frames = Vec::new();
        let ended = self.advance(&mut |frame| {
            frames.push(frame);
            Ok::<(), SimulationError>(())
        });
        match ended {
            Ok(()) => Ok(self.recording(frames, None)),
            Err(error) => {
                let now = self.simulation.time();
                if frames.last().is_none_or(|last| last.time < now) {
                    frames.push(Frame::record(self.simulation));
                }
                Err(Interrupted {
                    recording: Box::new(self.recording(frames, Some(&error))),
                    error,
                })
            }
        }
    }

    /// The instants of this run.
    pub(super) fn recording(
        &mut self,
        frames: Vec<Frame>,
        stopped: Option<&SimulationError>,
    ) -> Recording {
        let model = self.simulation.model();
        let title = self.title.take();
        Recording {
            model,
            title: title.unwrap_or_else(|| model.name.to_owned()),
            frames,
            stopped: stopped.cloned(),
        }
    }

    /// Refuses what cannot be run to, before anything is run or written.
    pub(super) fn check(&self) -> Result<(), SimulationError> {
        let (start, until) = (self.simulation.time(), self.until);
        if !until.is_finite() || is_past(until, start) {
            return Err(SimulationError::Time {
                now: start,
                wanted: until,
            });
        }
        match self.interval {
            Some(given) => check_interval("recording interval", given, [start, until]),
            None => Ok(()),
        }
    }

    /// Runs to the end, and hands on each instant.
    pub(super) fn advance<E: From<SimulationError>>(
        &mut self,
        keep: &mut dyn FnMut(Frame) -> Result<(), E>,
    ) -> Result<(), E> {
        self.check()?;
        let (start, until) = (self.simulation.time(), self.until);
        let interval = self.interval.unwrap_or_else(|| self.usual(until - start));
        let at = |time| Progress { start, time, until };
        keep(Frame::record(self.simulation))?;
        if until <= start {
            return Ok(self.simulation.run_until(until)?);
        }
        let between = self.simulation.settings().tolerance.is_some();
        // Multiples of the interval, not a running sum: the instants do not drift.
        let count = ((until - start) / interval - SLACK).ceil().max(1.0) as u64;
        for index in 1..=count {
            let is_last = index == count;
            let time = match is_last {
                true => until,
                false => start + index as f64 * interval,
            };
            if between && !is_last {
                self.simulation.run_past(time, until)?;
                let mut kept = Ok(());
                let mut look = |simulation: &dyn AnySimulation| {
                    kept = keep(Frame::record(simulation));
                };
                self.simulation.look_at(time, &mut look)?;
                kept?;
            } else {
                self.simulation.run_until(time)?;
                keep(Frame::record(self.simulation))?;
            }
            if let Some(progress) = &mut self.progress {
                progress(at(time));
            }
        }
        Ok(())
    }

    /// The interval where none is given.
    fn usual(&self, duration: f64) -> f64 {
        let settings = self.simulation.settings();
        match settings.tolerance {
            Some(_) => duration / LOOKS,
            None => (duration / settings.step / MOST).ceil().max(1.0) * settings.step,
        }
    }
}
