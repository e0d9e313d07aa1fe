//! A way to integrate a scene, with one number that is searched: steps, or the index of an accuracy.

use cpu_time::ProcessTime;

/// Bounds of max |E − E₀|, J.
pub const BOUNDS: [f64; 3] = [1e-1, 1e-3, 1e-6];
/// The longest run of a search, as a multiple of the fastest one that its family has found for the bound.
const HOPELESS: f64 = 4.0;

/// What a run tells.
pub struct Outcome {
    /// max |E − E₀|, J; infinite if the run stops or ends on another branch.
    pub error: f64,
    /// Processor time of the run with its checks, s.
    pub seconds: f64,
}

/// A way to integrate.
pub struct Candidate<'c> {
    pub family: &'static str,
    /// Method, order and the like.
    pub setting: String,
    /// The values to try, from coarse to fine.
    pub grid: Vec<u32>,
    /// A value in words.
    pub name: fn(u32) -> String,
    /// A run with checks.
    pub check: Box<dyn Fn(u32) -> Outcome + 'c>,
    /// Processor time of a run without them, s.
    pub time: Box<dyn Fn(u32) -> f64 + 'c>,
}

/// A setting that stays within a bound.
pub struct Found {
    /// Index of the candidate.
    pub candidate: usize,
    /// Index of the bound.
    pub bound: usize,
    pub value: u32,
    /// How many values were tried for it.
    pub tried: usize,
    pub seconds: f64,
}

/// For each candidate and bound the first value of the grid whose run stays within the bound.
pub fn search(candidates: &[Candidate], bounds: &[f64]) -> Vec<Found> {
    let mut found: Vec<Found> = Vec::new();
    for (index, candidate) in candidates.iter().enumerate() {
        let mut missing: Vec<usize> = (0..bounds.len()).collect();
        for (tried, &value) in candidate.grid.iter().enumerate() {
            let Some(&wanted) = missing.first() else {
                break;
            };
            let Outcome { error, seconds } = (candidate.check)(value);
            let fastest = found
                .iter()
                .filter(|other| {
                    other.bound == wanted && candidates[other.candidate].family == candidate.family
                })
                .fold(f64::INFINITY, |least, other| least.min(other.seconds));
            if seconds > HOPELESS * fastest {
                break;
            }
            missing.retain(|&bound| {
                let within = error <= bounds[bound];
                if within {
                    found.push(Found {
                        candidate: index,
                        bound,
                        value,
                        tried: tried + 1,
                        seconds,
                    });
                }
                !within
            });
        }
    }
    found
}

/// Numbers of steps, each a hundredth more than the last.
pub fn steps(from: u32, to: u32) -> Vec<u32> {
    let mut grid = vec![from];
    while let Some(&last) = grid.last()
        && last < to
    {
        grid.push((f64::from(last) * 1.01).ceil() as u32);
    }
    grid
}

/// Processor time, s, of what callgrind counts, too.
#[inline(never)]
pub fn measured(run: &mut dyn FnMut() -> bool) -> f64 {
    let begun = ProcessTime::now();
    let done = run();
    let seconds = begun.elapsed().as_secs_f64();
    if done { seconds } else { f64::INFINITY }
}
