//! The times of what was searched, alternately, and the instructions of the fastest.

use super::candidate::{Candidate, Found, search};
use mbs_examples::pages::record::File;
use mbs_examples::pages::symbolic::COLUMNS;
use std::process::Command;

/// Settings that were slower by this factor in the search are not timed again.
const CLOSE: f64 = 1.5;
/// How long all repeats of a scene take at the most, s, and how many there are.
const PATIENCE: f64 = 40.0;
const REPEATS: [f64; 2] = [10.0, 300.0];
/// Values beyond the chosen one that are tried, too.
const BEYOND: usize = 10;

/// Searches, times and writes a scene.
pub fn compete(
    scene: &str,
    part: &str,
    bounds: &[f64],
    families: &[&'static str],
    candidates: &[Candidate],
    file: &mut File,
) -> Result<(), String> {
    println!("\n{scene}");
    let mut found = search(candidates, bounds);
    let family = |run: &Found| candidates[run.candidate].family;
    let least = |of: &Found, found: &[Found]| {
        found
            .iter()
            .filter(|other| other.bound == of.bound && family(other) == family(of))
            .fold(f64::INFINITY, |least, other| least.min(other.seconds))
    };
    let close: Vec<bool> = found
        .iter()
        .map(|run| run.seconds <= CLOSE * least(run, &found))
        .collect();
    let mut close = close.into_iter();
    found.retain(|_| close.next().unwrap_or(false));
    let round: f64 = found.iter().map(|run| run.seconds).sum();
    for run in &mut found {
        run.seconds = f64::INFINITY;
    }
    let repeats = (PATIENCE / round).clamp(REPEATS[0], REPEATS[1]) as u32;
    for _ in 0..repeats {
        for run in &mut found {
            run.seconds = run.seconds.min((candidates[run.candidate].time)(run.value));
        }
    }
    for (index, bound) in bounds.iter().enumerate() {
        let mut first = f64::NAN;
        for &name in families {
            let best = found
                .iter()
                .filter(|run| run.bound == index && family(run) == name)
                .min_by(|a, b| a.seconds.total_cmp(&b.seconds));
            let mut row = vec![scene.to_owned(), format!("{bound:e}"), name.to_owned()];
            let Some(best) = best else {
                println!("{bound:>8.0e} {name:<12} never");
                row.resize(COLUMNS.len(), String::new());
                file.put(row)?;
                continue;
            };
            let candidate = &candidates[best.candidate];
            let beyond: Vec<u32> = (candidate.grid.iter().copied())
                .filter(|value| *value > best.value)
                .take(BEYOND)
                .collect();
            let within = |value: &&u32| (candidate.check)(**value).error <= *bound;
            let held = beyond.iter().filter(within).count();
            if first.is_nan() {
                first = best.seconds;
            }
            let value = (candidate.name)(best.value);
            let instructions = callgrind(part, scene, best.candidate, best.value);
            println!(
                "{bound:>8.0e} {name:<12} {:>9.4} ms  x {:<6.2} {:>10} instructions  {}; {value}  (tried {}; of {} finer ones {held} hold)",
                1e3 * best.seconds,
                best.seconds / first,
                instructions.map_or_else(String::new, |count| format!("{count}")),
                candidate.setting,
                best.tried,
                beyond.len(),
            );
            row.extend([
                candidate.setting.clone(),
                value,
                best.tried.to_string(),
                format!("{held} of {}", beyond.len()),
                instructions.map_or_else(String::new, |count| count.to_string()),
                format!("{:.5}", 1e3 * best.seconds),
            ]);
            file.put(row)?;
        }
    }
    Ok(())
}

/// Instructions of a run without its start; `None` without valgrind.
fn callgrind(part: &str, scene: &str, candidate: usize, value: u32) -> Option<u64> {
    let program = std::env::current_exe().ok()?;
    let output = Command::new("valgrind")
        .args([
            "--tool=callgrind",
            "--callgrind-out-file=/dev/null",
            "--toggle-collect=*candidate*measured*",
        ])
        .arg(program)
        .args(["--count", part, scene])
        .args([candidate.to_string(), value.to_string()])
        .output()
        .ok()?;
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    let line = text.lines().find(|line| line.contains("Collected :"))?;
    line.rsplit(' ').next()?.trim().parse().ok()
}
