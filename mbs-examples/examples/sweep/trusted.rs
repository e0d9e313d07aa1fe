//! The motion that runs are compared with: two fine runs of order 8, as far as they agree.

use crate::case::{Case, extent};
use crate::entries::entry;
use mbs_runtime::SimulationError;

/// Instants of the longest run at which poses are known; they lie closer at the beginning.
const INSTANTS: usize = 96;
/// Processor time of a fine run, roughly, s.
const PATIENCE: f64 = 1.5;
/// Where fine runs differ by more, the motion is not known.
const AGREED: f64 = 1e-7;

/// A motion, as far as it is known.
pub struct Trusted {
    /// s
    pub instants: Vec<f64>,
    /// The coordinates at the instants.
    pub poses: Vec<Vec<f64>>,
    /// The largest difference of the fine runs up to each instant, in sizes and radians.
    pub doubt: Vec<f64>,
    /// The extent of the mechanism at the start, m.
    pub size: f64,
    /// The largest kinetic energy, J.
    pub energy: f64,
    /// The fine runs.
    pub source: String,
}

/// A fine run.
struct Fine {
    poses: Vec<Vec<f64>>,
    energy: f64,
    size: f64,
}

impl Trusted {
    /// The motion of a mechanism.
    ///
    /// # Errors
    /// A message: no two fine runs agree.
    pub fn new(case: &Case) -> Result<Self, String> {
        // Fine runs take 17 stages of four times the usual step of order 8 in a second; half a step twice as many.
        let step = 2.0 * case.step;
        let reach = PATIENCE / (2.0 * 17.0 * case.stage()) * step;
        let duration = case.duration.min(reach);
        let part = |k: usize| k as f64 / INSTANTS as f64;
        let instants: Vec<f64> = (1..=INSTANTS).map(|k| duration * part(k).powi(2)).collect();
        let mut known: Option<Trusted> = None;
        let pairs = [
            [("two-level 8", 1.0), ("projected 8", 0.5)],
            [("two-level 8", 1.0), ("two-level 8", 0.7)],
            [("projected 8", 0.5), ("projected 8", 0.3)],
            [("projected 8", 0.15), ("projected 8", 0.1)],
            [("projected 8", 0.02), ("projected 8", 0.013)],
        ];
        for pair in pairs {
            let cost = duration / (pair[1].1 * step) * 17.0 * case.stage();
            if cost > 10.0 * PATIENCE {
                break;
            }
            let fine = |(label, part): (&str, f64)| follow(case, label, part * step, &instants);
            let (Ok(a), Ok(b)) = (fine(pair[0]), fine(pair[1])) else {
                continue;
            };
            let (mut doubt, mut most, size) = (Vec::new(), 0.0_f64, a.size);
            for (a, b) in a.poses.iter().zip(&b.poses) {
                most = most.max(case.apart(size, a, b));
                if !(most < AGREED) {
                    break;
                }
                doubt.push(most);
            }
            let words = |(label, part): (&str, f64)| format!("{label} at {:.1e} s", part * step);
            let found = doubt.len();
            if known.as_ref().is_none_or(|known| known.doubt.len() < found) {
                known = Some(Trusted {
                    instants: instants[..found].to_vec(),
                    poses: a.poses,
                    doubt,
                    size,
                    energy: a.energy,
                    source: pair.map(words).join(", "),
                });
            }
            // The first two methods have nothing in common but the equations.
            if 2 * found > INSTANTS {
                break;
            }
        }
        known
            .filter(|known| !known.doubt.is_empty())
            .ok_or_else(|| format!("{}: no two fine runs agree", case.name))
    }
}

/// A run until it stops: its poses at the instants.
fn follow(case: &Case, label: &str, step: f64, instants: &[f64]) -> Result<Fine, SimulationError> {
    let settings = entry(label).settings(step, 0.0, true);
    let mut simulation = case.start(settings)?;
    let mut fine = Fine {
        poses: Vec::new(),
        energy: simulation.energy().kinetic,
        size: extent(&simulation.points()),
    };
    for &instant in instants {
        if simulation.run_until(instant).is_err() {
            break;
        }
        fine.poses.push(simulation.coordinates());
        fine.energy = fine.energy.max(simulation.energy().kinetic);
    }
    if fine.size == 0.0 {
        // A mechanism of one point: its way.
        let way = fine.poses.iter().flatten().map(|x| x.abs());
        fine.size = way.fold(f64::MIN_POSITIVE, f64::max);
    }
    Ok(fine)
}
