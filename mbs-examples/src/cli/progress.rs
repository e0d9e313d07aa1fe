//! The progress bar on stderr; it is not shown if stderr is not a terminal.

use indicatif::{ProgressBar, ProgressStyle};

/// Number of parts of the run that the bar distinguishes.
const PARTS: f64 = 1000.0;

/// The progress of a run.
pub struct Progress {
    bar: ProgressBar,
    end: f64,
}

impl Progress {
    /// A bar up to simulated time `end`.
    pub fn new(scene: &'static str, end: f64) -> Self {
        let bar = ProgressBar::new(PARTS as u64);
        let style = ProgressStyle::with_template("{prefix} {bar:40} {msg}  {eta} left");
        if let Ok(style) = style {
            bar.set_style(style);
        }
        bar.set_prefix(scene);
        Progress { bar, end }
    }

    /// The simulation is at `time` now.
    pub fn at(&self, time: f64) {
        self.bar.set_position((time / self.end * PARTS) as u64);
        if !self.bar.is_hidden() {
            self.bar.set_message(format!("{time:.3} of {} s", self.end));
        }
    }

    /// Removes the bar: the summary follows on the terminal.
    pub fn finish(self) {
        self.bar.finish_and_clear();
    }
}

/// The number of points of a chart that are done, and the time for the rest.
#[cfg(feature = "laboratory")]
pub struct Points {
    bar: ProgressBar,
}

#[cfg(feature = "laboratory")]
impl Points {
    /// A bar for this number of points.
    pub fn new(chart: &'static str, points: u64) -> Self {
        let bar = ProgressBar::new(points);
        let style =
            ProgressStyle::with_template("{prefix} {bar:40} {pos} of {len} {msg}  {eta} left");
        if let Ok(style) = style {
            bar.set_style(style);
        }
        bar.set_prefix(chart);
        Points { bar }
    }

    /// The part of the chart that is measured now.
    pub fn at(&self, what: &'static str) {
        self.bar.set_message(what);
    }

    /// One more point is done.
    pub fn tick(&self) {
        self.bar.inc(1);
    }

    /// Removes the bar.
    pub fn finish(self) {
        self.bar.finish_and_clear();
    }
}
