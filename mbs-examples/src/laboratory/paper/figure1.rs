//! The pendulum over a thousand seconds.

use super::column::Column;
use super::exact;
use super::run::{BDF, Extent, FREE, INDEX3, M_ALF, METHODS, PAPER, PENALTY, PENDULUM};
use super::run::{Run, STEP, Source, TWO_LEVEL, methods};
use super::{Curve, Figure, Panel, Scale};

const Y: Column = Column::Output("y");
/// From the state, at acceleration level.
const FORCE: [Column; 2] = [
    Column::Reaction("pivot", "fx"),
    Column::Reaction("pivot", "fy"),
];
/// From the multipliers of the method.
const OWN: [Column; 2] = [Column::Own("pivot", "fx"), Column::Own("pivot", "fy")];
/// φ of the two rows of the pivot in the plane, and their rates.
const ROW: [Column; 2] = [Column::Row("pivot.x"), Column::Row("pivot.y")];
const RATE: [Column; 2] = [Column::Rate("pivot.x"), Column::Rate("pivot.y")];
/// The closed form.
pub const EXACT: &str = "exact";

pub fn figure(extent: Extent) -> Figure {
    let mut instants = extent.instants(0.0, 990.0, 198);
    instants.extend(extent.instants(990.0, 1000.0, 200));
    let mut runs = vec![Run {
        label: EXACT,
        subject: None,
        source: Source::Exact(exact::pendulum),
        instants: instants.clone(),
    }];
    runs.extend(methods(PENALTY, STEP, FREE, &instants));
    let whole = [0.0, extent.time(1000.0)];
    let last = [extent.time(990.0), extent.time(1000.0)];
    let beside = [TWO_LEVEL, PAPER, M_ALF, INDEX3, BDF[0], BDF[1], EXACT];
    let rows = |title, axis, columns: [Column; 2]| {
        let mut curves = Vec::new();
        for run in [TWO_LEVEL, PAPER, M_ALF, BDF[0]] {
            for (column, name) in columns.into_iter().zip(["x", "y"]) {
                let label = format!("{run}, {name}");
                curves.push(Curve { label, run, column });
            }
        }
        Panel::over_time(title, axis, curves, last, Scale::Decades(-18, 2))
    };
    let force = |title, component: usize, scale| {
        let curve = |(run, column): (&'static str, Column)| Curve {
            label: run.to_owned(),
            run,
            column,
        };
        let own = [TWO_LEVEL, PAPER, M_ALF].map(|run| (run, OWN[component]));
        let state = [BDF[0], BDF[1], EXACT].map(|run| (run, FORCE[component]));
        let curves = own.into_iter().chain(state).map(curve).collect();
        Panel::over_time(title, "force on the pendulum, N", curves, last, scale)
    };
    Figure {
        number: 1,
        title: "pendulum, 12 velocities and 11 rows",
        caption: &[
            "Steps of 1e-3 s, accuracy 0.01; BDF chooses its steps.",
            "c and d: two-level, alf3f-paper and m-alf by their own",
            "multipliers, the others from the state.",
        ],
        subject: &PENDULUM,
        columns: [
            vec![Column::EnergyError, Y],
            [FORCE, OWN, ROW, RATE].concat(),
        ]
        .concat(),
        runs,
        ensemble: &[],
        panels: vec![
            Panel::of_runs(
                "error of the mechanical energy",
                "|energy error|, J",
                Column::EnergyError,
                &METHODS,
                whole,
                Scale::Decades(-12, 2),
            ),
            Panel::of_runs(
                "height of the particle, later",
                "y, m",
                Y,
                &beside,
                last,
                Scale::Between(-1.1, 0.3),
            ),
            force("horizontal reaction at O", 0, Scale::Between(-20.0, 20.0)),
            force("vertical reaction at O", 1, Scale::Between(-5.0, 35.0)),
            rows("rows of the reaction at O", "|φ|, m", ROW),
            rows("their rates", "|φ̇|, m/s", RATE),
        ],
    }
}
