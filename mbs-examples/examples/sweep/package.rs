//! Random mechanisms and long chains as a package with the same sweep.

use crate::mechanisms::{planar, spatial};
use std::fmt::Write;
use std::path::Path;
use std::{fs, io};

/// The descriptions in turn.
const COORDINATES: [&str; 4] = ["Auto", "Joint", "Natural", "Reference"];
/// The modules that the package shares with this program.
const SHARED: [&str; 6] = ["case", "entries", "sweep", "table", "trial", "trusted"];
/// Loops of the planar chain, and bars of the one in space.
const LOOPS: usize = 7;
const BARS: usize = 30;

/// Writes the package with this number of random mechanisms.
///
/// # Errors
/// The folder cannot be written.
pub fn write(folder: &Path, count: usize) -> io::Result<()> {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let sources = fs::canonicalize(here.join("examples/sweep"))?;
    let runtime = fs::canonicalize(here.join("../mbs-runtime"))?;
    let manifest = format!(
        "[package]\nname = \"random-mechanisms\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[dependencies]\n\
         mbs-runtime = {{ path = {runtime:?} }}\n\n[profile.release]\nopt-level = 1\n\n\
         [profile.release.package.mbs-runtime]\nopt-level = 3\n\n[workspace]\n"
    );
    let mut program = String::new();
    let random = fs::canonicalize(here.join("../tests/src/random.rs"))?;
    let _ = writeln!(
        program,
        "#[allow(dead_code)]\n#[path = {random:?}]\nmod random;"
    );
    for module in SHARED {
        let path = sources.join(module).with_extension("rs");
        let _ = writeln!(
            program,
            "#[allow(dead_code)]\n#[path = {path:?}]\nmod {module};"
        );
    }
    let mut cases = String::new();
    for (name, declaration) in declarations(count) {
        let _ = writeln!(
            program,
            "mod {name} {{ mbs_runtime::mechanism!({declaration}); }}"
        );
        let _ = writeln!(cases, "        case!({name}),");
    }
    let _ = write!(
        program,
        "
macro_rules! case {{
    ($module:ident) => {{{{
        use mbs_runtime::Mechanism;
        case::Case {{
            name: stringify!($module).to_owned(),
            model: $module::Random::MODEL,
            parameters: Vec::new(),
            step: 1e-3,
            duration: 4.0,
            build: |_, settings| {{
                let mechanism = $module::Random::default();
                Ok(Box::new(mbs_runtime::Simulation::with_any_method(mechanism, settings)?))
            }},
        }}
    }}}};
}}

fn main() -> Result<(), String> {{
    let cases = [
{cases}    ];
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    sweep::run(cases.into(), &arguments, &mut |_| Ok(()))
}}
"
    );
    fs::create_dir_all(folder.join("src"))?;
    fs::write(folder.join("Cargo.toml"), manifest)?;
    fs::write(folder.join("src/main.rs"), program)
}

/// Names and texts.
fn declarations(count: usize) -> Vec<(String, String)> {
    let mut list = vec![
        ("four_bars".to_owned(), four_bars("Joint")),
        ("bars_in_space".to_owned(), bars_in_space()),
    ];
    for number in 0..count {
        let coordinates = COORDINATES[number / 2 % COORDINATES.len()];
        let (kind, text) = match number % 2 {
            0 => ("planar", planar(number / 2, coordinates)),
            _ => ("spatial", spatial(number / 2, coordinates)),
        };
        list.push((format!("{kind}{}", number / 2), text));
    }
    list
}

/// Parallelograms in a row, singular where all bars are horizontal.
fn four_bars(coordinates: &str) -> String {
    let mut text = format!(
        "Random {{ world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = {coordinates}), "
    );
    let turning = "mass = 1.0_kg, length = 1.0_m, angle = 90.0_deg, rate = -1.0_rad_per_s";
    for i in 0..=LOOPS {
        let _ = write!(
            text,
            "crank{i}: Bar({turning}), bearing{i}: Revolute(ground.point({i}.0_m, 0.0), crank{i}.a), "
        );
    }
    for i in 0..LOOPS {
        let next = i + 1;
        let _ = write!(
            text,
            "coupler{i}: Bar(mass = 1.0_kg, length = 1.0_m), left{i}: Revolute(crank{i}.b, coupler{i}.a), \
             right{i}: Revolute(crank{next}.b, coupler{i}.b), "
        );
    }
    text + "}"
}

/// Slender bars on spherical joints, horizontal at the start.
fn bars_in_space() -> String {
    let mut text = "Random { world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]), ".to_owned();
    let mut before = "ground.origin".to_owned();
    for i in 0..BARS {
        let (from, to) = (0.1 * i as f64, 0.1 * (i + 1) as f64);
        let _ = write!(
            text,
            "bar{i}: Bar(mass = 0.1_kg, from = [{from}, 0.0, 0.0], to = [{to}, 0.0, 0.0]), \
             joint{i}: Spherical({before}, bar{i}.a), "
        );
        before = format!("bar{i}.b");
    }
    text + "}"
}
