//! The right motion of a problem, as far as fine runs determine it.

use mbs_runtime::{AnySimulation, Settings, SimulationError};

use super::super::methods::{Entry, entry};
use super::run::{LOOKS, jump};
use super::{Branch, Problem};

/// Instants of the right motion; a multiple of those at which a run is tested.
const POSES: u32 = 10 * LOOKS;
/// Its duration, s: in this time every mechanism here returns to its first poses.
const FOLLOWED: f64 = 10.0;
/// The step, of order 8, as a fraction of that time,
const FINE: f64 = 1.0 / 8000.0;
/// how often it is divided by four at most, and the difference of two runs, relative to the size, at which this ends.
const REFINEMENTS: i32 = 3;
const AGREED: f64 = 1e-2;
/// The accuracies of two runs that have to agree where poses are compared at the same instants.
const ACCURACIES: [f64; 2] = [1e-6, 1e-8];
/// The accuracy that is enough for size and kinetic energy.
const ROUGH: f64 = 1e-4;

/// Named points of a pose.
type Pose = Vec<[f64; 3]>;

/// The right motion.
pub(super) struct Motion {
    branch: Branch,
    /// s, from one pose to the next.
    interval: f64,
    poses: Vec<Pose>,
    /// The largest extent of the mechanism's points, m.
    pub(super) size: f64,
    /// The largest kinetic energy, J.
    pub(super) energy: f64,
}

impl Motion {
    /// From fine runs; if poses are compared, from two that agree.
    pub(super) fn new(problem: &Problem) -> Result<Self, String> {
        let entry = entry("two-level 8").ok_or("two-level is no method")?;
        let fine = |finer| fine(problem, &entry, finer);
        match problem.branch {
            Branch::Curve => Self::agreed(problem, (0..=REFINEMENTS).map(fine)),
            Branch::Motion => Self::agreed(problem, ACCURACIES.into_iter().map(Settings::accuracy)),
            Branch::Output(_) => Self::first(problem, [Settings::accuracy(ROUGH), fine(0)]),
            Branch::Unknown => Self::first(problem, [fine(0), Settings::accuracy(ROUGH)]),
        }
    }

    /// From the first settings with which a run does not stop.
    fn first(problem: &Problem, settings: [Settings; 2]) -> Result<Self, String> {
        let [settings, otherwise] = settings;
        Self::follow(problem, settings).or_else(|_| Self::follow(problem, otherwise))
    }

    /// From runs with finer and finer settings, until two agree.
    fn agreed(
        problem: &Problem,
        mut settings: impl Iterator<Item = Settings>,
    ) -> Result<Self, String> {
        let coarsest = settings.next().ok_or("no settings")?;
        let mut motion = Self::follow(problem, coarsest)?;
        for finer in settings {
            let better = Self::follow(problem, finer)?;
            let pairs = motion.poses.iter().zip(&better.poses);
            let apart = pairs.fold(0.0, |most: f64, (a, b)| most.max(apart(a, b)));
            motion = better;
            if apart <= AGREED * motion.size {
                return Ok(motion);
            }
        }
        Err("fine runs do not agree about it".to_owned())
    }

    fn follow(problem: &Problem, settings: Settings) -> Result<Self, String> {
        let words = |error: SimulationError| error.to_string();
        let mut parameters = problem.parameters.clone();
        if let Some((name, value)) = problem.measured_with {
            parameters.push((name.to_owned(), value));
        }
        let mut simulation = (problem.scene.build)(&parameters, settings).map_err(words)?;
        let mut motion = Motion {
            branch: problem.branch,
            interval: problem.duration.min(FOLLOWED) / f64::from(POSES),
            poses: vec![simulation.points()],
            size: 0.0,
            energy: simulation.energy().kinetic,
        };
        for i in 1..=POSES {
            if i % (POSES / LOOKS) == 1 {
                jump(problem, simulation.as_mut(), i / (POSES / LOOKS)).map_err(words)?;
            }
            let until = motion.interval * f64::from(i);
            simulation.run_until(until).map_err(words)?;
            motion.poses.push(simulation.points());
            motion.energy = motion.energy.max(simulation.energy().kinetic);
        }
        motion.size = extent(&motion.poses);
        Ok(motion)
    }

    /// How far the simulation is from the right branch, m.
    pub(super) fn distance(&self, simulation: &dyn AnySimulation) -> f64 {
        let nearest = |poses: &[Pose]| {
            let pose = simulation.points();
            let distances = poses.iter().map(|other| apart(&pose, other));
            distances.fold(f64::INFINITY, f64::min)
        };
        match self.branch {
            Branch::Curve => nearest(&self.poses),
            Branch::Motion => {
                let place = (simulation.time() / self.interval) as usize;
                let last = self.poses.len() - 1;
                nearest(&self.poses[place.saturating_sub(1).min(last)..=(place + 1).min(last)])
            }
            Branch::Output(name) => simulation.output(name).map_or(f64::NAN, f64::abs),
            Branch::Unknown => 0.0,
        }
    }
}

/// The settings of a fine run.
fn fine(problem: &Problem, entry: &Entry, finer: i32) -> Settings {
    let followed = problem.duration.min(FOLLOWED);
    entry.settings(followed, followed * FINE / 4_f64.powi(finer))
}

/// The largest distance between the same points of two poses, m.
fn apart(a: &Pose, b: &Pose) -> f64 {
    let pairs = a.iter().zip(b);
    let square = pairs.map(|(a, b)| a.iter().zip(b).map(|(x, y)| (x - y).powi(2)).sum());
    square.fold(0.0, f64::max).sqrt()
}

/// The longest edge of the box around all points.
fn extent(poses: &[Pose]) -> f64 {
    let edge = |axis: usize| {
        let values = poses.iter().flatten().map(|point| point[axis]);
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            (x.min(low), x.max(high))
        });
        high - low
    };
    (0..3).map(edge).fold(1e-3, f64::max)
}
