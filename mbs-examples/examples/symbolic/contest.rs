//! The times of what was searched, alternately, and the instructions of the fastest.

use super::candidate::{Candidate, Found, RULES, Rule, search};
use mbs_examples::pages::record::File;
use mbs_examples::pages::symbolic::COLUMNS;
use std::process::Command;

/// Settings that were slower by this factor in the search are not timed again.
const CLOSE: f64 = 1.5;
/// How long all repeats of a scene take at the most, s, and how many there are.
const PATIENCE: f64 = 40.0;
const REPEATS: [f64; 2] = [10.0, 300.0];

/// A scene with its candidates.
pub struct Contest<'c> {
    pub scene: &'c str,
    /// Which of the two comparisons it belongs to.
    pub part: &'c str,
    pub bounds: &'c [f64],
    pub families: &'c [&'static str],
    pub candidates: &'c [Candidate<'c>],
}

impl Contest<'_> {
    /// Searches, times and writes.
    pub fn hold(&self, file: &mut File) -> Result<(), String> {
        println!("\n{}", self.scene);
        let mut found = self.close(search(self.candidates, self.bounds));
        let round: f64 = found.iter().map(|run| run.seconds).sum();
        for run in &mut found {
            run.seconds = f64::INFINITY;
        }
        let repeats = (PATIENCE / round).clamp(REPEATS[0], REPEATS[1]) as u32;
        for _ in 0..repeats {
            for run in &mut found {
                let time = (self.candidates[run.candidate].time)(run.value);
                run.seconds = run.seconds.min(time);
            }
        }
        for rule in RULES {
            for bound in 0..self.bounds.len() {
                let mut first = f64::NAN;
                for family in self.families {
                    let best = found
                        .iter()
                        .filter(|run| self.is(run, rule, bound, family))
                        .min_by(|a, b| a.seconds.total_cmp(&b.seconds));
                    if first.is_nan() {
                        first = best.map_or(f64::NAN, |run| run.seconds);
                    }
                    file.put(self.row(rule, bound, family, best, first))?;
                }
            }
        }
        Ok(())
    }

    fn is(&self, run: &Found, rule: Rule, bound: usize, family: &str) -> bool {
        let of = self.candidates[run.candidate].family;
        run.rule == rule && run.bound == bound && of == family
    }

    /// Those that are not much slower than the fastest of their family.
    fn close(&self, found: Vec<Found>) -> Vec<Found> {
        let least = |of: &Found| {
            let family = self.candidates[of.candidate].family;
            let rivals = found
                .iter()
                .filter(|run| self.is(run, of.rule, of.bound, family));
            rivals.fold(f64::INFINITY, |least, run| least.min(run.seconds))
        };
        let is_close = |run: &&Found| run.seconds <= CLOSE * least(run);
        found.iter().filter(is_close).cloned().collect()
    }

    /// A row of the file, printed, too; `first` is the time of the first family.
    fn row(
        &self,
        rule: Rule,
        bound: usize,
        family: &str,
        best: Option<&Found>,
        first: f64,
    ) -> Vec<String> {
        let bound = self.bounds[bound];
        let key = [self.scene, &format!("{bound:e}"), rule.name(), family];
        let mut row: Vec<String> = key.map(str::to_owned).to_vec();
        let Some(best) = best else {
            println!("{:<7}{bound:>6.0e} {family:<12} never", rule.name());
            row.resize(COLUMNS.len(), String::new());
            return row;
        };
        let candidate = &self.candidates[best.candidate];
        let outcome = (candidate.check)(best.value);
        let instructions = self.callgrind(best.candidate, best.value);
        let text = |count: Option<u64>| count.map_or_else(String::new, |count| count.to_string());
        row.extend([
            candidate.setting.clone(),
            (candidate.name)(best.value),
            best.tried.to_string(),
            outcome.steps.to_string(),
            text(outcome.calls),
            text(instructions),
            format!("{:.5}", 1e3 * best.seconds),
        ]);
        println!(
            "{:<7}{bound:>6.0e} {family:<12} {:>9.4} ms x {:<5.2} {:>10} instructions {:>5} steps {:>6} calls  {}; {} (tried {})",
            rule.name(),
            1e3 * best.seconds,
            best.seconds / first,
            text(instructions),
            outcome.steps,
            text(outcome.calls),
            candidate.setting,
            (candidate.name)(best.value),
            best.tried,
        );
        row
    }

    /// Instructions of a run without its start; `None` without valgrind.
    fn callgrind(&self, candidate: usize, value: u32) -> Option<u64> {
        let program = std::env::current_exe().ok()?;
        let output = Command::new("valgrind")
            .args([
                "--tool=callgrind",
                "--callgrind-out-file=/dev/null",
                "--toggle-collect=*candidate*measured*",
            ])
            .arg(program)
            .args(["--count", self.part, self.scene])
            .args([candidate.to_string(), value.to_string()])
            .output()
            .ok()?;
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        let line = text.lines().find(|line| line.contains("Collected :"))?;
        line.rsplit(' ').next()?.trim().parse().ok()
    }
}
