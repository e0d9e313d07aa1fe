//! A way to integrate a scene, with one number that is searched: steps, or the index of an accuracy.

use cpu_time::ProcessTime;

/// Bounds of max |E − E₀|, J.
pub const BOUNDS: [f64; 3] = [1e-1, 1e-3, 1e-6];
/// A search gives up where a run takes as many times as long as the fastest that its family has found for the same bound
/// by the same rule, or by the weaker rule.
const HOPELESS: f64 = 4.0;
const HOPELESS_BY_ANY: f64 = 16.0;

/// Which runs count: that of the value alone, or those of the next finer ones, too.
#[derive(Clone, Copy, PartialEq)]
pub enum Rule {
    Any,
    Steady,
}

pub const RULES: [Rule; 2] = [Rule::Any, Rule::Steady];

impl Rule {
    pub fn name(self) -> &'static str {
        match self {
            Rule::Any => "any",
            Rule::Steady => "steady",
        }
    }

    /// How many values in a row have to stay within the bound.
    fn values(self) -> usize {
        match self {
            Rule::Any => 1,
            Rule::Steady => 6,
        }
    }
}

/// What a run tells.
pub struct Outcome {
    /// max |E − E₀|, J; infinite if the run stops or ends on another branch.
    pub error: f64,
    /// Processor time of the run with its checks, s.
    pub seconds: f64,
    /// Steps, and calls of the accelerations where they are counted.
    pub steps: u64,
    pub calls: Option<u64>,
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
#[derive(Clone)]
pub struct Found {
    /// Index of the candidate.
    pub candidate: usize,
    pub rule: Rule,
    /// Index of the bound.
    pub bound: usize,
    pub value: u32,
    /// How many values were tried for it.
    pub tried: usize,
    pub seconds: f64,
}

/// For each candidate, rule and bound the first value of the grid that counts.
pub fn search(candidates: &[Candidate], bounds: &[f64]) -> Vec<Found> {
    let mut found: Vec<Found> = Vec::new();
    for (index, candidate) in candidates.iter().enumerate() {
        let fastest = |found: &[Found], rule: Rule, bound: usize| {
            let of_family = |run: &&Found| {
                let family = candidates[run.candidate].family;
                run.rule == rule && run.bound == bound && family == candidate.family
            };
            let times = found.iter().filter(of_family).map(|run| run.seconds);
            times.fold(f64::INFINITY, f64::min)
        };
        let cases = RULES.map(|rule| (0..bounds.len()).map(move |bound| (rule, bound)));
        let mut missing: Vec<(Rule, usize)> = cases.into_iter().flatten().collect();
        let mut errors = Vec::new();
        let mut times = Vec::new();
        for &value in &candidate.grid {
            if missing.is_empty() {
                break;
            }
            let Outcome { error, seconds, .. } = (candidate.check)(value);
            errors.push(error);
            times.push(seconds);
            missing.retain(|&(rule, bound)| {
                let Some(first) = errors.len().checked_sub(rule.values()) else {
                    return true;
                };
                if errors[first..].iter().all(|error| *error <= bounds[bound]) {
                    found.push(Found {
                        candidate: index,
                        rule,
                        bound,
                        value: candidate.grid[first],
                        tried: first + 1,
                        seconds: times[first],
                    });
                    return false;
                }
                seconds <= HOPELESS * fastest(&found, rule, bound)
                    && seconds <= HOPELESS_BY_ANY * fastest(&found, Rule::Any, bound)
            });
        }
    }
    found
}

/// Numbers of steps, each larger than the last by a factor.
#[derive(Clone, Copy)]
pub struct Steps {
    pub most: u32,
    pub factor: f64,
}

impl Steps {
    pub fn grid(self) -> Vec<u32> {
        let mut grid = vec![8];
        while let Some(&last) = grid.last()
            && last < self.most
        {
            grid.push((f64::from(last) * self.factor).ceil() as u32);
        }
        grid
    }
}

/// Processor time, s, of what callgrind counts, too.
#[inline(never)]
pub fn measured(run: &mut dyn FnMut() -> bool) -> f64 {
    let begun = ProcessTime::now();
    let done = run();
    let seconds = begun.elapsed().as_secs_f64();
    if done { seconds } else { f64::INFINITY }
}
