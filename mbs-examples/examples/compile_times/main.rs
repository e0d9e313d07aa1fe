//! What rustc has to compile for a mechanism of the user, and the processor time that this takes, as mechanisms grow.
//!
//! `cargo run --release -p mbs-examples --example compile_times [-- --csv book/src/results/readme] [NAME SIZE]`
//! (needs bash; a crate is written to `target/compile-times` and built with the profiles of a user, not with those of
//! this repository)

mod declarations;
mod origins;

use declarations::{Declaration, declarations};
use mbs_examples::pages::record::Recorder;
use mbs_macros_core::dag::{Function, Program};
use mbs_macros_core::{analyse, emit};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const COLUMNS: [&str; 10] = [
    "mechanism",
    "size",
    "velocities",
    "rows",
    "operations",
    "written",
    "statements",
    "release_s",
    "dev_s",
    "any_s",
];
const ORIGIN_COLUMNS: [&str; 4] = ["mechanism", "size", "origin", "lines"];
const METHOD_COLUMNS: [&str; 4] = ["mechanism", "size", "methods", "release_s"];

/// The mechanisms of the tables of origins and methods.
const DISSECTED: [(&str, usize); 4] = [("chain", 10), ("platform", 6), ("frame", 2), ("loops", 10)];

/// The method that every program has.
const TWO_LEVEL: &str = "TwoLevel";
/// The types of `mbs_runtime::methods` that stand for one method, and for the candidates of an accuracy.
const ONE: [&str; 10] = [
    "Projected",
    "Radau",
    "Accuracy",
    "Baumgarte",
    "Rattle",
    "Paper",
    "Bdf",
    "GeneralizedAlpha",
    "Index3Projections",
    "Penalty",
];

fn main() -> Result<(), String> {
    let recorder = Recorder::new("cargo run --release -p mbs-examples --example compile_times")?;
    let mut file = recorder.file("compile.csv", &COLUMNS, 2)?;
    let mut origins = recorder.file("compile_origins.csv", &ORIGIN_COLUMNS, 3)?;
    let mut methods = recorder.file("compile_methods.csv", &METHOD_COLUMNS, 3)?;
    let user = User::new()?;
    println!(
        "{:<12} {:>5} {:>10} {:>6} {:>11} {:>8} {:>10} {:>10} {:>7} {:>11}",
        "mechanism",
        "size",
        "velocities",
        "rows",
        "operations",
        "written",
        "statements",
        "release, s",
        "dev, s",
        "any, s"
    );
    let wanted: Vec<&str> = recorder.arguments.iter().map(String::as_str).collect();
    if let Some(name) = wanted.first()
        && !declarations().iter().any(|known| known.name == *name)
    {
        return Err(format!("there is no declaration `{name}` here"));
    }
    for declaration in declarations() {
        let (name, size) = (declaration.name, declaration.size.to_string());
        if !wanted.is_empty() && wanted != [name, size.as_str()] && wanted != [name] {
            continue;
        }
        let [velocities, rows, operations, written, statements] = counts(&declaration.text)?;
        let seconds = |profile: &str, compiled: &str| user.seconds(&declaration, profile, compiled);
        let release = seconds("--release", TWO_LEVEL)?;
        let dev = seconds("--profile=dev", TWO_LEVEL)?;
        let any = seconds("--release", "Any")?;
        println!(
            "{name:<12} {size:>5} {velocities:>10} {rows:>6} {operations:>11} {written:>8} {statements:>10} {release:>10.1} {dev:>7.1} {any:>7.1}"
        );
        let mut row = vec![name.to_owned(), size];
        row.extend(
            [velocities, rows, operations, written, statements].map(|count| count.to_string()),
        );
        row.extend([release, dev, any].map(|time| format!("{time:.1}")));
        file.put(row)?;
        if DISSECTED.contains(&(name, declaration.size)) {
            let size = declaration.size.to_string();
            let [usual, all] = [TWO_LEVEL, "Any"].map(|methods| user.ir(&declaration, methods));
            for (origin, lines) in origins::rows(&usual?, &all?) {
                println!("    {origin:<40} {lines:>8}");
                let row = [name, &size, &origin, &lines.to_string()];
                origins.put(row.map(str::to_owned).to_vec())?;
            }
            let mut timed = vec![(TWO_LEVEL, release)];
            for method in ONE {
                timed.push((method, seconds("--release", method)?));
            }
            timed.push(("Any", any));
            for (method, time) in timed {
                println!("    {method:<40} {time:>8.1}");
                let row = [name, &size, method, &format!("{time:.1}")];
                methods.put(row.map(str::to_owned).to_vec())?;
            }
        }
    }
    Ok(())
}

/// Velocities, rows, operations of the equations, those that are written out, and statements of generated Rust.
fn counts(declaration: &str) -> Result<[usize; 5], String> {
    let tokens = declaration.parse().map_err(|_| "not Rust".to_owned())?;
    let (Some(tree), Ok(analysis)) = analyse(tokens) else {
        return Err(format!("{declaration} is not a mechanism"));
    };
    let program = &analysis.program;
    let (_, size) = emit::written(&tree, &analysis, program);
    let operations = |function: &Function| function.operations.len();
    Ok([
        program.size,
        program.rows.len(),
        program.functions.iter().map(operations).sum(),
        written(program),
        size.statements(),
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

    /// Processor seconds for the crate alone.
    fn seconds(
        &self,
        declaration: &Declaration,
        profile: &str,
        methods: &str,
    ) -> Result<f64, String> {
        // What the crate depends on is built first, with an empty one.
        self.write("fn main() {}\n")?;
        self.build(&["build", profile])?;
        self.write(&program(declaration, methods))?;
        self.build(&["build", profile])
    }

    /// The LLVM IR of the crate before any optimisation.
    fn ir(&self, declaration: &Declaration, methods: &str) -> Result<String, String> {
        self.write(&program(declaration, methods))?;
        let path = self.directory.join("user.ll");
        let emit = format!("--emit=llvm-ir={}", path.display());
        let flags = ["-Cno-prepopulate-passes", "-Ccodegen-units=1"];
        self.build(&["rustc", "--release", "--", &emit, flags[0], flags[1]])?;
        fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))
    }

    fn write(&self, text: &str) -> Result<(), String> {
        fs::write(self.directory.join("src/main.rs"), text).map_err(|error| error.to_string())
    }

    /// User and system time of a build.
    fn build(&self, arguments: &[&str]) -> Result<f64, String> {
        let (command, arguments) = arguments.split_at(1);
        let script = format!(
            "cargo {} --quiet {} >&2 && times",
            command.concat(),
            arguments.join(" ")
        );
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

/// The program of a user: with the two-level method alone, or with others beside it.
fn program(declaration: &Declaration, methods: &str) -> String {
    let mut words = declaration.text.split_whitespace();
    let name = words.next().unwrap_or_default();
    let make = match methods {
        TWO_LEVEL => format!("new({name}::default())"),
        methods => format!(
            "with_methods({name}::default(), mbs_runtime::Settings::default(), mbs_runtime::methods::{methods})"
        ),
    };
    format!(
        "use mbs_runtime::{{Simulation, mechanism}};\nmechanism!({});\nfn main() {{\n    let mut simulation = Simulation::{make}.unwrap();\n    simulation.run_until(0.1).unwrap();\n    println!(\"{{}}\", simulation.energy().error);\n}}\n",
        declaration.text
    )
}
