//! The page on a new joint, followed literally: in a copy of the compiler one file is added and one changed, and a
//! mechanism with that joint compiles.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Joints of space.
const FOLDER: &str = "mbs-macros/core/src/model/elements/joints/spatial";

/// The copy compiles two declarations, which takes less than to optimise it.
const UNOPTIMISED: &str = "profile.dev.package.mbs-macros-core.opt-level=0";

/// A table on a cross slide, by rows and by coordinates.
const PROGRAM: &str = r#"
fn main() {
    for (coordinates, rows) in [("Reference", 4), ("Joint", 0)] {
        let declaration = format!(
            "Mill {{ world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2], coordinates = {coordinates}),
                table: Body(mass = 2.0_kg, inertia = 0.1_kg_m2),
                slide: CrossSlide(ground, table, at = [0.0, 0.0, 0.0], axis = Y) }}"
        );
        let tokens: proc_macro2::TokenStream = declaration.parse().expect("tokens");
        let (_, analysis) = mbs_macros_core::analyse(tokens);
        let analysis = analysis.map_err(|failure| failure.messages()).expect("it compiles");
        let system = &analysis.derived.system;
        // Of its rows some are solved.
        assert_eq!(system.rows.len() + analysis.outline.solved.len(), rows, "{coordinates}");
        assert_eq!(analysis.mobility.expect("it assembles").mobility, 2);
        let components = system.reactions.iter().map(|reaction| reaction.component.as_str());
        let components: Vec<&str> = components.collect();
        assert_eq!(components, ["fx", "fy", "fz", "tx", "ty", "tz"], "{coordinates}");
    }
}
"#;

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The blocks of Rust on the page.
fn blocks(page: &str) -> Vec<String> {
    let blocks = page.split("```rust,ignore\n").skip(1);
    let blocks = blocks.map(|rest| rest.split("```").next().expect("its end").to_owned());
    blocks.collect()
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("a folder");
    for entry in fs::read_dir(from).expect("a folder") {
        let entry = entry.expect("an entry");
        let target = to.join(entry.file_name());
        match entry.path().is_dir() {
            true => copy(&entry.path(), &target),
            false => drop(fs::copy(entry.path(), target).expect("a file")),
        }
    }
}

/// A workspace of the compiler and a program, with the packages and profiles of this one, so that what is built of others
/// is shared: `syn` takes the longest.
fn workspace(folder: &Path) {
    let manifest = fs::read_to_string(root().join("Cargo.toml")).expect("a manifest");
    let shared = &manifest[manifest.find("[workspace.package]").expect("it is there")..];
    let members = "[workspace]\nresolver = \"3\"\nmembers = [\"mbs-macros/core\", \"program\"]\n\n";
    let write = |path: &str, text: &str| {
        let path = folder.join(path);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, text).expect("a file");
    };
    write("Cargo.toml", &format!("{members}{shared}"));
    write(
        "program/Cargo.toml",
        "[package]\nname = \"program\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[dependencies]\nmbs-macros-core = { workspace = true }\nproc-macro2 = { workspace = true }\nsyn = { workspace = true, features = [\"default\"] }\n",
    );
    write("program/src/main.rs", PROGRAM);
    fs::copy(root().join("Cargo.lock"), folder.join("Cargo.lock")).expect("a lock file");
    let core = folder.join("mbs-macros/core");
    let _ = fs::remove_dir_all(&core);
    copy(&root().join("mbs-macros/core"), &core);
}

#[test]
fn a_joint_is_a_file_and_its_row() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("new_joint");
    workspace(&folder);

    let page = fs::read_to_string(root().join("book/src/contributing/joint.md")).expect("a page");
    let [file, lines] = blocks(&page).try_into().expect("a file, and two lines");
    // 1. The file.
    fs::write(folder.join(FOLDER).join("cross_slide.rs"), file).expect("a file");
    // 2. Two lines.
    let [module, kind] = [0, 1].map(|line| lines.lines().nth(line).expect("two lines"));
    let list = folder.join(FOLDER).join("mod.rs");
    let text = fs::read_to_string(&list).expect("the list");
    let text = text.replacen("\nmod ", &format!("\n{module}\nmod "), 1);
    let text = text.replacen("= &[\n", &format!("= &[\n    {kind}\n"), 1);
    fs::write(&list, text).expect("the list");

    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    let output = Command::new(cargo)
        .args(["run", "--offline", "--quiet", "-p", "program"])
        .args(["--config", UNOPTIMISED])
        .current_dir(&folder)
        .env("CARGO_TARGET_DIR", folder.join("../.."))
        .output()
        .expect("cargo starts");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{errors}");
    assert!(!errors.contains("warning: unused"), "{errors}");
}
