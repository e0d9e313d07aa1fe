//! The slider-crank with constant penalties, and with M-ALF.

use mbs_runtime::{Method, MultiplierStart, PaperSettings, RowDirection};

use super::column::Column;
use super::figure3::{PENALTIES, SPAN};
use super::run::{
    COLD, Extent, M_ALF, PAPER, PENALTY, Run, SLIDER_CRANK, STEP, STRICT, TWO_LEVEL, algorithm,
    cold, growing, m_alf, strict,
};
use super::{Figure, Panel, Scale};

/// With k̄ = m̄ω² and c̄ = 2m̄ω, ω = 100 /s: (20) gives zero for both here, so that no term reduces φ.
const STABILISED: &str = "alf3f-paper with k̄ c̄";
/// With penalties from [`PENALTY`].
const HEAVIER: &str = "alf3f-paper from 1e4";
/// With c_R along the rows themselves.
const EUCLIDEAN: &str = "alf3f-paper c_R = a";
/// λ begins with λ₀ + h μ₀, where μ₀ is the rate of λ at the end of the step before.
const M_ALF_COLD: &str = "m-alf from λ₀ + h μ₀";
/// Other tolerances of ψ̇ and of the residual ℜ, for which the paper has one number.
const TOLERANCES: [(&str, f64, f64); 8] = [
    ("ψ̇ 1e-1; ℜ 1e-2", 1e-1, 1e-2),
    ("ψ̇ 1e-1; ℜ 1e-3", 1e-1, 1e-3),
    ("ψ̇ 1e-1; ℜ 1e-4", 1e-1, 1e-4),
    ("ψ̇ 1e-2; ℜ 1e-2", 1e-2, 1e-2),
    ("ψ̇ 1e-2; ℜ 1e-4", 1e-2, 1e-4),
    ("ψ̇ 1e-3; ℜ 1e-2", 1e-3, 1e-2),
    ("ψ̇ 1e-3; ℜ 1e-3", 1e-3, 1e-3),
    ("ψ̇ 1e-3; ℜ 1e-4", 1e-3, 1e-4),
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
    let instants = extent.instants(0.0, SPAN, 900);
    let run = |label, method| Run::new(label, method, STEP, &instants);
    let paper = growing(PENALTIES[0]);
    let stabilised = PaperSettings {
        stabilisation_frequency: 100.0,
        ..growing(PENALTY)
    };
    let euclidean = PaperSettings {
        direction: RowDirection::Euclidean,
        ..paper
    };
    let mut runs = vec![
        run(TWO_LEVEL, Method::TwoLevel),
        run(PAPER, Method::Paper(paper)),
        run(HEAVIER, Method::Paper(growing(PENALTY))),
        run(COLD, Method::Paper(cold(PENALTY))),
        run(STRICT, Method::Paper(strict(PENALTY))),
        run(STABILISED, Method::Paper(stabilised)),
        run(EUCLIDEAN, Method::Paper(euclidean)),
        run(M_ALF, m_alf()),
        run(M_ALF_COLD, m_alf_cold()),
    ];
    runs.extend(CONSTANT.map(|(label, xi)| run(label, Method::Paper(algorithm(xi, xi)))));
    runs.extend(TOLERANCES.map(|(label, velocity, update)| {
        let settings = PaperSettings {
            velocity_tolerance: velocity,
            residual_tolerance: update,
            ..growing(PENALTY)
        };
        run(label, Method::Paper(settings))
    }));
    let window = [0.0, extent.time(SPAN)];
    let constant = CONSTANT.map(|c| c.0);
    let methods = [PAPER, HEAVIER, COLD, STRICT, STABILISED, M_ALF];
    let step = |title, runs: &[&'static str]| {
        let scale = Scale::Decades(-7, -2);
        Panel::of_runs(title, "step, s", Column::Step, runs, window, scale)
    };
    let energy = |title, runs: &[&'static str]| {
        let runs = [&[TWO_LEVEL], runs].concat();
        let scale = Scale::Between(6.0, 15.0);
        Panel::of_runs(title, "T + V, J", Column::Energy, &runs, window, scale)
    };
    Figure {
        number: 4,
        title: "slider-crank, constant penalties and M-ALF",
        caption: &[
            "Steps of 1e-3 s, accuracy 0.01. Free penalties may grow",
            "by two orders of magnitude.",
        ],
        subject: &SLIDER_CRANK,
        columns: vec![Column::Energy, Column::EnergyError, Column::Step],
        runs,
        ensemble: &[
            PAPER, COLD, STRICT, "ξ = 100", "ξ = 1e3", "ξ = 1e6", "ξ = 1e8", M_ALF, M_ALF_COLD,
        ],
        panels: vec![
            step("shortest step, constant penalties", &constant),
            energy("mechanical energy, constant penalties", &constant),
            step("shortest step, free penalties", &methods),
            energy("mechanical energy, free penalties", &methods),
        ],
    }
}

fn m_alf_cold() -> Method {
    match m_alf() {
        Method::MAlf(settings) => Method::MAlf(PaperSettings {
            start: MultiplierStart::Cold,
            ..settings
        }),
        other => other,
    }
}
