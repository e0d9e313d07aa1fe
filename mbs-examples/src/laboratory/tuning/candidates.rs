//! The grids of the search.

use mbs_runtime::{
    BaumgarteSettings, BdfSettings, GeneralizedAlphaSettings, Method, PaperSettings,
    PenaltySettings, ProjectionSettings, Settings,
};

/// A method with the grids of its parameters.
#[derive(Debug)]
pub struct Subject {
    /// Label in files.
    pub label: &'static str,
    /// Names and values; the search begins with the first value of each. Values with a unit of time are in natural
    /// units.
    pub parameters: &'static [(&'static str, &'static [f64])],
    /// Steps in natural units, or tolerances.
    pub controls: &'static [f64],
    /// The method with these values, for a step and a natural unit of time, both in s; for tolerances instead of a step.
    method: fn(values: &[f64], control: f64, unit: f64) -> Method,
    /// Whether the controls are tolerances.
    pub tolerant: bool,
}

const STEPS: &[f64] = &[1e-2, 5e-3, 2e-3, 1e-3];
const TOLERANCES: &[f64] = &[1e-2, 1e-3, 1e-4, 1e-5, 1e-6];

type Grid = (&'static str, &'static [f64]);
/// Not looser: these runs are short, and in a long run the residuals of Newton's method add up.
const NEWTON: Grid = ("newton_tolerance", &[1e-10, 1e-8]);
const GROWTH: Grid = ("penalty_growth", &[10.0, 2.0]);
const RATIO: Grid = ("augmentation_ratio", &[0.25, 0.5]);
/// Not looser than the accuracy of 0.01, which the paper uses for all runs.
const PLAIN: &[f64] = &[1e-3, 1e-2, 1e-4, 1e-5, 1e-6];
/// Tolerances over (step / natural unit)².
const TIED: &[f64] = &[1e2, 1e3, 1e1, 1.0, 0.1];
const OWN: Grid = ("penalty", &[1e4, 1e2, 1e3, 1e5, 1e6, 1e7, 1e8]);
const STATIC: Grid = ("penalty", &[1e10, 1e7, 1e8, 1e9, 1e11, 1e12]);

/// Every baseline with parameters.
pub static SUBJECTS: &[Subject] = &[
    Subject {
        label: "alf3f-paper",
        parameters: &[
            OWN,
            ("velocity_tolerance", PLAIN),
            ("residual_tolerance", PLAIN),
            NEWTON,
            GROWTH,
            RATIO,
        ],
        controls: STEPS,
        method: |x, h, unit| Method::Paper(paper(PaperSettings::default(), x, 1.0, h, unit)),
        tolerant: false,
    },
    Subject {
        label: "alf3f-paper tied to h²",
        parameters: &[
            OWN,
            ("velocity_tolerance/h²", TIED),
            ("residual_tolerance/h²", TIED),
            NEWTON,
            GROWTH,
            RATIO,
        ],
        controls: STEPS,
        method: |x, h, unit| {
            let square = (h / unit).powi(2);
            Method::Paper(paper(PaperSettings::default(), x, square, h, unit))
        },
        tolerant: false,
    },
    Subject {
        label: "m-alf",
        parameters: &[
            STATIC,
            ("velocity_tolerance", PLAIN),
            ("residual_tolerance", PLAIN),
            NEWTON,
            GROWTH,
            RATIO,
        ],
        controls: STEPS,
        method: |x, h, unit| Method::MAlf(m_alf(x, 1.0, h, unit)),
        tolerant: false,
    },
    Subject {
        label: "m-alf tied to h²",
        parameters: &[
            STATIC,
            ("velocity_tolerance/h²", TIED),
            ("residual_tolerance/h²", TIED),
            NEWTON,
            GROWTH,
            RATIO,
        ],
        controls: STEPS,
        method: |x, h, unit| {
            let square = (h / unit).powi(2);
            Method::MAlf(m_alf(x, square, h, unit))
        },
        tolerant: false,
    },
    Subject {
        label: "index3-projections",
        parameters: &[(
            "penalty",
            &[1e5, 1e1, 1e2, 1e3, 1e4, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11],
        )],
        controls: STEPS,
        method: |x, _, _| Method::Index3Projections(ProjectionSettings { penalty: x[0] }),
        tolerant: false,
    },
    Subject {
        label: "penalty",
        parameters: &[
            (
                "penalty",
                &[1e8, 1e4, 1e5, 1e6, 1e7, 1e9, 1e10, 1e11, 1e12, 1e14],
            ),
            ("damping_ratio", &[1.0, 0.0, 0.1, 0.3, 3.0, 10.0]),
        ],
        controls: STEPS,
        method: |x, _, unit| {
            Method::Penalty(PenaltySettings {
                penalty: x[0] / (unit * unit),
                damping_ratio: x[1],
            })
        },
        tolerant: false,
    },
    Subject {
        label: "generalized-alpha",
        parameters: &[
            (
                "spectral_radius",
                &[0.8, 0.0, 0.2, 0.4, 0.6, 0.7, 0.9, 0.95, 1.0],
            ),
            ("stabilised", &[0.0, 1.0]),
        ],
        controls: STEPS,
        method: |x, _, _| {
            Method::GeneralizedAlpha(GeneralizedAlphaSettings {
                spectral_radius: x[0],
                stabilised: x[1] > 0.5,
            })
        },
        tolerant: false,
    },
    Subject {
        label: "baumgarte",
        parameters: &[("gain", &[10.0, 0.0, 1.0, 3.0, 30.0, 100.0, 300.0])],
        controls: STEPS,
        method: |x, _, unit| {
            Method::Baumgarte(BaumgarteSettings {
                gain: x[0] / unit,
                adaptive: None,
            })
        },
        tolerant: false,
    },
    Subject {
        label: "bdf",
        parameters: &[("max_order", &[5.0, 1.0, 2.0, 3.0, 4.0])],
        controls: TOLERANCES,
        method: |x, tolerance, _| {
            Method::Bdf(BdfSettings {
                tolerance,
                max_order: x[0] as u8,
            })
        },
        tolerant: true,
    },
];

/// Algorithm 1: penalty, the two tolerances (as parts of `scale`), and the rest, as the grids have them.
fn paper(base: PaperSettings, x: &[f64], scale: f64, h: f64, unit: f64) -> PaperSettings {
    PaperSettings {
        penalty: x[0],
        velocity_tolerance: scale * x[1] / unit,
        residual_tolerance: scale * x[2],
        newton_tolerance: x[3],
        penalty_growth: x[4],
        augmentation_ratio: x[5],
        // Otherwise a step may not end.
        smallest_step: h / 1024.0,
        ..base
    }
}

/// The same of M-ALF, whose penalty is a stiffness.
fn m_alf(x: &[f64], scale: f64, h: f64, unit: f64) -> PaperSettings {
    let settings = paper(PaperSettings::m_alf(), x, scale, h, unit);
    PaperSettings {
        penalty: settings.penalty / (unit * unit),
        max_penalty: settings.max_penalty / (unit * unit),
        ..settings
    }
}

/// A method with values of its parameters.
#[derive(Debug, Clone)]
pub struct Candidate {
    /// The method.
    pub subject: &'static Subject,
    /// As its parameters.
    pub values: Vec<f64>,
}

impl PartialEq for Candidate {
    fn eq(&self, other: &Self) -> bool {
        self.subject.label == other.subject.label && self.values == other.values
    }
}

impl Candidate {
    /// The start of the search.
    pub fn start(subject: &'static Subject) -> Self {
        let first = |(_, grid): &Grid| grid.first().copied().unwrap_or(1.0);
        Candidate {
            subject,
            values: subject.parameters.iter().map(first).collect(),
        }
    }

    /// With another value of a parameter.
    pub fn with(&self, parameter: usize, value: f64) -> Self {
        let mut other = self.clone();
        other.values[parameter] = value;
        other
    }

    /// For files: `penalty 1e4; velocity_tolerance 1e-3`.
    pub fn text(&self) -> String {
        let names = self.subject.parameters.iter();
        let pairs = names
            .zip(&self.values)
            .map(|((name, _), value)| match *value {
                x if x == 0.0 || (0.01..1000.0).contains(&x) => format!("{name} {x}"),
                x => format!("{name} {x:e}"),
            });
        pairs.collect::<Vec<_>>().join("; ")
    }

    /// The settings of a run with a step in natural units, or a tolerance; `unit` in s.
    pub fn settings(&self, control: f64, unit: f64) -> Settings {
        let tolerant = self.subject.tolerant;
        let step = if tolerant {
            10.0 * unit
        } else {
            control * unit
        };
        let given = if tolerant { control } else { step };
        let method = (self.subject.method)(&self.values, given, unit);
        Settings {
            method,
            order: match method {
                Method::Baumgarte(_) => 4,
                _ => 2,
            },
            step,
            ..Settings::default()
        }
    }
}
