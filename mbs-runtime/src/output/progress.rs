//! A bar on stderr that shows how far a run is.

use std::io::{self, IsTerminal, Write};

use super::Progress;

/// Characters of the bar.
const WIDTH: usize = 40;

/// Drawn again for each percent; removed at the end. Nothing is written where stderr is no terminal.
#[derive(Debug)]
pub struct ProgressBar {
    is_visible: bool,
    shown: Option<u32>,
}

impl Default for ProgressBar {
    fn default() -> Self {
        Self::new()
    }
}

impl ProgressBar {
    /// A bar that has not been drawn.
    pub fn new() -> Self {
        ProgressBar {
            is_visible: io::stderr().is_terminal(),
            shown: None,
        }
    }

    /// Draws it where it has changed. A terminal that takes no text ends no run.
    pub fn show(&mut self, progress: &Progress) {
        let percent = (100.0 * progress.fraction()) as u32;
        if !self.is_visible || self.shown == Some(percent) {
            return;
        }
        self.shown = Some(percent);
        let text = match percent {
            100 => "\r\x1b[K".to_owned(),
            _ => "\r".to_owned() + &line(progress),
        };
        let mut out = io::stderr();
        let _ = out.write_all(text.as_bytes()).and_then(|()| out.flush());
    }
}

/// `[####……] 1.200 of 10 s`.
fn line(progress: &Progress) -> String {
    let done = (progress.fraction() * WIDTH as f64) as usize;
    let (full, empty) = ("#".repeat(done), "·".repeat(WIDTH - done));
    format!(
        "[{full}{empty}] {:.3} of {} s",
        progress.time, progress.until
    )
}

#[cfg(test)]
mod tests {
    use super::{Progress, line};

    #[test]
    fn the_bar_is_as_long_as_the_time() {
        let quarter = Progress {
            start: 1.0,
            time: 2.0,
            until: 5.0,
        };
        let full = line(&quarter).matches('#').count();
        assert_eq!(full, 10);
        assert!(line(&quarter).ends_with("2.000 of 5 s"));
    }
}
