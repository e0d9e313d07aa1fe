//! The score of a candidate. The number of iterations measures the work, because it is the same on every machine.

use mbs_runtime::SimulationError;

use super::super::outcome::ASTRAY;
use super::super::store::Row;
use super::candidates::Candidate;
use super::problems::{INSTANTS, Problem, apart};

/// A run is stopped after this number of iterations per nominal step.
const MOST: u64 = 100;

/// The sum of all runs of a candidate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Score {
    /// Runs of mechanisms that the method does not refuse.
    pub runs: u32,
    /// Runs that reached their end on the right branch.
    pub completed: u32,
    /// Runs with a position error above a tenth of the size, or an energy error above a tenth of the largest kinetic
    /// energy.
    pub wrong: u32,
    /// Ended by an error.
    pub stopped: u32,
    /// Given up.
    pub slow: u32,
    /// Geometric mean over the completed runs of the larger of the position error, as a part of the size, and the energy
    /// error, as a part of the largest kinetic energy.
    pub error: f64,
    /// Geometric mean of iterations (stages of explicit methods) in a natural unit of time.
    pub work: f64,
}

impl Score {
    /// error · work², which does not depend on the step for a method of second order.
    pub fn merit(&self) -> f64 {
        self.error * self.work * self.work
    }

    /// Whether it has more completed runs, or equally many and a smaller [`Score::merit`], by more than the round-off
    /// of a file.
    pub fn is_better(&self, other: &Score) -> bool {
        self.completed > other.completed
            || (self.completed == other.completed && self.merit() < 0.999 * other.merit())
    }

    /// The cells of a row after its keys.
    pub fn cells(&self) -> [String; 7] {
        let counts = [
            self.runs,
            self.completed,
            self.wrong,
            self.stopped,
            self.slow,
        ];
        let [a, b, c, d, e] = counts.map(|count| count.to_string());
        let [f, g] = [self.error, self.work].map(|number| format!("{number:.5e}"));
        [a, b, c, d, e, f, g]
    }

    /// The score in a row; `None` if the row has another form.
    pub fn read(row: &Row) -> Option<Self> {
        let count = |i: usize| row.get(i)?.parse().ok();
        let number = |i: usize| row.get(i)?.parse().ok();
        Some(Score {
            runs: count(2)?,
            completed: count(3)?,
            wrong: count(4)?,
            stopped: count(5)?,
            slow: count(6)?,
            error: number(7)?,
            work: number(8)?,
        })
    }
}

enum End {
    /// Error and iterations in a unit.
    Completed([f64; 2]),
    Wrong,
    Stopped,
    Slow,
    Refused,
}

/// Runs a candidate on all problems with all steps.
pub fn score(candidate: &Candidate, problems: &[Problem]) -> Score {
    let mut score = Score {
        runs: 0,
        completed: 0,
        wrong: 0,
        stopped: 0,
        slow: 0,
        error: 0.0,
        work: 0.0,
    };
    for problem in problems {
        for &control in candidate.subject.controls {
            score.runs += 1;
            match run(candidate, problem, control) {
                End::Completed([error, work]) => {
                    score.completed += 1;
                    score.error += error.max(1e-15).ln();
                    score.work += work.max(1.0).ln();
                }
                End::Wrong => score.wrong += 1,
                End::Stopped => score.stopped += 1,
                End::Slow => score.slow += 1,
                End::Refused => score.runs -= 1,
            }
        }
    }
    let completed = f64::from(score.completed.max(1));
    score.error = (score.error / completed).exp();
    score.work = (score.work / completed).exp();
    score
}

fn run(candidate: &Candidate, problem: &Problem, control: f64) -> End {
    let settings = candidate.settings(control, problem.unit);
    let mut simulation = match problem.build(settings) {
        Ok(simulation) => simulation,
        Err(SimulationError::Method { .. } | SimulationError::Setting { .. }) => {
            return End::Refused;
        }
        Err(_) => return End::Stopped,
    };
    let nominal = match candidate.subject.tolerant {
        true => 1e4,
        false => 1.0 / control,
    };
    let units = problem.duration / problem.unit;
    let mut distance = 0.0_f64;
    for i in 1..=INSTANTS {
        if simulation.run_until(problem.instant(i)).is_err() {
            return End::Stopped;
        }
        distance = distance.max(apart(&simulation.points(), &problem.poses[i as usize]));
        let error = distance / problem.size;
        if !(error <= ASTRAY) {
            return End::Wrong;
        }
        if simulation.report().iterations as f64 > MOST as f64 * nominal * units {
            return End::Slow;
        }
    }
    let report = simulation.report();
    let energy = report.energy_error / problem.energy;
    if !(energy <= ASTRAY) {
        return End::Wrong;
    }
    let work = report.iterations.max(report.stages) as f64 / units;
    End::Completed([energy.max(distance / problem.size), work])
}
