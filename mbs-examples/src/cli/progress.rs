//! The progress bar on stderr; it hides itself where stderr is not a terminal.

use indicatif::{ProgressBar, ProgressStyle};

/// Parts of the run that the bar tells apart.
const PARTS: f64 = 1000.0;

/// How far a run has come.
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

    /// Removes the bar: what follows it on the terminal is the summary.
    pub fn finish(self) {
        self.bar.finish_and_clear();
    }
}

/// How many points of a chart are known, and the time that the rest will take.
pub struct Points {
    bar: ProgressBar,
}

impl Points {
    /// A bar over so many points.
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

    /// Points of this are measured now.
    pub fn at(&self, what: &'static str) {
        self.bar.set_message(what);
    }

    /// One more is known.
    pub fn tick(&self) {
        self.bar.inc(1);
    }

    /// Removes the bar.
    pub fn finish(self) {
        self.bar.finish_and_clear();
    }
}
