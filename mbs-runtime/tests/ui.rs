//! What rustc makes of a wrong `mechanism!`. A wrong program costs a run of rustc, so that a few of each nature are here;
//! `tests/tests/ui.rs` compares the messages of all. `TRYBUILD=overwrite cargo test -p mbs-runtime ui::` writes the
//! `.stderr` files.

use crate::common::rustc::rustc;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs};

/// The folder of the programs, as rustc names it.
const FOLDER: &str = "tests/ui";

/// The files of the folder with an extension.
fn files(extension: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(FOLDER).expect("the folder is there");
    let files = entries.map(|entry| entry.expect("readable").path());
    files
        .filter(|file| file.extension().is_some_and(|found| found == extension))
        .collect()
}

/// The messages of rustc for a program that it must refuse, without the count of them at the end.
fn messages(program: &Path) -> Result<String, String> {
    let output = rustc(&["mbs_runtime"])
        .args(["--emit=metadata", "--out-dir", env!("CARGO_TARGET_TMPDIR")])
        .args(["--diagnostic-width=140"])
        .arg(program)
        .output()
        .expect("rustc starts");
    if output.status.success() {
        return Err("rustc takes it".to_owned());
    }
    let text = String::from_utf8(output.stderr).expect("UTF-8");
    let (messages, _) = text
        .split_once("\nerror: aborting due to")
        .ok_or_else(|| text.clone())?;
    Ok(messages.to_owned())
}

/// Compares the messages for a program with the file beside it.
fn check(program: &Path) -> Result<(), String> {
    let file = program.with_extension("stderr");
    let shown = messages(program)?;
    if env::var_os("TRYBUILD").is_some_and(|value| value == "overwrite") {
        return fs::write(file, shown).map_err(|error| error.to_string());
    }
    let expected = fs::read_to_string(file).unwrap_or_default();
    if shown == expected {
        Ok(())
    } else {
        Err(format!("expected:\n{expected}\nshown:\n{shown}"))
    }
}

#[test]
fn wrong_programs() {
    let programs = files("rs");
    assert!(programs.len() > 10, "{} programs only", programs.len());
    for message in files("stderr") {
        let program = message.with_extension("rs");
        assert!(program.exists(), "{} is missing", program.display());
    }
    let mut failures = String::new();
    for program in programs {
        if let Err(why) = check(&program) {
            let _ = writeln!(failures, "{}: {why}", program.display());
        }
    }
    assert!(failures.is_empty(), "\n{failures}");
}
