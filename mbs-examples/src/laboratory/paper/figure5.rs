//! The slider-crank: the force at the pin P₂, with two steps, and its rows.

use super::column::Column;
use super::figure3::PENALTIES;
use super::run::{BDF, Extent, METHODS, PAPER, Run, SLIDER_CRANK, STEP, TWO_LEVEL, methods};
use super::{Curve, Figure, Panel, Scale};

/// From the change of momentum, the same for every method.
const FORCE: [Column; 2] = [
    Column::StepReaction("pin", "fx"),
    Column::StepReaction("pin", "fy"),
];
/// From the multipliers of each method.
const OWN: [Column; 2] = [Column::OwnPeak("pin", "fx"), Column::OwnPeak("pin", "fy")];
/// The twelfth and the thirteenth row, as in the paper.
const ROW: [Column; 2] = [Column::Row("pin.x"), Column::Row("pin.y")];
const RATE: [Column; 2] = [Column::Rate("pin.x"), Column::Rate("pin.y")];
/// [`METHODS`] with half the step.
const HALVED: [&str; 8] = [
    "two-level h/2",
    "alf3f-paper h/2",
    "alf3f-paper cold h/2",
    "m-alf h/2",
    "index3-projections h/2",
    "bdf h/2",
    "bdf order ≤ 2 h/2",
    "bdf order 1 h/2",
];
/// Of [`METHODS`], those whose forces are drawn.
const DRAWN: [usize; 6] = [0, 1, 3, 5, 6, 7];
const MOST: f64 = 300.0;

pub fn figure(extent: Extent) -> Figure {
    let instants = extent.instants(0.0, 20.0, 500);
    let mut runs = methods(PENALTIES[0], STEP, STEP, &instants);
    let halved = methods(PENALTIES[0], 0.5 * STEP, 0.5 * STEP, &instants);
    runs.extend(
        halved
            .into_iter()
            .zip(HALVED)
            .map(|(run, label)| Run { label, ..run }),
    );
    let window = [0.0, extent.time(10.0)];
    let force = |title, column, runs: &[&'static str; 8]| {
        let curve = |i: usize| Curve {
            label: METHODS[i].to_owned(),
            run: runs[i],
            column,
        };
        Panel {
            title,
            across: None,
            axes: ["time, s", "force on the rod, N"],
            curves: DRAWN.map(curve).into(),
            window,
            scale: Scale::Between(-MOST, MOST),
        }
    };
    let rows = |title, axis, columns: [Column; 2]| {
        let mut curves = Vec::new();
        for run in [TWO_LEVEL, PAPER, BDF[0]] {
            for (column, name) in columns.into_iter().zip(["x", "y"]) {
                let label = format!("{run}, {name}");
                curves.push(Curve { label, run, column });
            }
        }
        Panel::over_time(title, axis, curves, window, Scale::Decades(-18, 0))
    };
    Figure {
        number: 5,
        title: "slider-crank, the force at the pin of both rods",
        caption: &[
            "Accuracy 0.01; BDF takes steps of h at most.",
            "a to d: from the multipliers of each method;",
            "e: from the change of momentum. The largest of 0.04 s.",
        ],
        subject: &SLIDER_CRANK,
        columns: [
            vec![Column::EnergyError],
            FORCE.to_vec(),
            OWN.to_vec(),
            ROW.to_vec(),
            RATE.to_vec(),
        ]
        .concat(),
        runs,
        ensemble: &[],
        panels: vec![
            force("horizontal force, h = 1e-3 s", OWN[0], &METHODS),
            force("vertical force, h = 1e-3 s", OWN[1], &METHODS),
            force("horizontal force, h = 5e-4 s", OWN[0], &HALVED),
            force("vertical force, h = 5e-4 s", OWN[1], &HALVED),
            force(
                "vertical, from the change of momentum, 1e-3 s",
                FORCE[1],
                &METHODS,
            ),
            force("the same, h = 5e-4 s", FORCE[1], &HALVED),
            rows("rows 12 and 13, of the pin", "|φ|, m", ROW),
            rows("their rates", "|φ̇|, m/s", RATE),
        ],
    }
}
