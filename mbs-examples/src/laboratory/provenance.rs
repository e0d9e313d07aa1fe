//! The source of numbers: the machine and the commit.

use std::path::Path;
use std::process::Command;

/// `commit …; machine …`, for the head of a file.
pub fn provenance() -> String {
    format!("commit {}; machine {}", commit(), machine())
}

fn commit() -> String {
    let git = |arguments: &[&str]| {
        let mut git = Command::new("git");
        // Other processes may call it at the same time.
        git.arg("--no-optional-locks");
        git.arg("-C").arg(Path::new(env!("CARGO_MANIFEST_DIR")));
        let output = git.args(arguments).output().ok()?;
        let text = String::from_utf8(output.stdout).ok()?;
        output.status.success().then(|| text.trim().to_owned())
    };
    let Some(commit) = git(&["rev-parse", "--short=12", "HEAD"]) else {
        return "unknown".to_owned();
    };
    // Changes of documents do not change the results.
    match git(&["status", "--porcelain", "--", "*.rs", "*.toml"]) {
        Some(changes) if changes.is_empty() => commit,
        _ => format!("{commit} with changes"),
    }
}

fn machine() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = text.lines().find(|line| line.starts_with("model name"));
    let model = model.and_then(|line| line.split_once(':'));
    let model = model.map_or(std::env::consts::ARCH, |(_, model)| model.trim());
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    format!("{} with {cores} cores", model.replace(',', ";"))
}
