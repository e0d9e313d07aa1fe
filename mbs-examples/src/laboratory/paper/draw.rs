//! The picture of a figure: its panels in two columns.

use super::look::{Look, look};
use super::sketch::sketch;
use super::{Figure, Panel, Scale, Stores};
use crate::laboratory::outcome::Outcome;
use crate::laboratory::store::Store;
use crate::laboratory::svg::{Anchor, GRID, INK, Marker, Svg};

const MUTED: &str = "#5b6169";
/// A panel with its margins, px.
const PANEL: [f64; 2] = [540.0, 420.0];
const LEFT: f64 = 84.0;
const RIGHT: f64 = 524.0;
const BOTTOM: f64 = 366.0;
const LEGEND_TOP: f64 = 46.0;
const LEGEND_LINE: f64 = 19.0;
/// An entry's line and what surrounds its text, and the width of a letter, px.
const ENTRY: [f64; 2] = [46.0, 7.4];
/// Height of the part above the panels: the title, and the mechanism.
const TITLE: f64 = 210.0;
/// The frame of the mechanism: its upper left corner, width and height, px.
const SKETCH: [f64; 4] = [700.0, 8.0, 350.0, 190.0];
/// Room above the largest value where the ordinate has decades, in decades.
const ABOVE: f64 = 0.05;
const TEXT: f64 = 13.5;

/// One curve with its values.
struct Drawn {
    label: String,
    look: Look,
    points: Vec<[f64; 2]>,
    failed: bool,
}

/// The picture.
pub fn draw(figure: &Figure, stores: &Stores) -> String {
    let lines = figure.panels.len().div_ceil(2);
    let size = [2.0 * PANEL[0], TITLE + lines as f64 * PANEL[1]];
    let mut svg = Svg::new(size[0], size[1]);
    let title = format!("Figure {}: {}", figure.number, figure.title);
    svg.text([16.0, 30.0], 19.0, Anchor::Start, INK, &title);
    for (i, line) in figure.caption.iter().enumerate() {
        let base = [16.0, 58.0 + 20.0 * i as f64];
        svg.text(base, TEXT, Anchor::Start, MUTED, line);
    }
    sketch(&mut svg, SKETCH, &figure.subject.sketch);
    for (i, panel) in figure.panels.iter().enumerate() {
        let corner = [PANEL[0] * (i % 2) as f64, TITLE + PANEL[1] * (i / 2) as f64];
        let curves = curves(figure, panel, stores);
        draw_panel(&mut svg, corner, i, panel, &curves);
    }
    svg.finish(&title)
}

/// The values of the curves of a panel, within its window.
fn curves(figure: &Figure, panel: &Panel, stores: &Stores) -> Vec<Drawn> {
    let place = |column: &super::Column| figure.columns.iter().position(|c| c == column);
    let across = panel.across.as_ref().and_then(place).map(|i| i + 2);
    let read = |(i, curve): (usize, &super::Curve)| {
        let column = place(&curve.column).map_or(usize::MAX, |i| i + 2);
        let number = |row: &[String], i: usize| row.get(i)?.parse::<f64>().ok();
        let rows = stores.samples.rows().iter().filter(|r| r[0] == curve.run);
        let [low, high] = panel.window;
        let mut points: Vec<[f64; 2]> = rows
            .filter_map(|row| Some([number(row, across.unwrap_or(1))?, number(row, column)?]))
            .filter(|[x, _]| (low..=high).contains(x))
            .collect();
        if across.is_some() {
            points.sort_by(|a, b| a[0].total_cmp(&b[0]));
        }
        let end = end_of(&stores.runs, curve.run);
        let look = look(&curve.label, i);
        let end = end.filter(|&time| time <= high || across.is_some());
        let label = match end {
            Some(time) => {
                let time = (1e3 * time).round() / 1e3;
                format!("{} (✗ {time} s)", curve.label)
            }
            None => curve.label.clone(),
        };
        let failed = end.is_some();
        Drawn {
            label,
            look,
            points,
            failed,
        }
    };
    panel.curves.iter().enumerate().map(read).collect()
}

/// The time at which a run stopped early.
fn end_of(runs: &Store, run: &str) -> Option<f64> {
    let row = runs.find(&[run])?;
    (row[2] != Outcome::Ok.name()).then(|| row[3].parse().unwrap_or(0.0))
}

/// Positions of values in a panel.
struct Axes {
    x: [f64; 2],
    y: [f64; 2],
    decades: bool,
    top: f64,
}

impl Axes {
    fn new(panel: &Panel, curves: &[Drawn], top: f64) -> Self {
        let values = || curves.iter().flat_map(|curve| &curve.points);
        let (y, decades) = match panel.scale {
            Scale::Linear => (padded(span(values().map(|p| p[1]))), false),
            Scale::Between(low, high) => ([low, high], false),
            Scale::Decades(low, high) => {
                let [least, most] = span(values().map(|p| p[1].abs().log10()));
                let low = least.floor().max(f64::from(low));
                let most = (most + ABOVE).ceil().min(f64::from(high));
                ([low, most.max(low + 1.0)], true)
            }
        };
        Axes {
            x: panel.window,
            y,
            decades,
            top,
        }
    }

    /// px from the corner of the panel.
    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let y = if self.decades { y.abs().log10() } else { y };
        let part = |v: f64, [low, high]: [f64; 2]| (v - low) / (high - low);
        let y = part(y, self.y).clamp(0.0, 1.0);
        [
            LEFT + part(x, self.x) * (RIGHT - LEFT),
            BOTTOM - y * (BOTTOM - self.top),
        ]
    }

    /// The visible parts of a curve, each with the points at which it leaves the panel.
    fn lines(&self, points: &[[f64; 2]]) -> Vec<Vec<[f64; 2]>> {
        // Values below the least decade are drawn at it.
        let seen = |&[_, y]: &[f64; 2]| self.decades || (self.y[0]..=self.y[1]).contains(&y);
        let mut lines = vec![Vec::new()];
        for (i, point) in points.iter().enumerate() {
            let beside = [i.checked_sub(1), i.checked_add(1)];
            let near = beside.iter().flatten().filter_map(|&j| points.get(j));
            if seen(point) || near.clone().any(seen) {
                lines[0].push(self.place(*point));
            } else if !lines[0].is_empty() {
                lines.insert(0, Vec::new());
            }
        }
        lines
    }
}

fn draw_panel(svg: &mut Svg, corner: [f64; 2], i: usize, panel: &Panel, curves: &[Drawn]) {
    let at = |[x, y]: [f64; 2]| [corner[0] + x, corner[1] + y];
    let letter = char::from(b'a' + i as u8);
    let title = format!("{letter}) {}", panel.title);
    svg.text(at([16.0, 22.0]), 15.5, Anchor::Start, INK, &title);
    let places = legend(curves);
    let top = places.last().map_or(LEGEND_TOP, |place| place[1]) + 16.0;
    let axes = Axes::new(panel, curves, top);
    grid(svg, &at, panel, &axes);
    for (curve, place) in curves.iter().zip(&places) {
        let (colour, width, dash) = curve.look;
        let line = [at(*place), at([place[0] + 30.0, place[1]])];
        svg.path(&line, colour, width, dash);
        let text = at([place[0] + 36.0, place[1] + 4.5]);
        svg.text(text, TEXT - 0.5, Anchor::Start, INK, &curve.label);
    }
    // The first curves are drawn last, on top.
    for curve in curves.iter().rev() {
        let (colour, width, dash) = curve.look;
        for line in axes.lines(&curve.points) {
            let line: Vec<[f64; 2]> = line.into_iter().map(at).collect();
            svg.path(&line, colour, width, dash);
        }
        if let (true, Some(&end)) = (curve.failed, curve.points.last()) {
            svg.marker(Marker::Cross, at(axes.place(end)), colour);
        }
    }
}

/// Where the entries of the legend begin, line by line.
fn legend(curves: &[Drawn]) -> Vec<[f64; 2]> {
    let [mut x, mut y] = [LEFT, LEGEND_TOP];
    let mut places = Vec::new();
    for curve in curves {
        let width = ENTRY[0] + ENTRY[1] * curve.label.chars().count() as f64;
        if x > LEFT && x + width > RIGHT + 12.0 {
            [x, y] = [LEFT, y + LEGEND_LINE];
        }
        places.push([x, y]);
        x += width;
    }
    places
}

fn grid(svg: &mut Svg, at: &dyn Fn([f64; 2]) -> [f64; 2], panel: &Panel, axes: &Axes) {
    for value in ticks(axes.x) {
        let x = axes.place([value, 1.0])[0];
        svg.line(at([x, axes.top]), at([x, BOTTOM]), GRID, 1.0);
        let below = at([x, BOTTOM + 17.0]);
        svg.text(below, TEXT, Anchor::Middle, INK, &shown(value));
    }
    let values = if axes.decades {
        let every = ((axes.y[1] - axes.y[0]) as usize).div_ceil(7).max(1);
        let powers = (axes.y[0] as i32..=axes.y[1] as i32).step_by(every);
        powers
            .map(|p| (10_f64.powi(p), format!("1e{p}")))
            .collect::<Vec<_>>()
    } else {
        ticks(axes.y).into_iter().map(|v| (v, shown(v))).collect()
    };
    for (value, label) in values {
        let y = axes.place([0.0, value])[1];
        svg.line(at([LEFT, y]), at([RIGHT, y]), GRID, 1.0);
        let beside = at([LEFT - 6.0, y + 4.5]);
        svg.text(beside, TEXT, Anchor::End, INK, &label);
    }
    let corners = [
        [LEFT, axes.top],
        [RIGHT, axes.top],
        [RIGHT, BOTTOM],
        [LEFT, BOTTOM],
        [LEFT, axes.top],
    ];
    svg.path(&corners.map(at), MUTED, 1.0, "");
    let middle = at([0.5 * (LEFT + RIGHT), BOTTOM + 38.0]);
    svg.text(middle, 14.5, Anchor::Middle, INK, panel.axes[0]);
    let upright = at([22.0, 0.5 * (axes.top + BOTTOM)]);
    svg.upright(upright, 14.5, panel.axes[1]);
}

/// The least and the largest of the finite values.
fn span(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let (low, high) = values
        .filter(|v| v.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| {
            (low.min(v), high.max(v))
        });
    if low > high { [0.0, 1.0] } else { [low, high] }
}

/// With room above and below.
fn padded([low, high]: [f64; 2]) -> [f64; 2] {
    let room = 0.06 * (high - low).max(1e-12);
    [low - room, high + room]
}

/// Four to eight round values.
fn ticks([low, high]: [f64; 2]) -> Vec<f64> {
    let rough = (high - low) / 6.0;
    let power = 10_f64.powf(rough.log10().floor());
    let unit = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .find(|unit| unit * power >= rough);
    let unit = unit.unwrap_or(10.0) * power;
    let first = (low / unit - 1e-9).ceil() as i64;
    let last = (high / unit + 1e-9).floor() as i64;
    (first..=last).map(|i| i as f64 * unit).collect()
}

/// Short.
fn shown(value: f64) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        1e-3..1e5 => format!("{}", (value * 1e6).round() / 1e6),
        _ => format!("{value:.0e}"),
    }
}
