//! rustc compiles what is generated for large mechanisms with the stack that it has: no scope holds many `let`s, each of
//! which opens a scope inside the last.

use crate::sizes;
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::SystemTime;
use std::{env, fs};

/// The most `let`s of one scope. rustc overflows its stack at more than 2000.
const MOST: usize = 500;

/// The most `let`s of one scope of some tokens.
fn most(tokens: TokenStream) -> usize {
    let (mut own, mut inner) = (0, 0);
    for tree in tokens {
        match tree {
            TokenTree::Ident(word) if word == "let" => own += 1,
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
                inner = inner.max(most(group.stream()));
            }
            // A `let` in parentheses would be a condition.
            TokenTree::Group(group) => inner = inner.max(most(group.stream())),
            _ => {}
        }
    }
    own.max(inner)
}

/// A pendulum with n outputs, each with a constant of its own.
fn outputs(n: usize) -> String {
    let mut s = String::from(
        "Outputs { world: Planar(gravity = [0.0, -9.81_m_per_s2]), length: Param(1.0_m),\nrod: Bar(mass = 1.0_kg, length = length, angle = 0.0_deg), pin: Revolute(ground.origin, rod.a),\n",
    );
    for i in 0..n {
        let _ = writeln!(
            s,
            "output{i}: Output(sin({}.0 * length / 1.0_m) * rod.b.x),",
            i + 2
        );
    }
    s.push('}');
    s
}

#[test]
fn no_scope_has_many_lets() {
    for declaration in [
        sizes::loops(100),
        sizes::families(300),
        sizes::chain(40),
        sizes::platform(12),
        sizes::frame(4),
        outputs(3000),
    ] {
        let (name, _) = declaration.split_once(' ').expect("its name");
        let text = mbs_macros_core::compile(declaration.parse().expect("tokens"));
        let found = most(text);
        println!("{name}: {found}");
        assert!(
            (10..=MOST).contains(&found),
            "{name}: {found} lets in a scope"
        );
    }
}

/// The newest library of a crate beside this program.
fn library(folder: &Path, name: &str) -> PathBuf {
    let prefix = format!("lib{name}-");
    let files = fs::read_dir(folder).expect("the folder of this program");
    let files = files.map(|file| file.expect("an entry").path());
    let libraries = files.filter(|path| {
        let file = path.file_name().unwrap_or_default().to_string_lossy();
        file.starts_with(&prefix) && file.ends_with(".rlib")
    });
    let changed = |path: &PathBuf| -> Option<SystemTime> { path.metadata().ok()?.modified().ok() };
    libraries.max_by_key(changed).expect("it is built")
}

/// With full debug information, as a user's build has it.
#[test]
fn rustc_compiles_three_thousand_constants() {
    let program = env::current_exe().expect("this program");
    let folder = program.parent().expect("its folder");
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("scopes");
    fs::create_dir_all(&target).expect("a folder");
    let source = target.join("outputs.rs");
    let text = format!(
        "mbs_runtime::mechanism!({});\nfn main() {{ mbs_runtime::Simulation::new(Outputs::default()).unwrap().step().unwrap(); }}\n",
        outputs(3000)
    );
    fs::write(&source, text).expect("a file");
    let output = Command::new(env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned()))
        .args(["--edition=2024", "--emit=obj", "-Cdebuginfo=2", "-L"])
        .arg(format!("dependency={}", folder.display()))
        .arg("--extern")
        .arg(format!(
            "mbs_runtime={}",
            library(folder, "mbs_runtime").display()
        ))
        .arg("-o")
        .args([target.join("outputs.o"), source])
        .env_remove("RUST_MIN_STACK")
        .output()
        .expect("rustc starts");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{errors}");
}

#[test]
fn strings_have_no_statements() {
    let text = r#"let t = 1; f("a;\"{"); { b"}" }"#;
    assert_eq!(mbs_macros_core::emit::statements(text), 4);
}
