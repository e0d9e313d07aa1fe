//! The slider-crank with penalties that stay as they are, and with M-ALF.

use mbs_runtime::{Method, PaperSettings};

use super::column::Column;
use super::figure3::PENALTIES;
use super::run::{
    Extent, M_ALF, PAPER, Run, SLIDER_CRANK, STEP, STRICT, TWO_LEVEL, algorithm, m_alf, strict,
};
use super::{Figure, Panel, Scale};

/// With k̄ = m̄ω² and c̄ = 2m̄ω, ω = 20 /s: (20) leaves both zero here, and nothing brings φ back.
const STABILISED: &str = "alf3f-paper with k̄ c̄";
/// Tolerances of ψ̇ and of the update of q, which the paper leaves open: what becomes of the run with others.
const TOLERANCES: [(&str, f64, f64); 8] = [
    ("ψ̇ 1e-1; q 1e-2", 1e-1, 1e-2),
    ("ψ̇ 1e-1; q 1e-3", 1e-1, 1e-3),
    ("ψ̇ 1e-1; q 1e-4", 1e-1, 1e-4),
    ("ψ̇ 1e-2; q 1e-2", 1e-2, 1e-2),
    ("ψ̇ 1e-2; q 1e-4", 1e-2, 1e-4),
    ("ψ̇ 1e-3; q 1e-2", 1e-3, 1e-2),
    ("ψ̇ 1e-3; q 1e-3", 1e-3, 1e-3),
    ("ψ̇ 1e-3; q 1e-4", 1e-3, 1e-4),
];
const CONSTANT: [(&str, f64); 7] = [
    ("ξ = 1", 1.0),
    ("ξ = 100", 1e2),
    ("ξ = 1e3", 1e3),
    ("ξ = 1e4", 1e4),
    ("ξ = 1e5", 1e5),
    ("ξ = 1e6", 1e6),
    ("ξ = 1e8", 1e8),
];

pub fn figure(extent: Extent) -> Figure {
    let instants = extent.instants(0.0, 20.0, 400);
    let run = |label, method| Run::new(label, method, STEP, &instants);
    let paper = algorithm(PENALTIES[0], PENALTIES[1]);
    let stabilised = PaperSettings {
        stabilisation_frequency: 20.0,
        ..paper
    };
    let mut runs = vec![
        run(TWO_LEVEL, Method::TwoLevel),
        run(PAPER, Method::Paper(paper)),
        run(STRICT, Method::Paper(strict(PENALTIES[0]))),
        run(STABILISED, Method::Paper(stabilised)),
        run(M_ALF, m_alf()),
    ];
    runs.extend(CONSTANT.map(|(label, xi)| run(label, Method::Paper(algorithm(xi, xi)))));
    runs.extend(TOLERANCES.map(|(label, velocity, update)| {
        let settings = PaperSettings {
            velocity_tolerance: velocity,
            residual_tolerance: update,
            ..paper
        };
        run(label, Method::Paper(settings))
    }));
    let window = [0.0, extent.time(20.0)];
    let constant = CONSTANT.map(|c| c.0);
    let methods = [PAPER, STRICT, STABILISED, M_ALF];
    // With constant penalties no run comes further.
    let early = [0.0, extent.time(2.0)];
    let step = |title, runs: &[&'static str], window| {
        let scale = Scale::Decades(-7, -2);
        Panel::of_runs(title, "step, s", Column::Step, runs, window, scale)
    };
    let energy = |title, runs: &[&'static str], window| {
        let runs = [&[TWO_LEVEL], runs].concat();
        let scale = Scale::Between(6.0, 15.0);
        Panel::of_runs(title, "T + V, J", Column::Energy, &runs, window, scale)
    };
    Figure {
        number: 4,
        title: "slider-crank, constant penalties and M-ALF",
        subject: &SLIDER_CRANK,
        columns: vec![Column::Energy, Column::EnergyError, Column::Step],
        runs,
        panels: vec![
            step("shortest step, constant penalties", &constant, early),
            energy("mechanical energy, constant penalties", &constant, early),
            step("shortest step, free penalties", &methods, window),
            energy("mechanical energy, free penalties", &methods, window),
        ],
    }
}
