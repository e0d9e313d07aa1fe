//! The mechanism beside the panels of a figure, where it starts.

use crate::laboratory::svg::{Anchor, GRID, INK, Svg};

const BAR: &str = "#14507d";
const MUTED: &str = "#5b6169";
/// Width of a bar, half the width of a mark of the ground, and half that of a mass, px.
const WIDTH: f64 = 5.0;
const GROUND: f64 = 9.0;
const MASS: f64 = 8.0;
/// Room around the mechanism, px.
const MARGIN: f64 = 34.0;

/// Points, m, and what joins them.
pub struct Sketch {
    /// With the names of the paper; space is seen from the front, a little from the side and from above.
    pub points: &'static [(&'static str, [f64; 3])],
    /// By indices of points.
    pub bars: &'static [[usize; 2]],
    /// Points on the ground.
    pub grounds: &'static [usize],
    /// Points with a mass of their own.
    pub masses: &'static [usize],
    /// A guide through these points.
    pub guide: Option<[usize; 2]>,
    /// The velocity of these points at the start, to the right.
    pub arrows: &'static [usize],
}

/// On paper.
fn seen([x, y, z]: [f64; 3]) -> [f64; 2] {
    let (side, above) = (0.55_f64, 0.35_f64);
    let (across, away) = (
        x * side.cos() + z * side.sin(),
        z * side.cos() - x * side.sin(),
    );
    [across, y * above.cos() - away * above.sin()]
}

/// Draws it into a frame: left, top, width and height, px.
pub fn sketch(svg: &mut Svg, [left, top, width, height]: [f64; 4], sketch: &Sketch) {
    let flat = sketch.points.iter().all(|(_, point)| point[2] == 0.0);
    let project = |point: [f64; 3]| {
        if flat {
            [point[0], point[1]]
        } else {
            seen(point)
        }
    };
    let places: Vec<[f64; 2]> = sketch.points.iter().map(|p| project(p.1)).collect();
    let bound = |axis: usize| {
        let values = places.iter().map(|place| place[axis]);
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| {
            [low.min(x), high.max(x)]
        })
    };
    let ([x0, x1], [y0, y1]) = (bound(0), bound(1));
    let room = [width - 2.0 * MARGIN, height - 2.0 * MARGIN];
    let scale = (room[0] / (x1 - x0).max(1e-9)).min(room[1] / (y1 - y0).max(1e-9));
    let at = |i: usize| {
        let [x, y] = places[i];
        [
            left + 0.5 * width + scale * (x - 0.5 * (x0 + x1)),
            top + 0.5 * height - scale * (y - 0.5 * (y0 + y1)),
        ]
    };
    svg.rect([left, top], [width, height], "#fafaf7");
    if let Some([from, to]) = sketch.guide {
        let ([a, y], [b, _]) = (at(from), at(to));
        svg.line([a - 24.0, y], [b + 30.0, y], GRID, 2.0);
    }
    for &i in sketch.grounds {
        let [x, y] = at(i);
        let base = y + GROUND + 4.0;
        let triangle = [[x, y], [x - GROUND, base], [x + GROUND, base], [x, y]];
        svg.path(&triangle, MUTED, 1.5, "");
        svg.line([x - 14.0, base], [x + 14.0, base], MUTED, 2.0);
    }
    for &[from, to] in sketch.bars {
        svg.path(&[at(from), at(to)], BAR, WIDTH, "");
    }
    for &i in sketch.masses {
        let [x, y] = at(i);
        svg.rect([x - MASS, y - MASS], [2.0 * MASS, 2.0 * MASS], BAR);
    }
    for &i in sketch.arrows {
        let [x, y] = at(i);
        let (from, to) = ([x, y - 12.0], [x + 34.0, y - 12.0]);
        svg.line(from, to, INK, 1.5);
        let head = [[to[0] - 7.0, to[1] - 4.0], to, [to[0] - 7.0, to[1] + 4.0]];
        svg.path(&head, INK, 1.5, "");
    }
    for (i, (name, _)) in sketch.points.iter().enumerate() {
        let [x, y] = at(i);
        svg.rect([x - 2.5, y - 2.5], [5.0, 5.0], "#fff");
        let aside = if sketch.grounds.contains(&i) {
            -24.0
        } else {
            9.0
        };
        svg.text([x + aside, y - 7.0], 13.0, Anchor::Start, INK, name);
    }
    // Gravity points down in all of them.
    let [x, y] = [left + width - 18.0, top + 20.0];
    svg.line([x, y], [x, y + 34.0], MUTED, 1.5);
    svg.path(
        &[[x - 4.0, y + 27.0], [x, y + 34.0], [x + 4.0, y + 27.0]],
        MUTED,
        1.5,
        "",
    );
    svg.text([x - 6.0, y + 22.0], 13.0, Anchor::End, MUTED, "g");
}
