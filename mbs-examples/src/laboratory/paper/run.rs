//! The runs: mechanism, method, duration.

use mbs_runtime::{
    BdfSettings, Mechanism, Method, Model, MultiplierStart, PaperSettings, ProjectionSettings,
    RowDirection, Settings, Simulation, SimulationError,
};

use super::column::Column;
use super::probe::Probe;
use super::sketch::Sketch;
use crate::scenes::paper::{Bricard, DoubleFourBar, Pendulum, SliderCrank};

/// A mechanism of the paper.
pub struct Subject {
    /// In files.
    pub name: &'static str,
    /// The model.
    pub model: &'static Model,
    /// Makes the simulation, with all lengths times a factor.
    pub build: fn(Settings, f64) -> Result<Box<dyn Probe>, SimulationError>,
    /// Its start.
    pub sketch: Sketch,
}

macro_rules! subject {
    ($name:literal, $mechanism:ident, $length:ident, { $($given:tt)* }, $sketch:expr) => {
        Subject {
            name: $name,
            model: <$mechanism>::MODEL,
            build: |settings, size| {
                let length = size * $mechanism::default().$length;
                let mechanism = $mechanism {
                    $length: length,
                    $($given)*
                    ..$mechanism::default()
                };
                Ok(Box::new(Simulation::with_any_method(mechanism, settings)?))
            },
            sketch: $sketch,
        }
    };
}

/// cos 45°.
const HALF: f64 = std::f64::consts::FRAC_1_SQRT_2;

const PENDULUM_SKETCH: Sketch = Sketch {
    points: &[("O", [0.0; 3]), ("P", [-1.0, 0.0, 0.0])],
    bars: &[[0, 1]],
    grounds: &[0],
    masses: &[1],
    guide: None,
    arrows: &[],
};

/// Section 7.1, a point mass.
pub static PENDULUM: Subject = subject!("pendulum", Pendulum, length, {}, PENDULUM_SKETCH);

/// The moment of inertia of [`HEAVY_BOB`], kg m².
const HEAVY: f64 = 0.1;

/// Section 7.1, a bob with a moment of inertia. A row at the pivot has m̄ = 1/(1/m + l²/J), which vanishes with J.
pub static HEAVY_BOB: Subject = subject!(
    "pendulum, 0.1 kg m² about itself",
    Pendulum,
    length,
    { inertia: HEAVY, },
    PENDULUM_SKETCH
);

/// Section 7.2.
pub static SLIDER_CRANK: Subject = subject!(
    "slider-crank",
    SliderCrank,
    length,
    {},
    Sketch {
        points: &[
            ("P₁", [0.0; 3]),
            ("P₂", [HALF, HALF, 0.0]),
            ("P₃", [2.0 * HALF, 0.0, 0.0]),
        ],
        bars: &[[0, 1], [1, 2]],
        grounds: &[0],
        masses: &[2],
        guide: Some([0, 2]),
        arrows: &[],
    }
);

/// Section 7.3.
pub static DOUBLE_FOUR_BAR: Subject = subject!(
    "double-four-bar",
    DoubleFourBar,
    length,
    {},
    Sketch {
        points: &[
            ("", [0.0; 3]),
            ("", [1.0, 0.0, 0.0]),
            ("", [2.0, 0.0, 0.0]),
            ("P₁", [0.0, 1.0, 0.0]),
            ("P₂", [1.0, 1.0, 0.0]),
            ("P₃", [2.0, 1.0, 0.0]),
        ],
        bars: &[[0, 3], [1, 4], [2, 5], [3, 4], [4, 5]],
        grounds: &[0, 1, 2],
        masses: &[],
        guide: None,
        arrows: &[3, 4, 5],
    }
);

/// Section 7.4.
pub static BRICARD: Subject = subject!(
    "bricard",
    Bricard,
    side,
    {},
    Sketch {
        points: &[
            ("1", [0.0; 3]),
            ("2", [1.0, 0.0, 0.0]),
            ("3", [1.0, -1.0, 0.0]),
            ("4", [1.0, -1.0, 1.0]),
            ("5", [0.0, -1.0, 1.0]),
            ("6", [0.0, 0.0, 1.0]),
        ],
        bars: &[[0, 1], [1, 2], [2, 3], [3, 4], [4, 5]],
        grounds: &[0, 5],
        masses: &[],
        guide: None,
        arrows: &[],
    }
);

/// Durations of the runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extent {
    /// Part of the full duration.
    pub part: f64,
    /// A run is stopped after this processor time, s.
    pub patience: f64,
    /// Starts of an ensemble.
    pub members: u32,
}

impl Extent {
    /// For results.
    pub const FULL: Extent = Extent {
        part: 1.0,
        patience: 90.0,
        members: 20,
    };
    /// For a quick view, and for tests: a twentieth of the time, in which the slider-crank passes its first singular
    /// pose.
    pub const QUICK: Extent = Extent {
        part: 0.05,
        patience: 5.0,
        members: 2,
    };

    /// A time of the figure, s.
    pub fn time(&self, full: f64) -> f64 {
        self.part * full
    }

    /// Evenly spread instants without the first, s of the full figure.
    pub fn instants(&self, from: f64, to: f64, count: u32) -> Vec<f64> {
        let at = |i: u32| from + (to - from) * f64::from(i) / f64::from(count);
        (1..=count).map(|i| self.time(at(i))).collect()
    }
}

/// The source of the numbers of a run.
#[derive(Clone, Copy)]
pub enum Source {
    /// A simulation.
    Simulated(Settings),
    /// The exact motion; `None` for numbers that it does not have.
    Exact(fn(f64, &Column) -> Option<f64>),
}

/// One run.
#[derive(Clone)]
pub struct Run {
    /// In legends and files, without commas; unique in a figure.
    pub label: &'static str,
    /// The mechanism, if it is not that of the figure.
    pub subject: Option<&'static Subject>,
    /// How.
    pub source: Source,
    /// The instants that are recorded, s, ascending, without the start.
    pub instants: Vec<f64>,
}

impl Run {
    /// A simulation with a step, s.
    pub fn new(label: &'static str, method: Method, step: f64, instants: &[f64]) -> Self {
        let settings = Settings {
            method,
            step,
            ..Settings::default()
        };
        Run {
            label,
            subject: None,
            source: Source::Simulated(settings),
            instants: instants.to_vec(),
        }
    }

    /// Its settings in words, for the file of runs.
    pub fn settings(&self) -> String {
        let Source::Simulated(settings) = self.source else {
            return "closed form".to_owned();
        };
        let step = format!("h {:e} s", settings.step);
        let own = match settings.method {
            Method::Paper(paper) => algorithm_in_words(&paper, ""),
            Method::MAlf(paper) => algorithm_in_words(&paper, " N/m"),
            Method::Bdf(bdf) => format!(
                "tolerance {:e}; order ≤ {}; h at most",
                bdf.tolerance, bdf.max_order
            ),
            Method::Index3Projections(projections) => {
                format!("penalty {:e}", projections.penalty)
            }
            _ => format!("order {}", settings.order),
        };
        match settings.method {
            Method::Bdf(_) => format!("{own} {:e} s", settings.step),
            _ => format!("{own}; {step}"),
        }
    }
}

fn algorithm_in_words(paper: &PaperSettings, unit: &str) -> String {
    let mut words = format!(
        "ψ̇ {:e}; ℜ {:e}; ξ {:e}",
        paper.velocity_tolerance, paper.residual_tolerance, paper.penalty
    );
    if paper.max_penalty > paper.penalty {
        words += &format!(" to {:e}", paper.max_penalty);
    }
    words += unit;
    if paper.mass_scale != 1.0 {
        words += &format!("; m̄ times {:e}", paper.mass_scale);
    }
    if paper.stabilisation_frequency > 0.0 {
        words += &format!("; ω {:e} 1/s", paper.stabilisation_frequency);
    }
    if paper.start == MultiplierStart::Cold {
        words += "; cold";
    }
    if paper.direction == RowDirection::Euclidean {
        words += "; c_R Euclidean";
    }
    words
}

/// The accuracy that the paper names (section 7.1).
const ACCURACY: f64 = 1e-2;
/// Penalties may grow by this factor: "two orders of magnitude, which was the maximum allowable value" (section 7.2).
const GROWTH: f64 = 1e2;
/// The penalty of Algorithm 1 if the paper names none: the power of ten with the least energy errors of all four
/// mechanisms over 20 s.
pub const PENALTY: f64 = 1e4;

/// Algorithm 1 with the accuracy of 0.01: rows of velocities to 0.01, the residual to 0.01 of the momentum. Penalties are
/// doubled from `penalty` to `most`.
pub fn algorithm(penalty: f64, most: f64) -> PaperSettings {
    PaperSettings {
        velocity_tolerance: ACCURACY,
        residual_tolerance: ACCURACY,
        min_updates: 1,
        penalty,
        penalty_growth: 2.0,
        max_penalty: most,
        smallest_step: 1e-6,
        ..PaperSettings::default()
    }
}

/// The same with penalties that grow by two orders of magnitude at most.
pub fn growing(penalty: f64) -> PaperSettings {
    algorithm(penalty, GROWTH * penalty)
}

/// The same with μ = 0 at the beginning of each iteration.
pub fn cold(penalty: f64) -> PaperSettings {
    PaperSettings {
        start: MultiplierStart::Cold,
        ..growing(penalty)
    }
}

/// The same with both tolerances at 1e-6.
pub fn strict(penalty: f64) -> PaperSettings {
    PaperSettings {
        velocity_tolerance: 1e-6,
        residual_tolerance: 1e-6,
        ..growing(penalty)
    }
}

/// M-ALF with its default penalty, a stiffness, and its default tolerances: rows of velocities to 0.01.
pub fn m_alf() -> Method {
    Method::MAlf(PaperSettings {
        min_updates: 1,
        smallest_step: 1e-6,
        ..PaperSettings::m_alf()
    })
}

/// Backward differentiation with the accuracy of 0.01, up to an order.
pub fn bdf(max_order: u8) -> Method {
    Method::Bdf(BdfSettings {
        tolerance: ACCURACY,
        max_order,
    })
}

/// The step of the figures, s: the one that section 7.2 names for the commercial code.
pub const STEP: f64 = 1e-3;
/// The steps of backward differentiation where the paper names no largest one, s: it chooses its own.
pub const FREE: f64 = 1.0;

/// The methods that most figures compare.
pub const TWO_LEVEL: &str = "two-level";
/// [`growing`].
pub const PAPER: &str = "alf3f-paper";
/// [`cold`].
pub const COLD: &str = "alf3f-paper cold";
/// [`strict`].
pub const STRICT: &str = "alf3f-paper 1e-6";
/// [`m_alf`].
pub const M_ALF: &str = "m-alf";
/// The benchmark solution of the paper, with its default penalty.
pub const INDEX3: &str = "index3-projections";
/// [`bdf`] of order 5, 2 and 1 at most.
pub const BDF: [&str; 3] = ["bdf", "bdf order ≤ 2", "bdf order 1"];
/// All of them, in the order of legends.
pub const METHODS: [&str; 8] = [
    TWO_LEVEL, PAPER, COLD, M_ALF, INDEX3, BDF[0], BDF[1], BDF[2],
];

/// Runs of all of [`METHODS`]; penalties of Algorithm 1 begin with `penalty`; backward differentiation takes steps of
/// `longest` at most.
pub fn methods(penalty: f64, step: f64, longest: f64, instants: &[f64]) -> Vec<Run> {
    let run = |label, method, step| Run::new(label, method, step, instants);
    let index3 = Method::Index3Projections(ProjectionSettings::default());
    vec![
        run(TWO_LEVEL, Method::TwoLevel, step),
        run(PAPER, Method::Paper(growing(penalty)), step),
        run(COLD, Method::Paper(cold(penalty)), step),
        run(M_ALF, m_alf(), step),
        run(INDEX3, index3, step),
        run(BDF[0], bdf(5), longest),
        run(BDF[1], bdf(2), longest),
        run(BDF[2], bdf(1), longest),
    ]
}
