//! The pendulum over a thousand seconds.

use super::column::Column;
use super::exact;
use super::run::{BDF, Extent, M_ALF, PENDULUM, Run, STEP, STRICT, Source, TWO_LEVEL};
use super::run::{METHODS, methods};
use super::{Figure, Panel, Scale};

const Y: Column = Column::Output("y");
const FORCE: [Column; 2] = [
    Column::Reaction("pivot", "fx"),
    Column::Reaction("pivot", "fy"),
];
/// φ of the two rows of the pivot in the plane, and their rates.
const ROW: [Column; 2] = [Column::Row("pivot.x"), Column::Row("pivot.y")];
const RATE: [Column; 2] = [Column::Rate("pivot.x"), Column::Rate("pivot.y")];
const EXACT: &str = "exact";

pub fn figure(extent: Extent) -> Figure {
    let mut instants = extent.instants(0.0, 990.0, 198);
    instants.extend(extent.instants(990.0, 1000.0, 200));
    let mut runs = vec![Run {
        label: EXACT,
        subject: None,
        source: Source::Exact(exact::pendulum),
        instants: instants.clone(),
    }];
    runs.extend(methods(100.0, STEP, &instants));
    let whole = [0.0, extent.time(1000.0)];
    let last = [extent.time(990.0), extent.time(1000.0)];
    let beside = [TWO_LEVEL, STRICT, M_ALF, BDF[0], BDF[1], EXACT];
    let rows = |title, axis, columns: [Column; 2]| {
        let names = ["x", "y"];
        let mut curves = Vec::new();
        for run in [TWO_LEVEL, STRICT, M_ALF, BDF[0]] {
            for (column, name) in columns.into_iter().zip(names) {
                let label = format!("{run}, {name}");
                curves.push(super::Curve { label, run, column });
            }
        }
        Panel {
            title,
            across: None,
            axes: ["time, s", axis],
            curves,
            window: last,
            scale: Scale::Decades(-18, 2),
        }
    };
    let late =
        |title, axis, column, scale| Panel::of_runs(title, axis, column, &beside, last, scale);
    Figure {
        number: 1,
        title: "pendulum, 12 velocities and 11 rows",
        subject: &PENDULUM,
        columns: [
            vec![Column::EnergyError, Y],
            FORCE.to_vec(),
            ROW.to_vec(),
            RATE.to_vec(),
        ]
        .concat(),
        runs,
        panels: vec![
            Panel::of_runs(
                "error of the mechanical energy",
                "energy error, J",
                Column::EnergyError,
                &METHODS,
                whole,
                Scale::Between(-10.5, 2.5),
            ),
            late(
                "height of the particle, later",
                "y, m",
                Y,
                Scale::Between(-1.1, 0.3),
            ),
            late(
                "horizontal reaction at O",
                "force on the pendulum, N",
                FORCE[0],
                Scale::Between(-20.0, 20.0),
            ),
            late(
                "vertical reaction at O",
                "force on the pendulum, N",
                FORCE[1],
                Scale::Between(-5.0, 35.0),
            ),
            rows("rows of the reaction at O", "|φ|, m", ROW),
            rows("their rates", "|φ̇|, m/s", RATE),
        ],
    }
}
