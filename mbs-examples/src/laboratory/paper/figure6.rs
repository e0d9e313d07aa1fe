//! The double four-bar.

use super::column::Column;
use super::run::{
    COLD, DOUBLE_FOUR_BAR, Extent, FREE, INDEX3, M_ALF, METHODS, PAPER, PENALTY, Run, STEP,
    TWO_LEVEL, methods,
};
use super::{Curve, Figure, Panel, Scale};

/// All methods, over ten seconds finely and then coarsely to the end.
pub fn runs(extent: Extent, end: f64) -> Vec<Run> {
    let mut instants = extent.instants(0.0, 10.0, 250);
    instants.extend(extent.instants(10.0, end, 180));
    methods(PENALTY, STEP, FREE, &instants)
}

/// Components of a point by three methods.
pub fn components(
    title: &'static str,
    axis: &'static str,
    columns: &[(Column, &str)],
    window: [f64; 2],
) -> Panel {
    let mut curves = Vec::new();
    for run in [TWO_LEVEL, INDEX3, PAPER] {
        for &(column, name) in columns {
            let label = format!("{run}, {name}");
            curves.push(Curve { label, run, column });
        }
    }
    Panel::over_time(title, axis, curves, window, Scale::Linear)
}

pub fn figure(extent: Extent) -> Figure {
    let place = [(Column::Output("p1.x"), "x"), (Column::Output("p1.y"), "y")];
    let velocity = [
        (Column::Output("p1_velocity.x"), "x"),
        (Column::Output("p1_velocity.y"), "y"),
    ];
    let first = [0.0, extent.time(10.0)];
    let energy = |title, window, scale| {
        let axis = "|energy error|, J";
        Panel::of_runs(title, axis, Column::EnergyError, &METHODS, window, scale)
    };
    Figure {
        number: 6,
        title: "double four-bar, 36 velocities and 36 rows",
        caption: &[
            "Steps of 1e-3 s, accuracy 0.01; BDF chooses its steps.",
            "P₁ to P₃ begin with 1 m/s to the right.",
        ],
        subject: &DOUBLE_FOUR_BAR,
        columns: [
            vec![Column::EnergyError, Column::Output("branch")],
            place.map(|p| p.0).to_vec(),
            velocity.map(|p| p.0).to_vec(),
        ]
        .concat(),
        runs: runs(extent, 100.0),
        ensemble: &[PAPER, COLD, M_ALF, INDEX3],
        panels: vec![
            components("position of P₁", "m", &place, first),
            components("velocity of P₁", "m/s", &velocity, first),
            energy(
                "error of the mechanical energy",
                first,
                Scale::Decades(-12, 2),
            ),
            energy(
                "the same, longer",
                [0.0, extent.time(100.0)],
                Scale::Decades(-12, 2),
            ),
        ],
    }
}
