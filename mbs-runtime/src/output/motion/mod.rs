//! A self-contained animation: `motion.html` with the recorded points and energies inside, no network.

use std::io::{self, Write};

use super::{Frame, json};
use crate::Model;

/// The page; its three markers are replaced by the style, the data and the program.
const PAGE: &str = include_str!("motion.html");
const STYLE: &str = include_str!("motion.css");
const PROGRAM: &str = include_str!("motion.js");

/// Frames beyond this number are thinned out: a screen shows no more, and the file stays small.
const MOST_FRAMES: usize = 1500;

/// Writes the animation of `frames`.
///
/// `title` heads the page; `stopped` says why the run ended before its end, if it did.
///
/// # Errors
/// `out` cannot be written.
pub fn write_motion(
    out: &mut impl Write,
    model: &Model,
    frames: &[Frame],
    title: &str,
    stopped: Option<&str>,
) -> io::Result<()> {
    let mut rest = PAGE;
    let mut up_to = |out: &mut dyn Write, marker: &str| {
        let (head, tail) = rest.split_once(marker).unwrap_or((rest, ""));
        rest = tail;
        out.write_all(head.as_bytes())
    };
    up_to(out, "/*STYLE*/")?;
    out.write_all(STYLE.as_bytes())?;
    up_to(out, "/*DATA*/")?;
    write_data(out, model, frames, title, stopped)?;
    up_to(out, "/*PROGRAM*/")?;
    out.write_all(PROGRAM.as_bytes())?;
    out.write_all(rest.as_bytes())
}

fn write_data(
    out: &mut impl Write,
    model: &Model,
    frames: &[Frame],
    title: &str,
    stopped: Option<&str>,
) -> io::Result<()> {
    let frames = thin(frames);
    let spatial = frames.iter().any(|f| f.points.iter().any(|p| p[2] != 0.0));
    let digits = json::digits_for(extent(
        frames.iter().flat_map(|f| f.points.iter().flatten()),
    ));
    writeln!(out, "{{\"title\":{},", json::string(title))?;
    writeln!(out, "\"doc\":{},", json::string(model.doc))?;
    writeln!(
        out,
        "\"stopped\":{},",
        stopped.map_or("null".to_owned(), json::string)
    )?;
    writeln!(out, "\"spatial\":{spatial},")?;
    writeln!(
        out,
        "\"names\":{},",
        json::strings(model.points.iter().copied())
    )?;
    let segments = model
        .segments
        .iter()
        .map(|s| format!("[{},{},{}]", json::string(s.part), s.from, s.to));
    writeln!(out, "\"segments\":{},", json::array(segments))?;
    write_series(out, "time", &frames, |f| f.time)?;
    write_series(out, "kinetic", &frames, |f| f.energy.kinetic)?;
    write_series(out, "potential", &frames, |f| f.energy.potential)?;
    writeln!(out, "\"points\":[")?;
    for (index, frame) in frames.iter().enumerate() {
        let components = if spatial { 3 } else { 2 };
        let numbers = frame.points.iter().flat_map(|p| &p[..components]);
        let numbers = json::array(numbers.map(|x| json::number(*x, digits)));
        let comma = if index + 1 < frames.len() { "," } else { "" };
        writeln!(out, "{numbers}{comma}")?;
    }
    write!(out, "]}}")
}

/// `"name":[…],`
fn write_series(
    out: &mut impl Write,
    name: &str,
    frames: &[&Frame],
    value: impl Fn(&Frame) -> f64,
) -> io::Result<()> {
    let values: Vec<f64> = frames.iter().map(|f| value(f)).collect();
    let digits = json::digits_for(extent(&values));
    let values = json::array(values.iter().map(|x| json::number(*x, digits)));
    writeln!(out, "\"{name}\":{values},")
}

/// Evenly spaced frames, the first and the last among them.
fn thin(frames: &[Frame]) -> Vec<&Frame> {
    let stride = frames.len().div_ceil(MOST_FRAMES).max(1);
    let mut kept: Vec<&Frame> = frames.iter().step_by(stride).collect();
    if !frames.is_empty() && !(frames.len() - 1).is_multiple_of(stride) {
        kept.extend(frames.last());
    }
    kept
}

/// The largest magnitude.
fn extent<'a>(values: impl IntoIterator<Item = &'a f64>) -> f64 {
    let finite = values.into_iter().filter(|x| x.is_finite());
    finite.fold(0.0, |most, x| most.max(x.abs()))
}

#[cfg(test)]
mod tests {
    use super::PAGE;

    #[test]
    fn the_page_has_its_markers_in_order() {
        let places = ["/*STYLE*/", "/*DATA*/", "/*PROGRAM*/"].map(|marker| PAGE.find(marker));
        assert!(places.is_sorted() && places.iter().all(Option::is_some));
    }
}
