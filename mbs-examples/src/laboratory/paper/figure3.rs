//! The slider-crank: effective masses of its rows, and runs with a tenth of them.

use mbs_runtime::{Method, PaperSettings};

use super::column::Column;
use super::run::{Extent, Run, SLIDER_CRANK, STEP, TWO_LEVEL, algorithm};
use super::{Curve, Figure, Panel, Scale};

/// The first and the largest penalty (section 7.2).
pub const PENALTIES: [f64; 2] = [1e3, 1e5];
/// s
pub const SPAN: f64 = 45.0;
const MASSES: [(&str, f64); 3] = [("m̄", 1.0), ("m̄/10", 0.1), ("m̄/100", 0.01)];
/// Rows whose effective masses are drawn; each of the other rows has one of these values.
const SHOWN: [&str; 9] = [
    "ground_joint.y",
    "ground_joint.rotation_z",
    "bearing.x",
    "bearing.y",
    "pin.x",
    "pin.y",
    "pin.rotation_x",
    "gudgeon.x",
    "guide.rotation_z",
];
const WATCHED: [(Column, &str); 6] = [
    (Column::Penalty("bearing.x"), "bearing.x"),
    (Column::Penalty("pin.x"), "pin.x"),
    (Column::Penalty("pin.y"), "pin.y"),
    (Column::Penalty("gudgeon.y"), "gudgeon.y"),
    (Column::Penalty("guide.y"), "guide.y"),
    (Column::Penalty("guide.rotation_z"), "guide.rotation_z"),
];

pub fn figure(extent: Extent) -> Figure {
    let instants = extent.instants(0.0, SPAN, 900);
    let mut turn = extent.instants(0.0, 2.5, 125);
    turn.extend(instants.iter().copied().filter(|&t| t > extent.time(2.5)));
    let run = |(label, mass_scale): (&'static str, f64)| {
        let settings = PaperSettings {
            mass_scale,
            ..algorithm(PENALTIES[0], PENALTIES[1])
        };
        Run::new(label, Method::Paper(settings), STEP, &instants)
    };
    let mut runs = vec![Run::new(TWO_LEVEL, Method::TwoLevel, STEP, &turn)];
    runs.extend(MASSES.map(run));
    let all: Vec<Column> = SLIDER_CRANK
        .model
        .rows
        .iter()
        .map(|row| Column::Mass(row.name))
        .collect();
    let masses = SHOWN.map(|row| Curve {
        label: row.to_owned(),
        run: TWO_LEVEL,
        column: Column::Mass(row),
    });
    let window = [0.0, extent.time(SPAN)];
    let names = MASSES.map(|mass| mass.0);
    let theta = Column::Output("theta");
    Figure {
        number: 3,
        title: "slider-crank, 24 velocities and 26 rows",
        caption: &[
            "Algorithm 1 with steps of 1e-3 s and the accuracy of 0.01;",
            "penalties begin with 1000 and may grow to 1e5.",
        ],
        subject: &SLIDER_CRANK,
        columns: [
            vec![Column::Energy, Column::EnergyError, Column::Step, theta],
            WATCHED.map(|p| p.0).to_vec(),
            all,
        ]
        .concat(),
        runs,
        ensemble: &["m̄", "m̄/10", "m̄/100"],
        panels: vec![
            Panel {
                title: "effective masses of rows",
                across: Some(theta),
                axes: ["crank angle θ, degrees", "m̄, kg or kg m²"],
                curves: masses.into(),
                window: [-180.0, 180.0],
                scale: Scale::Decades(-8, 2),
            },
            Panel::of_runs(
                "shortest step",
                "step, s",
                Column::Step,
                &names,
                window,
                Scale::Decades(-7, -2),
            ),
            Panel::of_runs(
                "mechanical energy",
                "T + V, J",
                Column::Energy,
                &[&[TWO_LEVEL], &names[..]].concat(),
                window,
                Scale::Between(6.0, 15.0),
            ),
            Panel::of_columns(
                "penalties, m̄/10",
                "ξ",
                "m̄/10",
                &WATCHED,
                window,
                Scale::Decades(2, 6),
            ),
        ],
    }
}
