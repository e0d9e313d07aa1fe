//! A picture of an outcome map: each cell has the colour and the letter of its outcome. A cell
//! of which every failed run stopped with an error of its own has a frame of this colour; the others are filled.

use super::outcome::Outcome;
use super::stability::{Cell, Map};
use super::svg::{Anchor, INK, Svg};

const LEFT: f64 = 292.0;
const TOP: f64 = 70.0;
const CELL: [f64; 2] = [84.0, 24.0];
const FRAME: f64 = 3.0;
const MUTED: &str = "#5b6169";

/// Colour, ink and letter; the lightness differs between outcomes.
fn looks(outcome: Outcome) -> (&'static str, &'static str, &'static str) {
    match outcome {
        Outcome::Ok => ("#e4f0e2", INK, "✓"),
        Outcome::WrongBranch => ("#e9b04c", INK, "W"),
        Outcome::Drift => ("#8fb6dd", INK, "D"),
        Outcome::EnergyGrowth => ("#a3202c", "#fff", "E"),
        Outcome::StepUnderflow => ("#6b4a94", "#fff", "U"),
        Outcome::NoConvergence => ("#2b2f36", "#fff", "N"),
        Outcome::TooSlow => ("#f7f7f5", MUTED, "slow"),
        Outcome::Refused => ("#f7f7f5", MUTED, "–"),
    }
}

/// The picture.
pub fn draw(map: &Map, cells: &[Cell]) -> String {
    let right = LEFT + CELL[0] * map.columns.len() as f64;
    let bottom = TOP + CELL[1] * map.rows.len() as f64;
    let mut svg = Svg::new((right + 24.0).max(860.0), bottom + 136.0);
    svg.text([12.0, 30.0], 19.0, Anchor::Start, INK, map.title);
    for (j, column) in map.columns.iter().enumerate() {
        let x = LEFT + CELL[0] * (j as f64 + 0.5);
        svg.text([x, TOP - 9.0], 14.0, Anchor::Middle, INK, &shown(*column));
    }
    for (i, row) in map.rows.iter().enumerate() {
        let y = TOP + CELL[1] * i as f64;
        svg.text([LEFT - 10.0, y + 17.0], 14.0, Anchor::End, INK, row);
        for (j, column) in map.columns.iter().enumerate() {
            let found = cells.iter().find(|c| c.row == *row && c.column == *column);
            if let Some(cell) = found {
                draw_cell(&mut svg, [LEFT + CELL[0] * j as f64, y], cell);
            }
        }
    }
    svg.text([LEFT, bottom + 24.0], 14.0, Anchor::Start, INK, map.axis);
    legend(&mut svg, bottom + 44.0);
    svg.finish(map.title)
}

fn draw_cell(svg: &mut Svg, [x, y]: [f64; 2], cell: &Cell) {
    let (fill, ink, letter) = looks(cell.outcome);
    let [runs, failed, _] = cell.runs;
    let text = match failed {
        0 => letter.to_owned(),
        _ if runs == 1 => letter.to_owned(),
        _ => format!("{letter} {failed} of {runs}"),
    };
    let stopped = cell.is_stopped();
    field(
        svg,
        [x + 1.0, y + 1.0],
        [CELL[0] - 2.0, CELL[1] - 2.0],
        fill,
        stopped,
    );
    let ink = if stopped { INK } else { ink };
    svg.text(
        [x + 0.5 * CELL[0], y + 17.0],
        13.0,
        Anchor::Middle,
        ink,
        &text,
    );
}

/// A field of this colour, or a frame of it.
fn field(svg: &mut Svg, [x, y]: [f64; 2], [w, h]: [f64; 2], fill: &str, frame: bool) {
    svg.rect([x, y], [w, h], fill);
    if frame {
        svg.rect(
            [x + FRAME, y + FRAME],
            [w - 2.0 * FRAME, h - 2.0 * FRAME],
            "#fff",
        );
    }
}

fn legend(svg: &mut Svg, top: f64) {
    for (i, outcome) in Outcome::ALL.into_iter().enumerate() {
        let (fill, ink, letter) = looks(outcome);
        let x = 12.0 + 208.0 * (i % 4) as f64;
        let y = top + 28.0 * (i / 4) as f64;
        svg.rect([x, y], [40.0, 22.0], fill);
        svg.text([x + 20.0, y + 16.0], 13.0, Anchor::Middle, ink, letter);
        svg.text(
            [x + 48.0, y + 16.0],
            14.0,
            Anchor::Start,
            INK,
            outcome.name(),
        );
    }
    let y = top + 56.0;
    field(svg, [12.0, y], [40.0, 22.0], looks(Outcome::Drift).0, true);
    let words = "a frame: every run that failed stopped with an error of its own";
    svg.text([60.0, y + 16.0], 14.0, Anchor::Start, INK, words);
}

/// Short, and exact for the columns there are.
fn shown(value: f64) -> String {
    match value {
        0.0 => "0".to_owned(),
        1e-3..1e3 => format!("{value}"),
        _ => format!("{value:e}"),
    }
}
