//! Every command line in the README and the book is run: here, by `cargo test --workspace`, or by the script of the
//! checks.

use mbs_examples::absent::{COMMANDS, SCENES};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The lines of blocks of `sh` in a file of Markdown.
fn commands(file: &Path) -> Vec<String> {
    let (mut inside, mut wanted) = (false, false);
    let mut lines = Vec::new();
    for line in fs::read_to_string(file).expect("UTF-8").lines() {
        if let Some(info) = line.strip_prefix("```") {
            inside = !inside;
            wanted = inside && info == "sh";
        } else if wanted {
            lines.push(line.to_owned());
        }
    }
    lines
}

fn pages(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("the book is there") {
        let path = entry.expect("readable").path();
        if path.is_dir() {
            found.extend(pages(&path));
        } else if path.extension().is_some_and(|extension| extension == "md") {
            found.push(path);
        }
    }
    found
}

/// Whether the script of the checks runs it; there dependencies are locked.
fn in_the_script(command: &str) -> bool {
    let script = fs::read_to_string(root().join(".ci/run")).expect("the script");
    let unlocked = script.replace(" --locked", "");
    command == "bash .ci/run"
        || unlocked
            .lines()
            .any(|line| line.starts_with("step ") && line.contains(command))
}

/// Whether it is a part of `cargo test --workspace`, or of the tests that need a feature: a package, one of its programs by
/// `--test`, or one of its test files by `NAME::`.
fn is_a_part_of_the_tests(command: &str) -> bool {
    let words: Vec<&str> = command
        .split_whitespace()
        .skip_while(|word| word.contains('='))
        .collect();
    let folder = |package: &str| match package {
        "mbs-tests" => root().join("tests"),
        "cart-pole" => root().join("mbs-examples/embed"),
        other => root().join(other),
    };
    let has_program = |package: &str, name: &str| {
        let manifest = std::fs::read_to_string(folder(package).join("Cargo.toml"));
        manifest.is_ok_and(|text| text.contains(&format!("name = \"{name}\"")))
    };
    let has_file = |package: &str, module: &str| {
        let file = module.strip_suffix("::").unwrap_or_default();
        let path = folder(package).join("tests").join(file);
        path.with_extension("rs").exists()
    };
    match words[..] {
        ["cargo", "test", "-p", package] => folder(package).join("Cargo.toml").exists(),
        ["cargo", "test", "-p", package, module] => has_file(package, module),
        ["cargo", "test", "-p", package, "--test", name]
        | [
            "cargo",
            "test",
            "-p",
            package,
            "--features",
            _,
            "--test",
            name,
        ] => has_program(package, name),
        ["cargo", "test", "-p", package, "--test", name, module] => {
            has_program(package, name) && has_file(package, module)
        }
        _ => false,
    }
}

#[test]
fn command_lines_work() {
    const FIRST: &str = "cargo run --release -p mbs-examples -- ";
    const MBS: &str = "cargo mbs ";
    // Files that they write go to a folder of their own.
    let place = Path::new(env!("CARGO_TARGET_TMPDIR")).join("book");
    fs::create_dir_all(&place).expect("a folder");
    let mut files = pages(&root().join("book/src"));
    files.push(root().join("README.md"));
    let mut run = 0;
    for file in files {
        for command in commands(&file) {
            let at = format!("{}: `{command}`", file.display());
            let first = command.strip_prefix(FIRST);
            if let Some(arguments) = first {
                let words: Vec<&str> = arguments.split_whitespace().collect();
                let absent = |word: &&str| SCENES.contains(word) || COMMANDS.contains(word);
                assert!(
                    !words.iter().any(absent) && !words.contains(&"--method"),
                    "{at} needs `cargo mbs`"
                );
            }
            if let Some(arguments) = first.or_else(|| command.strip_prefix(MBS)) {
                let output = Command::new(env!("CARGO_BIN_EXE_mbs"))
                    .args(arguments.split_whitespace())
                    .current_dir(&place)
                    .output()
                    .expect("mbs starts");
                let complaint = String::from_utf8_lossy(&output.stderr);
                assert!(output.status.success(), "{at} failed: {complaint}");
                run += 1;
            } else {
                assert!(
                    in_the_script(&command) || is_a_part_of_the_tests(&command),
                    "{at} is run nowhere"
                );
            }
        }
    }
    assert!(run >= 5, "{run} command lines were run");
}

/// Each option of the help, with its command, is on the page of the command line.
#[test]
fn every_option_is_on_its_page() {
    let page = fs::read_to_string(root().join("book/src/command-line.md")).expect("the page");
    let help = |command: &[&str]| {
        let output = Command::new(env!("CARGO_BIN_EXE_mbs"))
            .args(command)
            .arg("--help")
            .output()
            .expect("mbs starts");
        String::from_utf8(output.stdout).expect("UTF-8")
    };
    let all = help(&[]);
    let commands = all
        .lines()
        .skip_while(|line| *line != "Commands:")
        .skip(1)
        .map_while(|line| line.split_whitespace().next())
        .filter(|command| *command != "help");
    for command in commands {
        let section = page.split("\n## ").find(|section| {
            let heading = section.lines().next().unwrap_or_default();
            heading.starts_with(&format!("`mbs {command}"))
        });
        let section = section.unwrap_or_else(|| panic!("`mbs {command}` has no section"));
        let text = help(&[command]);
        let options = text
            .split(|c: char| c.is_whitespace() || c == ',')
            .filter(|word| word.starts_with("--") && word.len() > 2 && *word != "--help");
        for option in options {
            let option = option.trim_end_matches(|c: char| !c.is_alphanumeric());
            assert!(
                section.contains(&format!("`{option}")),
                "`mbs {command} {option}` is not on its page"
            );
        }
    }
}
