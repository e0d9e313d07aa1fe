//! What rustc has to compile for a mechanism of the user, and the processor time that this takes, as mechanisms grow.
//!
//! `cargo run --release -p mbs-examples --example compile_times [-- --csv book/src/results/readme] [NAME SIZE]`
//! (needs bash; a crate is written to `target/compile-times` and built with the profiles of a user, not with those of
//! this repository)

mod declarations;

use declarations::{Declaration, declarations};
use mbs_examples::pages::record::Recorder;
use mbs_macros_core::dag::{Function, Program};
use mbs_macros_core::{analyse, emit};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const COLUMNS: [&str; 9] = [
    "mechanism",
    "size",
    "velocities",
    "rows",
    "operations",
    "written",
    "lines",
    "release_s",
    "dev_s",
];

fn main() -> Result<(), String> {
    let recorder = Recorder::new("cargo run --release -p mbs-examples --example compile_times");
    let mut file = recorder.file("compile.csv", &COLUMNS, 2)?;
    let user = User::new()?;
    println!(
        "{:<12} {:>5} {:>10} {:>6} {:>11} {:>8} {:>8} {:>10} {:>7}",
        "mechanism",
        "size",
        "velocities",
        "rows",
        "operations",
        "written",
        "lines",
        "release, s",
        "dev, s"
    );
    let wanted: Vec<&str> = recorder.arguments.iter().map(String::as_str).collect();
    for declaration in declarations() {
        let (name, size) = (declaration.name, declaration.size.to_string());
        if !wanted.is_empty() && wanted != [name, size.as_str()] && wanted != [name] {
            continue;
        }
        let [velocities, rows, operations, written, lines] = counts(&declaration.text)?;
        let [release, dev] = user.seconds(&declaration)?;
        println!(
            "{name:<12} {size:>5} {velocities:>10} {rows:>6} {operations:>11} {written:>8} {lines:>8} {release:>10.1} {dev:>7.1}"
        );
        let mut row = vec![name.to_owned(), size];
        row.extend([velocities, rows, operations, written, lines].map(|count| count.to_string()));
        row.extend([release, dev].map(|time| format!("{time:.1}")));
        file.put(row)?;
    }
    Ok(())
}

/// Velocities, rows, operations of the equations, those that are written out, and lines of generated Rust.
fn counts(declaration: &str) -> Result<[usize; 5], String> {
    let tokens = declaration.parse().map_err(|_| "not Rust".to_owned())?;
    let (Some(tree), Ok(analysis)) = analyse(tokens) else {
        return Err(format!("{declaration} is not a mechanism"));
    };
    let program = &analysis.program;
    let text = emit::mechanism(&tree, &analysis, program).to_string();
    let operations = |function: &Function| function.operations.len();
    Ok([
        program.size,
        program.rows.len(),
        program.functions.iter().map(operations).sum(),
        written(program),
        // A line for each statement, field and item.
        text.matches([';', '}', '{']).count(),
    ])
}

fn written(program: &Program) -> usize {
    let functions = program.functions.iter();
    let lengths = functions.map(|function| {
        let parts = program.parts(function);
        program.written(function, parts.as_ref())
    });
    lengths.sum()
}

/// The crate of a user.
struct User {
    directory: PathBuf,
}

impl User {
    fn new() -> Result<User, String> {
        let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let directory = repository.join("target/compile-times");
        let manifest = format!(
            "[package]\nname = \"user\"\nversion = \"0.1.0\"\nedition = \"2024\"\n\n[dependencies]\nmbs-runtime = {{ path = {:?} }}\n\n[workspace]\n",
            repository.join("mbs-runtime")
        );
        let written = fs::create_dir_all(directory.join("src"))
            .and_then(|()| fs::write(directory.join("Cargo.toml"), manifest));
        written.map_err(|error| format!("{}: {error}", directory.display()))?;
        Ok(User { directory })
    }

    /// Processor seconds for the crate alone, with the profiles `release` and `dev`.
    fn seconds(&self, declaration: &Declaration) -> Result<[f64; 2], String> {
        let type_name = declaration
            .text
            .split_whitespace()
            .next()
            .unwrap_or_default();
        let text = format!(
            "use mbs_runtime::{{Simulation, mechanism}};\nmechanism!({});\nfn main() {{\n    let mut simulation = Simulation::new({type_name}::default()).unwrap();\n    simulation.run_until(0.1).unwrap();\n    println!(\"{{}}\", simulation.energy().error);\n}}\n",
            declaration.text
        );
        let path = self.directory.join("src/main.rs");
        let mut times = [0.0; 2];
        for (time, profile) in times.iter_mut().zip(["--release", "--profile=dev"]) {
            // What the crate depends on is built first, with an empty one.
            fs::write(&path, "fn main() {}\n").map_err(|error| error.to_string())?;
            self.build(profile)?;
            fs::write(&path, &text).map_err(|error| error.to_string())?;
            *time = self.build(profile)?;
        }
        Ok(times)
    }

    /// User and system time of a build.
    fn build(&self, profile: &str) -> Result<f64, String> {
        let script = format!("cargo build --quiet {profile} >&2 && times");
        let output = Command::new("bash")
            .args(["-c", &script])
            .current_dir(&self.directory)
            .env("CARGO_INCREMENTAL", "0")
            .output()
            .map_err(|error| format!("bash: {error}"))?;
        if !output.status.success() {
            return Err(String::from_utf8_lossy(&output.stderr).into_owned());
        }
        // The second line is of the children: `0m1.234s 0m0.120s`.
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        let children = text.lines().nth(1).unwrap_or_default();
        children.split_whitespace().try_fold(0.0, |sum, time| {
            let (minutes, seconds) = time.trim_end_matches('s').split_once('m').ok_or(&text)?;
            let parse = |text: &str| text.parse::<f64>().map_err(|error| error.to_string());
            Ok(sum + 60.0 * parse(minutes)? + parse(seconds)?)
        })
    }
}
