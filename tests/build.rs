//! Writes the declarations of the scenes again, with each choice of coordinates: see `tests/formulations.rs`.

use std::fmt::Write;
use std::path::Path;
use std::{env, fs};

/// Mechanisms that have more than one description, by their scene's file.
const MECHANISMS: [(&str, &str); 6] = [
    ("pendulum", "Pendulum"),
    ("slider_crank", "SliderCrank"),
    ("double_four_bar", "DoubleFourBar"),
    ("heavy_top", "HeavyTop"),
    ("bricard", "Bricard"),
    ("flyball_governor", "FlyballGovernor"),
];

fn main() {
    let scenes = Path::new(&env::var("CARGO_MANIFEST_DIR").expect("set by cargo"))
        .join("../mbs-examples/src/scenes");
    let mut out = String::new();
    for formulation in ["Natural", "Reference", "Joint"] {
        // `reference` is a module of this crate.
        let module = formulation
            .to_lowercase()
            .replace("reference", "reference_points");
        let _ = writeln!(out, "mod {module} {{\nuse mbs_runtime::mechanism;");
        for (file, name) in MECHANISMS {
            // A massless bar has no reference coordinates.
            if (formulation, name) == ("Reference", "Pendulum") {
                continue;
            }
            let path = scenes.join(file).with_extension("rs");
            println!("cargo::rerun-if-changed={}", path.display());
            let text = fs::read_to_string(&path).expect("a scene");
            let start = text
                .find(&format!("mechanism!({name} {{"))
                .expect("the declaration");
            let end = start + text[start..].find("\n});").expect("its end") + 4;
            let _ = writeln!(out, "{}", with(&text[start..end], formulation));
        }
        out.push_str("}\n");
    }
    let target = Path::new(&env::var("OUT_DIR").expect("set by cargo")).join("formulations.rs");
    fs::write(target, out).expect("the target directory can be written");
}

/// A declaration with a given choice of coordinates.
fn with(declaration: &str, formulation: &str) -> String {
    let world = declaration.find("    world: ").expect("a world");
    let end = world + declaration[world..].find("),\n").expect("its end");
    let comma = if declaration[..end].ends_with('(') {
        ""
    } else {
        ", "
    };
    format!(
        "{}{comma}coordinates = {formulation}{}",
        &declaration[..end],
        &declaration[end..]
    )
}
