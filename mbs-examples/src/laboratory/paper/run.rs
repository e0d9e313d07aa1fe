//! What is run, how, and for how long.

use mbs_runtime::{
    BdfSettings, Mechanism, Method, Model, PaperSettings, Settings, Simulation, SimulationError,
};

use super::column::Column;
use super::probe::Probe;
use crate::scenes::paper::{Bricard, DoubleFourBar, Pendulum, SliderCrank};

/// A mechanism of the paper.
pub struct Subject {
    /// In files.
    pub name: &'static str,
    /// What was modelled.
    pub model: &'static Model,
    /// Makes the simulation.
    pub build: fn(Settings) -> Result<Box<dyn Probe>, SimulationError>,
}

macro_rules! subject {
    ($name:literal, $mechanism:ty, $start:expr) => {
        Subject {
            name: $name,
            model: <$mechanism>::MODEL,
            build: |settings| Ok(Box::new(Simulation::with_settings($start, settings)?)),
        }
    };
}

/// Section 7.1, a point mass.
pub static PENDULUM: Subject = subject!("pendulum", Pendulum, Pendulum::default());

/// The moment of inertia of [`HEAVY_BOB`], kg m².
const HEAVY: f64 = 0.1;

/// Section 7.1, a bob with a moment of inertia. A row at the pivot has m̄ = 1/(1/m + l²/J), which vanishes with J.
pub static HEAVY_BOB: Subject = subject!(
    "pendulum, 0.1 kg m² about itself",
    Pendulum,
    Pendulum {
        inertia: HEAVY,
        ..Pendulum::default()
    }
);

/// Section 7.2.
pub static SLIDER_CRANK: Subject = subject!("slider-crank", SliderCrank, SliderCrank::default());

/// Section 7.3.
pub static DOUBLE_FOUR_BAR: Subject =
    subject!("double-four-bar", DoubleFourBar, DoubleFourBar::default());

/// Section 7.4.
pub static BRICARD: Subject = subject!("bricard", Bricard, Bricard::default());

/// How far runs go.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extent {
    /// Part of the full duration.
    pub part: f64,
    /// A run is given up after this processor time, s.
    pub patience: f64,
}

impl Extent {
    /// For results.
    pub const FULL: Extent = Extent {
        part: 1.0,
        patience: 90.0,
    };
    /// For a look, and for tests: a twentieth of the time, which takes the slider-crank through its first singular pose.
    pub const QUICK: Extent = Extent {
        part: 0.05,
        patience: 5.0,
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

/// Where the numbers of a run come from.
#[derive(Clone, Copy)]
pub enum Source {
    /// A simulation.
    Simulated(Settings),
    /// The exact motion; `None` for what it does not tell.
    Exact(fn(f64, &Column) -> Option<f64>),
}

/// One run.
#[derive(Clone)]
pub struct Run {
    /// In legends and files, without commas; unique in a figure.
    pub label: &'static str,
    /// What is run, if it is another mechanism than the figure's.
    pub subject: Option<&'static Subject>,
    /// How.
    pub source: Source,
    /// When it is looked at, s, ascending; the start apart.
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
}

/// Algorithm 1 with the accuracy of 0.01 that the paper names (section 7.1): rows of velocities to 0.01, the update of q to
/// 0.001 of the velocities. With 0.01 for both, or 0.0001 for the second, it stops earlier or loses more at singular poses.
/// Penalties are doubled from `penalty` to `most`.
pub fn algorithm(penalty: f64, most: f64) -> PaperSettings {
    PaperSettings {
        velocity_tolerance: 1e-2,
        residual_tolerance: 1e-2,
        penalty,
        penalty_growth: 2.0,
        max_penalty: most,
        smallest_step: 1e-6,
        ..PaperSettings::default()
    }
}

/// The same with both tolerances at 1e-6.
pub fn strict(penalty: f64) -> PaperSettings {
    PaperSettings {
        velocity_tolerance: 1e-6,
        residual_tolerance: 1e-6,
        max_penalty: 1e9,
        ..algorithm(penalty, 1e9)
    }
}

/// M-ALF with its default penalty, a stiffness, and the accuracy of [`algorithm`].
pub fn m_alf() -> Method {
    Method::MAlf(PaperSettings {
        velocity_tolerance: 1e-2,
        residual_tolerance: 1e-2,
        smallest_step: 1e-6,
        ..PaperSettings::m_alf()
    })
}

/// Backward differentiation with the accuracy of 0.01, up to an order.
pub fn bdf(max_order: u8) -> Method {
    Method::Bdf(BdfSettings {
        tolerance: 1e-2,
        max_order,
    })
}

/// The step of the figures, s: the one that section 7.2 names for the commercial code.
pub const STEP: f64 = 1e-3;
/// Largest penalty of Algorithm 1 where the paper names none.
pub const MOST: f64 = 1e9;

/// The methods that most figures compare.
pub const TWO_LEVEL: &str = "two-level";
/// [`algorithm`].
pub const PAPER: &str = "alf3f-paper";
/// [`strict`].
pub const STRICT: &str = "alf3f-paper 1e-6";
/// [`m_alf`].
pub const M_ALF: &str = "m-alf";
/// [`bdf`] of order 5, 2 and 1 at most.
pub const BDF: [&str; 3] = ["bdf", "bdf order ≤ 2", "bdf order 1"];
/// All of them, in the order of legends.
pub const METHODS: [&str; 7] = [TWO_LEVEL, PAPER, STRICT, M_ALF, BDF[0], BDF[1], BDF[2]];

/// Runs of all of [`METHODS`]; penalties of Algorithm 1 begin with `penalty`.
pub fn methods(penalty: f64, step: f64, instants: &[f64]) -> Vec<Run> {
    let run = |label, method| Run::new(label, method, step, instants);
    vec![
        run(TWO_LEVEL, Method::TwoLevel),
        run(PAPER, Method::Paper(algorithm(penalty, MOST))),
        run(STRICT, Method::Paper(strict(penalty))),
        run(M_ALF, m_alf()),
        run(BDF[0], bdf(5)),
        run(BDF[1], bdf(2)),
        run(BDF[2], bdf(1)),
    ]
}
