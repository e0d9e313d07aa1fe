//! The source of numbers: the machine and the commit.

use std::collections::hash_map::DefaultHasher;
use std::hash::{Hash, Hasher};
use std::path::Path;
use std::process::Command;

/// What the numbers depend on, wherever git is called from; documents are not among it.
const SOURCES: [&str; 3] = [":(top)*.rs", ":(top)*.toml", ":(top)Cargo.lock"];

/// `commit …; machine …`, for the head of a file.
pub fn provenance() -> String {
    let built = if is_older() {
        "; built from earlier sources"
    } else {
        ""
    };
    format!("commit {}{built}; machine {}", commit(), machine())
}

/// Whether this program is older than a source that is compiled into it: then the commit is not its own.
fn is_older() -> bool {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let modified = |path: &Path| std::fs::metadata(path).and_then(|file| file.modified());
    let Ok(built) = std::env::current_exe().and_then(|program| modified(&program)) else {
        return false;
    };
    let compiled = [
        "mbs-runtime/src",
        "mbs-macros/src",
        "mbs-macros/core/src",
        "mbs-examples/src",
    ];
    let mut folders: Vec<_> = compiled
        .iter()
        .map(|path| folder.join("..").join(path))
        .collect();
    while let Some(folder) = folders.pop() {
        let entries = std::fs::read_dir(&folder).into_iter().flatten().flatten();
        for path in entries.map(|entry| entry.path()) {
            if path.is_dir() {
                folders.push(path);
            } else if modified(&path).is_ok_and(|changed| changed > built) {
                return true;
            }
        }
    }
    false
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
    let of_sources = |command: &[&str]| git(&[command, &["--"], &SOURCES].concat());
    let changes = of_sources(&["diff", "HEAD"]);
    let others = of_sources(&["ls-files", "--full-name", "--others", "--exclude-standard"]);
    let (Some(changes), Some(others), Some(root)) =
        (changes, others, git(&["rev-parse", "--show-toplevel"]))
    else {
        return format!("{commit} with changes");
    };
    if changes.is_empty() && others.is_empty() {
        return commit;
    }
    // Other changes are other sources: their rows do not mix.
    let mut hasher = DefaultHasher::new();
    changes.hash(&mut hasher);
    for file in others.lines() {
        file.hash(&mut hasher);
        std::fs::read(Path::new(&root).join(file))
            .ok()
            .hash(&mut hasher);
    }
    format!("{commit} with changes {:08x}", hasher.finish() as u32)
}

fn machine() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = text.lines().find(|line| line.starts_with("model name"));
    let model = model.and_then(|line| line.split_once(':'));
    let model = model.map_or(std::env::consts::ARCH, |(_, model)| model.trim());
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    format!("{} with {cores} cores", model.replace(',', ";"))
}
