//! The pendulum with other effective masses of the rows, and with constant penalties.

use mbs_runtime::{Method, PaperSettings};

use super::column::Column;
use super::run::{Extent, HEAVY_BOB, PENDULUM, Run, STEP, TWO_LEVEL, algorithm};
use super::{Figure, Panel, Scale};

/// The largest penalty, if penalties may grow.
const MOST: f64 = 1e9;
/// Used instead of m̄ = 0, for which a row has no force.
const NOTHING: f64 = 1e-12;
const PENALTIES: [(Column, &str); 6] = [
    (Column::Penalty("pivot.x"), "pivot.x"),
    (Column::Penalty("pivot.y"), "pivot.y"),
    (Column::Penalty("pivot.z"), "pivot.z"),
    (Column::Penalty("pivot.rotation_x"), "pivot.rotation_x"),
    (Column::Penalty("ground_joint.x"), "ground_joint.x"),
    (
        Column::Penalty("ground_joint.rotation_z"),
        "ground_joint.rotation_z",
    ),
];
const FREE: [(&str, f64); 4] = [
    ("m̄", 1.0),
    ("m̄/10", 0.1),
    ("m̄/100", 0.01),
    ("m̄ = 0", NOTHING),
];
/// Label, factor on m̄, penalty.
const CONSTANT: [(&str, f64, f64); 13] = [
    ("m̄; ξ = 100", 1.0, 1e2),
    ("m̄/10; ξ = 1", 0.1, 1.0),
    ("m̄/10; ξ = 10", 0.1, 1e1),
    ("m̄/10; ξ = 100", 0.1, 1e2),
    ("m̄/10; ξ = 1e4", 0.1, 1e4),
    ("m̄/10; ξ = 1e6", 0.1, 1e6),
    ("m̄/10; ξ = 1e8", 0.1, 1e8),
    ("m̄/10; ξ = 1e10", 0.1, 1e10),
    ("10 m̄; ξ = 100", 10.0, 1e2),
    ("m̄/100; ξ = 100", 0.01, 1e2),
    ("m̄ = 0; ξ = 100", NOTHING, 1e2),
    ("m̄; ξ = 10", 1.0, 1e1),
    ("m̄; ξ = 1", 1.0, 1.0),
];

pub fn figure(extent: Extent) -> Figure {
    let instants = extent.instants(0.0, 10.0, 200);
    let run = |label, mass_scale, settings| {
        let settings = PaperSettings {
            mass_scale,
            ..settings
        };
        Run::new(label, Method::Paper(settings), STEP, &instants)
    };
    let free = FREE.map(|(label, scale)| run(label, scale, algorithm(100.0, MOST)));
    let constant =
        CONSTANT.map(|(label, scale, penalty)| run(label, scale, algorithm(penalty, penalty)));
    let mut point = run("point mass: m̄; ξ = 100", 1.0, algorithm(100.0, 100.0));
    point.subject = Some(&PENDULUM);
    let two_level = Run::new(TWO_LEVEL, Method::TwoLevel, STEP, &instants);
    let window = [0.0, extent.time(10.0)];
    let steps = Scale::Decades(-7, -2);
    let of_penalty: Vec<&str> = CONSTANT[..8].iter().map(|c| c.0).collect();
    let of_mass = [0, 8, 3, 9, 10].map(|i: usize| CONSTANT[i].0);
    let step = |title, runs: &[&'static str]| {
        Panel::of_runs(title, "step, s", Column::Step, runs, window, steps)
    };
    let energy = |title, runs: &[&'static str], scale| {
        Panel::of_runs(
            title,
            "|energy error|, J",
            Column::EnergyError,
            runs,
            window,
            scale,
        )
    };
    let with_two_level = |runs: &[&'static str]| [&[TWO_LEVEL], runs].concat();
    Figure {
        number: 2,
        title: "pendulum, other effective masses and penalties",
        caption: &[
            "Algorithm 1 with steps of 1e-3 s and the accuracy of 0.01.",
            "A bob of 0.1 kg m²: its rows have m̄ = 0.09 kg at O.",
        ],
        subject: &HEAVY_BOB,
        columns: [
            vec![Column::EnergyError, Column::Step],
            PENALTIES.map(|p| p.0).to_vec(),
        ]
        .concat(),
        runs: [
            vec![two_level],
            free.to_vec(),
            constant.to_vec(),
            vec![point],
        ]
        .concat(),
        ensemble: &["m̄", "m̄/10", "m̄/100"],
        panels: vec![
            step("shortest step, penalties free", &FREE.map(|f| f.0)),
            Panel::of_columns(
                "penalties, m̄/10",
                "ξ",
                "m̄/10",
                &PENALTIES,
                window,
                Scale::Decades(0, 10),
            ),
            step("shortest step, constant penalties", &of_penalty),
            energy(
                "energy error, constant penalties",
                &with_two_level(&of_penalty),
                Scale::Decades(-12, 1),
            ),
            step("shortest step, ξ = 100", &of_mass),
            energy(
                "energy error, ξ = 100",
                &with_two_level(&of_mass),
                Scale::Decades(-12, 1),
            ),
        ],
    }
}
