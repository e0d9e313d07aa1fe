//! Declarations are a fixed point of rustfmt with its default settings, so that formatting a program formats them, too.

use crate::common;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The output of rustfmt for some files; nothing if it is not installed.
fn check(files: &[PathBuf]) -> Option<Output> {
    let rustfmt = Command::new("rustfmt")
        .args(["--check", "--edition", "2024"])
        .args(files)
        .output();
    match rustfmt {
        Ok(output) => Some(output),
        Err(error) => {
            eprintln!("skipped: rustfmt does not start ({error})");
            None
        }
    }
}

#[test]
fn scenes_are_formatted() {
    let Some(output) = check(&common::scene_files()) else {
        return;
    };
    let difference = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{difference}");
}

#[test]
fn bad_formatting_is_noticed() {
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("badly_formatted.rs");
    let declaration = "mechanism!(Bad {\n    bar : Bar(mass=1.0_kg,   length = 1.0_m),\n});\n";
    std::fs::write(&file, declaration).expect("the file can be written");
    let Some(output) = check(&[file]) else {
        return;
    };
    let difference = String::from_utf8_lossy(&output.stdout);
    assert!(
        !output.status.success(),
        "rustfmt does not look into `mechanism!`"
    );
    assert!(
        difference.contains("bar: Bar(mass = 1.0_kg, length = 1.0_m)"),
        "{difference}"
    );
}
