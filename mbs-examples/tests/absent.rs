//! The build without the feature `laboratory`: what it lacks, and what it says about that. The tests have the feature.

use mbs_examples::absent::{COMMANDS, SCENES, command, message, more};
use mbs_examples::scenes::scenes;
use std::fs;
use std::path::Path;

const FIRST: [&str; 4] = [
    "pendulum",
    "pendulum-angle",
    "slider-crank",
    "double-four-bar",
];

#[test]
fn every_scene_is_among_the_first_or_named() {
    let listed = scenes().iter().map(|scene| scene.name);
    let later: Vec<&str> = listed.filter(|name| !FIRST.contains(name)).collect();
    assert_eq!(later, SCENES);
    assert!(more().is_none());
}

#[test]
fn every_command_is_known_to_both_builds() {
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_mbs"))
        .arg("--help")
        .output()
        .expect("mbs starts");
    let help = String::from_utf8(output.stdout).expect("UTF-8");
    for name in ["list", "simulate"].into_iter().chain(COMMANDS) {
        assert!(help.contains(&format!("\n  {name} ")), "{name} in {help}");
    }
}

#[test]
fn the_message_has_the_command_line_to_run() {
    assert_eq!(
        message(
            "the scene `bricard`",
            ["simulate", "bricard", "--set", "a b=1"]
        ),
        "the scene `bricard` is in builds with the feature `laboratory`; run `cargo run --release -p mbs-examples \
         --features laboratory -- simulate bricard --set 'a b=1'`"
    );
    assert_eq!(
        command(["it's", ""])
            .rsplit_once("-- ")
            .expect("arguments")
            .1,
        r"'it'\''s' ''"
    );
}

/// `cargo mbs` is that command.
#[test]
fn the_alias_is_that_build() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../.cargo/config.toml");
    let config = fs::read_to_string(file).expect("the aliases");
    let line = command([]).replacen("cargo ", "mbs = \"", 1) + "\"";
    assert!(
        config.lines().any(|found| found == line),
        "no `{line}` in {config}"
    );
}
