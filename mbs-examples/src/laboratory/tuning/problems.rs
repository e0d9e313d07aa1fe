//! The scenes of the search and their right motions.

use mbs_runtime::{AnySimulation, Method, Settings, SimulationError};

use crate::scene::Scene;
use crate::scenes::{
    andrews, cardan_shaft, double_pendulum, flyball_governor, four_bar_10, heavy_top, rolling_disk,
    spherical_pendulum, tuning,
};

/// Instants at which runs are compared.
pub(super) const INSTANTS: u32 = 40;
/// Steps of the fine run in a natural unit of time, and the largest difference between two fine runs, relative to the
/// size.
const FINE: [f64; 2] = [1.0 / 2000.0, 1.0 / 6000.0];
const AGREED: f64 = 1e-4;

/// A scene and its right motion.
pub struct Problem {
    /// The mechanism.
    pub scene: &'static Scene,
    /// Its initial angular velocity, rad/s, where that differs from the scene's: other phases of the singular poses.
    pub turning: Option<f64>,
    /// A natural unit of time, s: a tenth of a long run.
    pub unit: f64,
    /// s
    pub duration: f64,
    /// Named points at the instants, m.
    pub poses: Vec<Vec<[f64; 3]>>,
    /// Extent of the points over the motion, m.
    pub size: f64,
    /// The largest kinetic energy, J.
    pub energy: f64,
    /// The difference between two fine runs, relative to the size.
    pub agreement: f64,
}

impl Problem {
    /// Computes the right motion: `two-level` of order 8, or `projected` of order 8 if forces depend on velocities.
    ///
    /// # Errors
    /// No such run comes to its end, or two of them do not agree.
    pub fn new(
        scene: &'static Scene,
        turning: Option<f64>,
        unit: f64,
        units: f64,
    ) -> Result<Self, String> {
        let mut problem = Problem {
            scene,
            turning,
            unit,
            duration: units * unit,
            poses: Vec::new(),
            size: 0.0,
            energy: 0.0,
            agreement: f64::INFINITY,
        };
        let words = |error: SimulationError| format!("{}: {error}", scene.name);
        let method = match scene.model.structure.velocity_forces {
            true => Method::Projected,
            false => Method::TwoLevel,
        };
        let mut coarse = Vec::new();
        for part in FINE {
            coarse = std::mem::take(&mut problem.poses);
            let settings = Settings {
                method,
                order: 8,
                step: part * unit,
                ..Settings::default()
            };
            problem.follow(settings).map_err(words)?;
        }
        let pairs = coarse.iter().zip(&problem.poses);
        let apart = pairs.fold(0.0, |most: f64, (a, b)| most.max(apart(a, b)));
        problem.agreement = apart / problem.size;
        match problem.agreement <= AGREED {
            true => Ok(problem),
            false => Err(format!(
                "{}: fine runs are {apart} m apart",
                problem.scene.name
            )),
        }
    }

    /// The i-th instant, s.
    pub fn instant(&self, i: u32) -> f64 {
        self.duration * f64::from(i) / f64::from(INSTANTS)
    }

    /// The simulation at its start.
    ///
    /// # Errors
    /// As the scene's.
    pub fn build(&self, settings: Settings) -> Result<Box<dyn AnySimulation>, SimulationError> {
        let turning = self.turning.map(|rate| ("turning".to_owned(), rate));
        (self.scene.build)(turning.as_slice(), settings)
    }

    fn follow(&mut self, settings: Settings) -> Result<(), SimulationError> {
        let mut simulation = self.build(settings)?;
        self.poses.push(simulation.points());
        self.energy = simulation.energy().kinetic;
        for i in 1..=INSTANTS {
            simulation.run_until(self.instant(i))?;
            self.poses.push(simulation.points());
            self.energy = self.energy.max(simulation.energy().kinetic);
        }
        let edge = |axis: usize| {
            let values = self.poses.iter().flatten().map(|point| point[axis]);
            let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| {
                (x.min(l), x.max(h))
            });
            high - low
        };
        self.size = (0..3).map(edge).fold(1e-3, f64::max);
        Ok(())
    }
}

/// The largest distance between the same points of two poses, m; infinite if it is not a number.
pub(super) fn apart(a: &[[f64; 3]], b: &[[f64; 3]]) -> f64 {
    let square = |(a, b): (&[f64; 3], &[f64; 3])| -> f64 {
        a.iter().zip(b).map(|(x, y)| (x - y).powi(2)).sum()
    };
    let most = a.iter().zip(b).map(square);
    let worst = most.fold(0.0, |most: f64, x| {
        if x.is_nan() {
            f64::INFINITY
        } else {
            most.max(x)
        }
    });
    worst.sqrt()
}

/// The problems of the search: scene, initial angular velocity, natural unit of time (s) and duration in such units. The
/// mechanisms of the maps and of the paper's figures are not among them.
///
/// # Errors
/// As [`Problem::new`].
pub fn problems() -> Result<Vec<Problem>, String> {
    let list: [(&'static Scene, Option<f64>, f64, f64); 17] = [
        (&tuning::THREE_CRANKS, None, 1.0, 3.0),
        (&tuning::THREE_CRANKS, Some(-5.9), 1.0, 3.0),
        (&tuning::THREE_CRANKS, Some(-6.8), 1.0, 3.0),
        (&tuning::THREE_CRANKS, Some(-7.7), 1.0, 3.0),
        (&tuning::KITE, None, 1.0, 3.0),
        (&tuning::KITE, Some(-6.7), 1.0, 3.0),
        (&tuning::KITE, Some(-7.4), 1.0, 3.0),
        (&tuning::KITE, Some(-8.1), 1.0, 3.0),
        (&tuning::FOUR_BAR_IN_SPACE, None, 1.0, 3.0),
        (&FOUR_BAR_10, None, 1.0, 3.0),
        (&ANDREWS, None, 0.005, 4.0),
        (&CARDAN_SHAFT, None, 0.2, 4.0),
        (&DOUBLE_PENDULUM, None, 1.0, 3.0),
        (&SPHERICAL_PENDULUM, None, 1.0, 3.0),
        (&FLYBALL_GOVERNOR, None, 1.0, 2.0),
        (&ROLLING_DISK, None, 1.0, 3.0),
        (&HEAVY_TOP, None, 0.2, 3.0),
    ];
    list.into_iter()
        .map(|(scene, turning, unit, units)| Problem::new(scene, turning, unit, units))
        .collect()
}

static FOUR_BAR_10: Scene = four_bar_10::SCENE;
static ANDREWS: Scene = andrews::SCENE;
static CARDAN_SHAFT: Scene = cardan_shaft::SCENE;
static DOUBLE_PENDULUM: Scene = double_pendulum::SCENE;
static SPHERICAL_PENDULUM: Scene = spherical_pendulum::SCENE;
static FLYBALL_GOVERNOR: Scene = flyball_governor::SCENE;
static ROLLING_DISK: Scene = rolling_disk::SCENE;
static HEAVY_TOP: Scene = heavy_top::SCENE;
