//! The files of a run that cannot be written.

use std::path::Path;
use std::process::Command;

/// A directory is where a picture belongs.
#[test]
fn the_summary_names_no_files_that_are_not_written() {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("occupied_picture");
    std::fs::create_dir_all(out.join("energy.svg")).expect("a directory");
    let mut command = Command::new(env!("CARGO_BIN_EXE_mbs"));
    command
        .args(["simulate", "pendulum", "--time", "0.1", "--out"])
        .arg(&out);
    let output = command.output().expect("mbs starts");
    let [printed, message] = [output.stdout, output.stderr].map(|text| {
        let text = String::from_utf8(text);
        text.expect("UTF-8")
    });
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(message.contains("energy.svg"), "{message}");
    assert!(printed.contains("energy  "), "{printed}");
    assert!(!printed.contains("files in"), "{printed}");
}
