//! Diagrams of a run as SVG: outputs, the energy balance, the constraint errors.

use std::ops::Range;

use super::frame_check::check_times;
use super::{Frame, Recording};
use plotters::coord::Shift;
use plotters::prelude::*;

const SIZE: (u32, u32) = (960, 640);
/// Room for the labels of the y axis, and at the right edge.
const LEFT: u32 = 116;
const MARGIN: u32 = 12;
const RIGHT: u32 = 32;
/// Width of the diagram itself.
const WIDTH: u32 = SIZE.0 - LEFT - RIGHT;
const FONT: &str = "DejaVu Sans, Helvetica, Arial, sans-serif";
const TEXT: RGBColor = RGBColor(29, 33, 38);
const GRID: RGBColor = RGBColor(228, 229, 225);
// Their lightness differs: the curves stay apart in grey.
const BLUE: RGBColor = RGBColor(20, 80, 125);
const ORANGE: RGBColor = RGBColor(224, 142, 46);
const GREEN: RGBColor = RGBColor(60, 133, 72);
const COLOURS: [RGBColor; 5] = [
    BLUE,
    ORANGE,
    GREEN,
    RGBColor(150, 50, 110),
    RGBColor(110, 110, 110),
];

/// Height of one of several diagrams.
const PANEL: u32 = 320;

/// Smaller errors are drawn at this value: a logarithmic axis has no zero.
const FLOOR: f64 = 1e-18;

/// Points of an error curve at most.
const SPANS: usize = 400;

/// Decimals of a label at most.
const MOST_DECIMALS: usize = 12;
/// The width of a digit of a label, of a letter of a title, and of the name of an axis.
const DIGIT: u32 = 11;
const LETTER: u32 = 10;
const ROOM_OF_NAME: u32 = 36;

/// A curve with its colour, and its label in the legend.
struct Curve {
    label: &'static str,
    colour: RGBColor,
    points: Vec<(f64, f64)>,
}

impl Curve {
    fn new(
        label: &'static str,
        colour: RGBColor,
        frames: &[Frame],
        value: impl Fn(&Frame) -> f64,
    ) -> Self {
        let points = frames.iter().map(|f| (f.time, value(f))).collect();
        Curve {
            label,
            colour,
            points,
        }
    }

    /// The parts between values that are no numbers.
    fn parts(&self) -> impl Iterator<Item = &[(f64, f64)]> {
        let parts = self.points.split(|(_, y)| !y.is_finite());
        parts.filter(|part| !part.is_empty())
    }
}

/// The largest value in each of many equal spans of time. Only large errors matter, and the zeros of an oscillating
/// error would fill a logarithmic diagram with lines.
fn envelope(curve: &Curve) -> Curve {
    let size = curve.points.len().div_ceil(SPANS).max(1);
    // A maximum of two values is a number where one of them is.
    let largest = |span: &[(f64, f64)]| span.iter().fold(f64::NAN, |most, p| most.max(p.1));
    let spans = curve.points.chunks(size);
    let mut points: Vec<_> = spans.map(|span| (span[0].0, largest(span))).collect();
    if let (Some(&(end, _)), Some(&(_, value))) = (curve.points.last(), points.last()) {
        points.push((end, value));
    }
    Curve { points, ..*curve }
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawn = Result<(), Box<dyn std::error::Error>>;

/// Kinetic, potential and total energy above, the error of the balance below.
///
/// # Errors
/// A time that is not finite; the message of the drawing library.
pub fn energy(title: &str, frames: &[Frame]) -> Result<String, String> {
    check_times(frames).map_err(|error| error.to_string())?;
    picture(|root| {
        let (upper, lower) = root.split_vertically(SIZE.1 * 11 / 20);
        let curves = [
            Curve::new("T kinetic", BLUE, frames, |f| f.energy.kinetic),
            Curve::new("V potential", ORANGE, frames, |f| f.energy.potential),
            Curve::new("T + V", GREEN, frames, |f| {
                f.energy.kinetic + f.energy.potential
            }),
        ];
        let caption = caption(title, ": energy");
        linear(&upper, &caption, ("energy, ", "J"), &curves)?;
        let error = Curve::new("|T + V − work − E₀|", BLUE, frames, |f| {
            f.energy.error.abs()
        });
        logarithmic(
            &lower,
            "error of the energy balance",
            "energy error, J",
            &[error],
        )
    })
}

/// The outputs of a recorded run over time, a diagram for each unit; more than five of a unit, or names that are too long for
/// one legend, are continued in a further diagram.
///
/// # Errors
/// A time that is not finite; the message of the drawing library.
pub fn outputs(recording: &Recording) -> Result<String, String> {
    check_times(&recording.frames).map_err(|error| error.to_string())?;
    let panels = panels(recording);
    let height = PANEL * panels.len().max(1) as u32;
    picture_of(height, |root| {
        let areas = root.split_evenly((panels.len().max(1), 1));
        for (area, (unit, curves)) in areas.iter().zip(&panels) {
            let unit = if unit.is_empty() { "1" } else { unit };
            linear(area, &caption(&recording.title, ""), ("", unit), curves)?;
        }
        Ok(())
    })
}

/// The outputs of each unit, as many together as a legend has room for.
fn panels(recording: &Recording) -> Vec<(&'static str, Vec<Curve>)> {
    let mut panels: Vec<(&str, Vec<Curve>)> = Vec::new();
    for (index, output) in recording.model.outputs.iter().enumerate() {
        let value = |frame: &Frame| frame.outputs.get(index).copied().unwrap_or(f64::NAN);
        let curve = Curve::new(output.name, BLUE, &recording.frames, value);
        let open = panels
            .iter_mut()
            .rev()
            .find(|(unit, _)| *unit == output.unit);
        let open = open.filter(|(_, curves)| {
            curves.len() < COLOURS.len() && legend_width(curves) + entry_width(&curve) < WIDTH
        });
        match open {
            Some((_, curves)) => curves.push(curve),
            None => panels.push((output.unit, vec![curve])),
        }
    }
    for (_, curves) in &mut panels {
        for (curve, colour) in curves.iter_mut().zip(COLOURS) {
            curve.colour = colour;
        }
    }
    panels
}

/// Position and velocity errors of the constraint rows.
///
/// # Errors
/// A time that is not finite; the message of the drawing library.
pub fn constraints(title: &str, frames: &[Frame]) -> Result<String, String> {
    check_times(frames).map_err(|error| error.to_string())?;
    picture(|root| {
        let curves = &[
            Curve::new("max |φ|, position level", BLUE, frames, |f| {
                f.holonomic_error
            }),
            Curve::new("max |A v + b|, velocity level", ORANGE, frames, |f| {
                f.velocity_error
            }),
        ];
        let caption = caption(title, ": constraint errors");
        logarithmic(root, &caption, "error, SI units of the rows", curves)
    })
}

fn picture(draw: impl FnOnce(&Area) -> Drawn) -> Result<String, String> {
    picture_of(SIZE.1, draw)
}

fn picture_of(height: u32, draw: impl FnOnce(&Area) -> Drawn) -> Result<String, String> {
    let mut svg = String::new();
    let root = SVGBackend::with_string(&mut svg, (SIZE.0, height)).into_drawing_area();
    root.fill(&WHITE)
        .map_err(|e| e.to_string())
        .and_then(|()| draw(&root).map_err(|e| e.to_string()))
        .and_then(|()| root.present().map_err(|e| e.to_string()))?;
    drop(root);
    Ok(svg)
}

fn linear(area: &Area, caption: &str, (name, unit): (&str, &str), curves: &[Curve]) -> Drawn {
    let (low, high) = bounds(curves).unwrap_or((0.0, 1.0));
    let power = power_of_ten(low.abs().max(high.abs()));
    let scale = ten_to(-power);
    let (low, high) = (low * scale, high * scale);
    let margin = if high > low {
        0.06 * (high - low)
    } else {
        low.abs().max(1.0)
    };
    let range = low - margin..high + margin;
    let height = range.end - range.start;
    let digits = decimals(height).min(MOST_DECIMALS);
    let axis = Axis {
        unit: &format!("{name}{}", in_powers(power, unit)),
        range,
        labels: 8,
        label: &|y| tick(*y, height, digits),
        place: &|y| y * scale,
    };
    panel(area, caption, curves, axis)
}

fn logarithmic(area: &Area, caption: &str, unit: &str, curves: &[Curve]) -> Drawn {
    let curves: Vec<Curve> = curves.iter().map(envelope).collect();
    let values = curves.iter().flat_map(|c| &c.points).map(|p| p.1);
    let (low, high) = span(values.filter(|y| *y > 0.0 && y.is_finite())).unwrap_or((FLOOR, FLOOR));
    // Whole decades, nine at most.
    let top = high.max(FLOOR * 10.0).log10().ceil();
    let bottom = low.max(FLOOR).log10().floor().max(top - 9.0).min(top - 1.0);
    let axis = Axis {
        unit,
        range: bottom..top,
        labels: (top - bottom) as usize + 1,
        label: &|exponent| format!("1e{exponent:.0}"),
        place: &|y| y.log10().max(bottom),
    };
    panel(area, caption, &curves, axis)
}

/// The vertical axis of a diagram.
struct Axis<'a> {
    unit: &'a str,
    range: Range<f64>,
    /// How many labels at most.
    labels: usize,
    label: &'a dyn Fn(&f64) -> String,
    /// Where on the axis a value is.
    place: &'a dyn Fn(f64) -> f64,
}

/// One diagram: a heading with the legend, axes, curves.
fn panel(area: &Area, caption: &str, curves: &[Curve], axis: Axis) -> Drawn {
    let rows = if legend_width(curves) + title_width(caption) < WIDTH {
        1
    } else {
        2
    };
    let (head, body) = area.split_vertically(12 + 26 * rows);
    heading(&head, caption, curves, 26 * (rows - 1))?;
    let times = times(curves);
    let power = power_of_ten(times.end - times.start);
    let scale = ten_to(-power);
    let times = times.start * scale..times.end * scale;
    let span = times.end - times.start;
    let time_digits = decimals(span).min(MOST_DECIMALS);
    let ends = [axis.range.start, axis.range.end].map(|y| (axis.label)(&y).chars().count() as u32);
    let room = ROOM_OF_NAME + DIGIT * ends[0].max(ends[1]);
    let mut chart = ChartBuilder::on(&body)
        .margin_left(MARGIN)
        .margin_right(RIGHT)
        .margin_top(6)
        .x_label_area_size(50)
        .y_label_area_size(room.max(LEFT - MARGIN))
        .build_cartesian_2d(times, axis.range)?;
    chart
        .configure_mesh()
        .x_desc(format!("time, {}", in_powers(power, "s")))
        .y_desc(axis.unit)
        .label_style((FONT, 18, &TEXT))
        .axis_desc_style((FONT, 18, &TEXT))
        .bold_line_style(GRID)
        .light_line_style(TRANSPARENT)
        .axis_style(TEXT)
        .x_label_formatter(&|t| tick(*t, span, time_digits))
        .y_labels(axis.labels)
        .y_label_formatter(&axis.label)
        .draw()?;
    for curve in curves {
        for part in curve.parts() {
            let points = part.iter().map(|(t, y)| (t * scale, (axis.place)(*y)));
            match part {
                // A line of one point is not drawn.
                [_] => {
                    let dots = points.map(|point| Circle::new(point, 3, curve.colour.filled()));
                    chart.draw_series(dots)?;
                }
                _ => {
                    let style = curve.colour.stroke_width(2);
                    chart.draw_series(LineSeries::new(points, style))?;
                }
            }
        }
    }
    Ok(())
}

/// Title at the left, legend at the right: above the diagram, where it hides no curve; `drop` lower if it is long.
fn heading(area: &Area, caption: &str, curves: &[Curve], drop: i32) -> Drawn {
    let title = (FONT, 21, &TEXT).into_text_style(area);
    area.draw_text(caption, &title, (LEFT as i32, 14))?;
    let style = (FONT, 18, &TEXT).into_text_style(area);
    let mut x = (LEFT + WIDTH).saturating_sub(legend_width(curves)) as i32;
    for curve in curves {
        let line = vec![(x, 23 + drop), (x + 24, 23 + drop)];
        area.draw(&PathElement::new(line, curve.colour.stroke_width(3)))?;
        area.draw_text(curve.label, &style, (x + 32, 16 + drop))?;
        x += entry_width(curve) as i32;
    }
    Ok(())
}

// The fonts of the reader are unknown here: room for a wide one.

fn title_width(caption: &str) -> u32 {
    LETTER * caption.chars().count() as u32
}

fn entry_width(curve: &Curve) -> u32 {
    52 + 9 * curve.label.chars().count() as u32
}

fn legend_width(curves: &[Curve]) -> u32 {
    curves.iter().map(entry_width).sum()
}

fn times(curves: &[Curve]) -> Range<f64> {
    let times = curves.iter().flat_map(|c| &c.points).map(|p| p.0);
    let (first, last) = span(times).unwrap_or((0.0, 1.0));
    first..if last > first { last } else { first + 1.0 }
}

fn bounds(curves: &[Curve]) -> Option<(f64, f64)> {
    let values = curves.iter().flat_map(|c| &c.points).map(|p| p.1);
    span(values.filter(|y| y.is_finite()))
}

/// k of the power 10ᵏ in which values of this size are labelled: 0, if they are long otherwise a multiple of 3.
fn power_of_ten(size: f64) -> i32 {
    match size > 0.0 && !(1e-3..1e5).contains(&size) {
        true => (3 * (size.log10() / 3.0).floor() as i32).clamp(-300, 300),
        false => 0,
    }
}

fn ten_to(power: i32) -> f64 {
    10f64.powi(power)
}

/// A unit with a power of ten before it.
fn in_powers(power: i32, unit: &str) -> String {
    match power {
        0 => unit.to_owned(),
        _ => {
            let power = power.to_string();
            let raised = power.chars().map(|c| match c {
                '1' => '¹',
                '2' => '²',
                '3' => '³',
                '0' | '4'..='9' => char::from_u32(0x2070 + c as u32 - '0' as u32).unwrap_or(c),
                _ => '⁻',
            });
            let raised: String = raised.collect();
            let unit = if unit == "1" { "" } else { unit };
            format!("10{raised} {unit}").trim_end().to_owned()
        }
    }
}

/// The label of a tick on an axis of this length: zero where only round-off is left.
fn tick(value: f64, length: f64, digits: usize) -> String {
    let value = if value.abs() < 1e-9 * length {
        0.0
    } else {
        value
    };
    format!("{value:.digits$}")
}

/// A title that has room above a diagram, before what the diagram shows.
fn caption(title: &str, shows: &str) -> String {
    let room = (WIDTH / LETTER) as usize - shows.chars().count();
    let title: Vec<char> = title.chars().filter(|c| !c.is_control()).collect();
    let cut: String = title.iter().take(room - 1).collect();
    match title.len() > room {
        true => format!("{}…{shows}", cut.trim_end()),
        false => title.iter().collect::<String>() + shows,
    }
}

fn span(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    values.fold(None, |span, x| {
        let (low, high) = span.unwrap_or((x, x));
        Some((low.min(x), high.max(x)))
    })
}

/// The number of decimals with which neighbouring ticks differ.
fn decimals(range: f64) -> usize {
    (1.3 - range.max(f64::MIN_POSITIVE).log10()).ceil().max(0.0) as usize
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Energy;

    fn frames(values: &[f64], step: f64) -> Vec<Frame> {
        let frame = |(i, &kinetic): (usize, &f64)| Frame {
            time: i as f64 * step,
            energy: Energy {
                kinetic,
                ..Energy::default()
            },
            ..Frame::default()
        };
        values.iter().enumerate().map(frame).collect()
    }

    /// Lines of the colour of the kinetic energy.
    fn lines(svg: &str) -> usize {
        svg.matches("stroke=\"#14507D\"").count()
    }

    #[test]
    fn labels_have_a_power_of_ten() {
        assert_eq!([2.0, 99e3, 0.0, 1e-3].map(power_of_ten), [0; 4]);
        assert_eq!(
            [2e5, 5e-4, 1.5e9, 1e-310].map(power_of_ten),
            [3, -6, 9, -300]
        );
        assert_eq!(in_powers(-12, "J"), "10⁻¹² J");
        assert_eq!(
            (in_powers(0, "1"), in_powers(9, "1")),
            ("1".to_owned(), "10⁹".to_owned())
        );
        assert_eq!(tick(6.5e-17, 1.0, 2), "0.00");
        let svg = energy("heavy", &frames(&[-1e9, 2e9], 1e-6)).expect("a picture");
        assert!(svg.contains("energy, 10⁹ J") && svg.contains("time, 10⁻⁶ s"));
        assert!(!svg.contains("1000000"));
    }

    #[test]
    fn values_as_large_as_numbers_are_have_a_picture() {
        assert!(energy("huge", &frames(&[-1.7e308, 1.7e308], 1.0)).is_ok());
    }

    #[test]
    fn curves_end_where_values_are_no_numbers() {
        let whole = energy("whole", &frames(&[1.0, 2.0, 3.0, 2.0, 1.0], 1.0));
        let parted = energy("parted", &frames(&[1.0, 2.0, f64::NAN, 2.0, 1.0], 1.0));
        let [whole, parted] = [whole, parted].map(|svg| lines(&svg.expect("a picture")));
        assert_eq!(parted, whole + 1);
    }

    #[test]
    fn titles_have_room_above_a_diagram() {
        let long = caption(&"a\u{1}bc ".repeat(40), ": energy");
        assert!(
            title_width(&long) <= WIDTH && long.ends_with("…: energy"),
            "{long}"
        );
        assert!(!long.contains('\u{1}'));
        assert_eq!(caption("short", ": energy"), "short: energy");
    }
}
