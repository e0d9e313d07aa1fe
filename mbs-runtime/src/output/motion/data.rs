//! The data of a run for the page, as JSON.
//!
//! A quantity over time is a *column*: an array with a value per frame, or one number where it never changes.

use std::io::{self, Write};

use super::{Frame, json};
use crate::{Model, World};

/// Frames beyond this number are thinned out: a screen shows no more, and the file stays small.
pub(in crate::output) const MOST_FRAMES: usize = 2001;

/// If there are more numbers than this, frames are thinned out further, as long as the motion stays smooth.
const MOST_NUMBERS: usize = 400_000;
const FEWEST_FRAMES: usize = 1000;

/// Points that are never further apart than this, of the size of the motion, are drawn as one.
const SAME: f64 = 2e-6;

/// Significant digits of what is read in a diagram, and of how much it changes.
const DIGITS: usize = 4;
/// A change below this part of a value may be what an iteration leaves.
const ROUND_OFF: f64 = 1e-6;

pub(super) fn write(
    out: &mut impl Write,
    model: &Model,
    frames: &[Frame],
    title: &str,
    stopped: Option<&str>,
    recorded: usize,
) -> io::Result<usize> {
    let (tracks, track) = tracks(model, frames);
    let columns = 3 * tracks.len() + model.outputs.len() + model.reactions.len() + 6;
    let frames = thin(
        frames,
        MOST_FRAMES.min(FEWEST_FRAMES.max(MOST_NUMBERS / columns)),
    );
    let spatial = model.world == World::Spatial;
    let stopped = stopped.map_or("null".to_owned(), json::string);
    let redundant = model.mobility.is_some_and(|m| !m.redundant.is_empty());
    writeln!(out, "{{\"title\":{},", json::string(title))?;
    writeln!(out, "\"doc\":{},", json::string(model.doc))?;
    writeln!(out, "\"stopped\":{stopped},")?;
    writeln!(out, "\"recorded\":{recorded},")?;
    writeln!(out, "\"spatial\":{spatial},")?;
    let up = model.up.iter().map(|x| json::number(*x, 6));
    writeln!(out, "\"up\":{},", json::array(up))?;
    writeln!(out, "\"redundant\":{redundant},")?;
    let parts = model.parts.iter().map(|part| part.name);
    writeln!(out, "\"parts\":{},", json::strings(parts))?;
    let names = json::strings(model.points.iter().copied());
    writeln!(out, "\"names\":{names},")?;
    let segments = model.segments.iter();
    let segments = segments.map(|s| format!("[{},{},{}]", json::string(s.part), s.from, s.to));
    writeln!(out, "\"segments\":{},", json::array(segments))?;
    let track = track.iter().map(ToString::to_string);
    writeln!(out, "\"track\":{},", json::array(track))?;

    // A mechanism far from the origin moves as one beside it.
    let digits = json::digits_for(size_of(frames.iter().copied()));
    let tracks = tracks.iter().map(|&point| {
        let axes = 0..if spatial { 3 } else { 2 };
        let axis = |axis| {
            column(
                &frames,
                |f| f.points[point][axis],
                |_, x| json::number(x, digits),
            )
        };
        json::array(axes.map(axis))
    });
    writeln!(out, "\"tracks\":{},", lines(tracks))?;
    let outputs = model.outputs.iter().enumerate().map(|(i, output)| {
        let values = column(&frames, |f| f.outputs[i], significant);
        let (name, unit) = (json::string(output.name), json::string(output.unit));
        format!("[{name},{unit},{values}]")
    });
    writeln!(out, "\"outputs\":{},", lines(outputs))?;
    let reactions = model.reactions.iter().enumerate().map(|(i, reaction)| {
        let [joint, component, unit] =
            [reaction.joint, reaction.component, reaction.unit].map(json::string);
        let at = reaction.at.map_or("null".to_owned(), |at| at.to_string());
        let values = column(&frames, |f| f.reactions[i], significant);
        let determined = model.is_determined(reaction.joint);
        format!("[{joint},{component},{unit},{at},{values},{determined}]")
    });
    writeln!(out, "\"reactions\":{},", lines(reactions))?;
    let mut series = |name: &str, value: fn(&Frame) -> f64| {
        let spread = spread(frames.iter().map(|f| value(f)));
        let values = frames.iter().map(|f| significant(spread, value(f)));
        writeln!(out, "\"{name}\":{},", json::array(values))
    };
    series("kinetic", |f| f.energy.kinetic)?;
    series("potential", |f| f.energy.potential)?;
    series("total", |f| f.energy.kinetic + f.energy.potential)?;
    series("energyError", |f| f.energy.error)?;
    series("holonomicError", |f| f.holonomic_error)?;
    series("velocityError", |f| f.velocity_error)?;
    let digits = json::digits_for(spread(frames.iter().map(|f| f.time)));
    let times = frames.iter().map(|f| json::number(f.time, digits));
    write!(out, "\"time\":{}}}", json::array(times))?;
    Ok(frames.len())
}

/// Elements that are long: one a line.
fn lines(values: impl IntoIterator<Item = String>) -> String {
    let values: Vec<String> = values.into_iter().collect();
    format!("[{}]", values.join(",\n"))
}

fn column(
    frames: &[&Frame],
    value: impl Fn(&Frame) -> f64,
    text: impl Fn(f64, f64) -> String,
) -> String {
    let spread = spread(frames.iter().map(|f| value(f)));
    let values: Vec<String> = frames.iter().map(|f| text(spread, value(f))).collect();
    match values.first() {
        Some(first) if values.iter().all(|value| value == first) => first.clone(),
        _ => json::array(values),
    }
}

/// One point for each different path in space, and for each point the index of its path.
fn tracks(model: &Model, frames: &[Frame]) -> (Vec<usize>, Vec<usize>) {
    let tolerance = SAME * size_of(frames);
    let same = |a: usize, b: usize| {
        frames.iter().all(|f| {
            let pairs = f.points[a].iter().zip(&f.points[b]);
            pairs.into_iter().all(|(x, y)| (x - y).abs() <= tolerance)
        })
    };
    let mut tracks: Vec<usize> = Vec::new();
    let track = (0..model.points.len()).map(|point| {
        let known = tracks.iter().position(|&other| same(point, other));
        known.unwrap_or_else(|| {
            tracks.push(point);
            tracks.len() - 1
        })
    });
    let track = track.collect();
    (tracks, track)
}

/// Evenly spaced frames, the first and the last among them.
fn thin(frames: &[Frame], most: usize) -> Vec<&Frame> {
    let stride = frames.len().div_ceil(most).max(1);
    let mut kept: Vec<&Frame> = frames.iter().step_by(stride).collect();
    if !frames.is_empty() && !(frames.len() - 1).is_multiple_of(stride) {
        kept.extend(frames.last());
    }
    kept
}

/// A value of a quantity that changes by `spread`: of a small change beside a large value as many digits are kept.
fn significant(spread: f64, value: f64) -> String {
    let ratio = value.abs() / spread;
    let more = match ratio > 1.0 && ratio * ROUND_OFF < 1.0 {
        true => ratio.log10().ceil() as usize,
        false => 0,
    };
    json::significant(value, DIGITS + more)
}

/// How much the finite values differ.
fn spread(values: impl IntoIterator<Item = f64>) -> f64 {
    let finite = values.into_iter().filter(|x| x.is_finite());
    let [least, most] = finite.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], x| {
        [least.min(x), most.max(x)]
    });
    (most - least).max(0.0)
}

/// The largest spread of places along an axis.
fn size_of<'f>(frames: impl IntoIterator<Item = &'f Frame> + Clone) -> f64 {
    let along = |axis: usize| {
        let frames = frames.clone().into_iter();
        spread(frames.flat_map(|f| f.points.iter().map(move |point| point[axis])))
    };
    (0..3).map(along).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_changes_of_large_values_are_kept() {
        assert_eq!(significant(2.0, 1.23456), "1.235");
        assert_eq!(significant(1e-3, 100.00051), "100.00051");
        // What an iteration leaves is no change.
        assert_eq!(significant(1e-13, 100.00000000000001), "100");
        assert_eq!(significant(0.0, 1.23456), "1.235");
        assert_eq!(spread([1e6, f64::NAN, 1e6 + 2.0]), 2.0);
        assert_eq!(spread([]), 0.0);
        let far = Frame {
            points: vec![[1e6, 0.0, 0.0], [1e6 + 1.0, 0.5, 0.0]],
            ..Frame::default()
        };
        assert_eq!(size_of([&far]), 1.0);
    }
}
