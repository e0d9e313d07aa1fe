//! A self-contained animation: `motion.html` with the recorded instants inside, no network.

pub(super) mod data;

use std::io::{self, Write};

use super::frame_check::check_frames;
use super::{Frame, json};
use crate::Model;

/// The page; its three markers are replaced by the style, the data and the program.
const PAGE: &str = include_str!("page.html");
const STYLE: &str = include_str!("style.css");

/// The program: one scope, each file uses what those before it define.
const PROGRAM: [&str; 5] = [
    include_str!("record.js"),
    include_str!("view.js"),
    include_str!("scene.js"),
    include_str!("charts.js"),
    include_str!("controls.js"),
];

/// Writes the animation of `frames`.
///
/// `title` is the heading of the page; `stopped` is the reason if the run ended early. Returns the number of instants
/// that the page shows: it thins them out to 2001 at most, and says so.
///
/// # Errors
/// Before anything is written, frames that do not belong to the model, or whose time is not finite
/// ([`io::ErrorKind::InvalidData`]); `out` cannot be written.
pub fn write_motion(
    out: &mut impl Write,
    model: &Model,
    frames: &[Frame],
    title: &str,
    stopped: Option<&str>,
) -> io::Result<usize> {
    write_motion_of(frames.len(), out, model, frames, title, stopped)
}

/// The same of a run of which more instants were recorded than `frames` has.
pub(super) fn write_motion_of(
    recorded: usize,
    out: &mut impl Write,
    model: &Model,
    frames: &[Frame],
    title: &str,
    stopped: Option<&str>,
) -> io::Result<usize> {
    check_frames(model, frames)?;
    let mut rest = PAGE;
    let mut up_to = |out: &mut dyn Write, marker: &str| {
        let (head, tail) = rest.split_once(marker).unwrap_or((rest, ""));
        rest = tail;
        out.write_all(head.as_bytes())
    };
    up_to(out, "/*STYLE*/")?;
    out.write_all(STYLE.as_bytes())?;
    up_to(out, "/*DATA*/")?;
    let shown = data::write(out, model, frames, title, stopped, recorded)?;
    up_to(out, "/*PROGRAM*/")?;
    for file in PROGRAM {
        out.write_all(file.as_bytes())?;
    }
    out.write_all(rest.as_bytes())?;
    Ok(shown)
}

#[cfg(test)]
mod tests {
    use super::{PAGE, PROGRAM, STYLE};

    #[test]
    fn the_page_has_its_markers_in_order() {
        let places = ["/*STYLE*/", "/*DATA*/", "/*PROGRAM*/"].map(|marker| PAGE.find(marker));
        assert!(places.is_sorted() && places.iter().all(Option::is_some));
    }

    #[test]
    fn the_page_is_small_and_asks_for_nothing() {
        let text = [&[PAGE, STYLE], &PROGRAM[..]].concat().concat();
        assert!(text.len() < 100_000, "{} bytes", text.len());
        for address in ["http:", "https:", "url(", "@import", "import(", "fetch("] {
            assert!(!text.contains(address), "{address}");
        }
    }
}
