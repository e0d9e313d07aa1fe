//! A diagram of errors over processor times, both logarithmic. Runs that failed are on its upper edge.

use super::svg::{Anchor, GRID, INK, Marker, Svg};
use super::work_precision::Point;

const SIZE: [f64; 2] = [1060.0, 640.0];
const LEFT: f64 = 92.0;
const RIGHT: f64 = 760.0;
const TOP: f64 = 92.0;
const BOTTOM: f64 = 570.0;
/// Room for the failed runs, between the frame and the largest error.
const FAILED: f64 = 26.0;
/// Smaller errors are drawn at this value.
const FLOOR: f64 = 1e-16;

/// The error of a point that is drawn.
#[derive(Debug, Clone, Copy)]
pub struct Measure {
    /// Index into [`Point::errors`].
    pub index: usize,
    /// Name in file names and switches.
    pub name: &'static str,
    /// Label of the axis.
    pub axis: &'static str,
}

/// Position, energy and reaction.
pub const MEASURES: [Measure; 3] = [
    Measure {
        index: 0,
        name: "position",
        axis: "largest position error, m or rad",
    },
    Measure {
        index: 1,
        name: "energy",
        axis: "largest energy error, J",
    },
    Measure {
        index: 2,
        name: "reaction",
        axis: "largest reaction error, relative",
    },
];

/// The style of a method: the colour shows the family, marker and dash the member; the styles differ also in grey.
fn looks(label: &str) -> (&'static str, Marker, &'static str, f64) {
    match label {
        "accuracy" => ("#c2185b", Marker::Disk, "", 3.2),
        "two-level 2" => ("#14507d", Marker::Disk, "", 2.6),
        "two-level 4" => ("#14507d", Marker::Square, "9 3", 2.6),
        "two-level 6" => ("#14507d", Marker::Triangle, "5 3", 2.6),
        "two-level 8" => ("#14507d", Marker::Diamond, "2 3", 2.6),
        "two-level tolerance" => ("#2f9be0", Marker::Ring, "", 2.2),
        "projected 4" => ("#e08e2e", Marker::Square, "9 3", 2.0),
        "projected 6" => ("#e08e2e", Marker::Triangle, "5 3", 2.0),
        "projected 8" => ("#e08e2e", Marker::Diamond, "2 3", 2.0),
        "baumgarte 4" => ("#8a6d1f", Marker::Frame, "9 3", 1.4),
        "baumgarte 8" => ("#8a6d1f", Marker::Funnel, "2 3", 1.4),
        "baumgarte adaptive" => ("#8a6d1f", Marker::Ring, "", 1.4),
        "rattle" => ("#3c9c8f", Marker::Ring, "", 2.0),
        "alf3f-paper" => ("#b3202a", Marker::Cross, "", 2.0),
        "alf3f-paper 1e4" => ("#b3202a", Marker::Cross, "5 3", 1.6),
        "m-alf" => ("#e2737b", Marker::Plus, "6 2 2 2", 2.0),
        "index3-projections" => ("#6f7680", Marker::Cross, "6 2 2 2", 1.8),
        "generalized-alpha" => ("#7b4b9e", Marker::Frame, "", 1.8),
        "generalized-alpha stab." => ("#7b4b9e", Marker::Plus, "6 3", 1.8),
        "bdf" => ("#2f8a3d", Marker::Funnel, "", 1.8),
        "radau" => ("#2f8a3d", Marker::Diamond, "5 3", 2.0),
        _ => ("#a9a294", Marker::Plus, "", 1.6),
    }
}

/// Log-log axes over the area of the diagram.
struct Axes {
    x: [i32; 2],
    y: [i32; 2],
}

impl Axes {
    fn place(&self, x: f64, y: f64) -> [f64; 2] {
        let part = |v: f64, [low, high]: [i32; 2]| {
            let v = v.log10().clamp(f64::from(low), f64::from(high));
            (v - f64::from(low)) / f64::from(high - low)
        };
        [
            LEFT + part(x, self.x) * (RIGHT - LEFT),
            BOTTOM - part(y, self.y) * (BOTTOM - TOP - FAILED),
        ]
    }
}

/// The diagram of a scene; `labels` are the methods in the order of the legend.
pub fn draw(
    title: &str,
    note: &str,
    labels: &[&str],
    points: &[Point],
    measure: Measure,
) -> String {
    let value = |point: &Point| point.errors[measure.index].max(FLOOR);
    let ok: Vec<&Point> = points
        .iter()
        .filter(|p| p.outcome == super::outcome::Outcome::Ok && value(p).is_finite())
        .collect();
    let axes = Axes {
        x: decades(ok.iter().map(|p| 1e3 * p.cpu)),
        y: decades(ok.iter().map(|p| value(p))),
    };
    let mut svg = Svg::new(SIZE[0], SIZE[1]);
    frame(&mut svg, &axes, title, note, measure);
    for (i, &label) in labels.iter().enumerate() {
        let (colour, marker, dash, width) = looks(label);
        let mut own: Vec<&&Point> = ok.iter().filter(|p| p.method == label).collect();
        own.sort_by(|a, b| b.value.total_cmp(&a.value));
        let line: Vec<[f64; 2]> = own
            .iter()
            .map(|p| axes.place(1e3 * p.cpu, value(p)))
            .collect();
        svg.path(&line, colour, width, dash);
        for place in &line {
            svg.marker(marker, *place, colour);
        }
        let failed = points
            .iter()
            .filter(|p| p.method == label && p.outcome.is_failure());
        let failed: Vec<f64> = failed
            .map(|p| axes.place(1e3 * p.cpu.max(1e-9), 1.0)[0])
            .collect();
        for &x in &failed {
            svg.marker(marker, [x, TOP + 0.5 * FAILED], colour);
        }
        legend(&mut svg, i, label, own.len(), failed.len());
    }
    svg.finish(title)
}

fn legend(svg: &mut Svg, i: usize, label: &str, ok: usize, failed: usize) {
    let (colour, marker, dash, width) = looks(label);
    let y = TOP + 4.0 + 24.0 * i as f64;
    let x = RIGHT + 16.0;
    svg.path(&[[x, y], [x + 34.0, y]], colour, width, dash);
    svg.marker(marker, [x + 17.0, y], colour);
    let shown = match (ok, failed) {
        (0, 0) => format!("{label} –"),
        (_, 0) => label.to_owned(),
        (_, failed) => format!("{label} ({failed} ✗)"),
    };
    svg.text([x + 42.0, y + 5.0], 14.0, Anchor::Start, INK, &shown);
}

fn frame(svg: &mut Svg, axes: &Axes, title: &str, note: &str, measure: Measure) {
    svg.text([LEFT, 32.0], 20.0, Anchor::Start, INK, title);
    svg.text([LEFT, 56.0], 13.0, Anchor::Start, "#5b6169", note);
    svg.rect([LEFT, TOP], [RIGHT - LEFT, FAILED], "#f3e3e1");
    svg.text(
        [LEFT + 6.0, TOP - 6.0],
        13.0,
        Anchor::Start,
        "#5b6169",
        "failed runs are in this band",
    );
    let every = |[low, high]: [i32; 2]| ((high - low) as usize).div_ceil(9).max(1);
    for decade in (axes.x[0]..=axes.x[1]).step_by(every(axes.x)) {
        let [x, _] = axes.place(10_f64.powi(decade), 1.0);
        svg.line([x, TOP], [x, BOTTOM], GRID, 1.0);
        svg.text(
            [x, BOTTOM + 22.0],
            15.0,
            Anchor::Middle,
            INK,
            &power(decade),
        );
    }
    for decade in (axes.y[0]..=axes.y[1]).step_by(every(axes.y)) {
        let [_, y] = axes.place(1.0, 10_f64.powi(decade));
        svg.line([LEFT, y], [RIGHT, y], GRID, 1.0);
        svg.text(
            [LEFT - 8.0, y + 5.0],
            15.0,
            Anchor::End,
            INK,
            &power(decade),
        );
    }
    let corners = [
        [LEFT, TOP],
        [RIGHT, TOP],
        [RIGHT, BOTTOM],
        [LEFT, BOTTOM],
        [LEFT, TOP],
    ];
    svg.path(&corners, INK, 1.2, "");
    let middle = 0.5 * (LEFT + RIGHT);
    svg.text(
        [middle, BOTTOM + 50.0],
        16.0,
        Anchor::Middle,
        INK,
        "processor time of the run, ms",
    );
    svg.upright([26.0, 0.5 * (TOP + BOTTOM)], 16.0, measure.axis);
}

/// `1e-3`, but 1, 10 and 100 as they are.
fn power(decade: i32) -> String {
    match decade {
        0..=3 => format!("{}", 10_i32.pow(decade as u32)),
        _ => format!("1e{decade}"),
    }
}

/// Whole decades around the values.
fn decades(values: impl Iterator<Item = f64>) -> [i32; 2] {
    let (low, high) = values
        .filter(|v| *v > 0.0 && v.is_finite())
        .fold((f64::INFINITY, 0.0), |(low, high): (f64, f64), v| {
            (low.min(v), high.max(v))
        });
    if low > high {
        return [-3, 3];
    }
    let [low, high] = [low.log10().floor() as i32, high.log10().ceil() as i32];
    [low, high.max(low + 1)]
}
