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
