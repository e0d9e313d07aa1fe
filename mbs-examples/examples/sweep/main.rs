//! Random runs of every scene: steps of three decades, every method that accepts the scene, in one piece or some, with
//! placement and without. The end of each run is compared with the motion that fine runs agree on.
//!
//! `cargo run --release -p mbs-examples --example sweep -- [COUNT] [SEED] [SCENE] [RUN] [--csv book/src/results/readme]`
//!
//! It fails if a run of the two-level or the projected method is lost without a word, or if a run panics.
//!
//! With `--package FOLDER [COUNT]` it writes a package with random mechanisms and long chains instead;
//! `cargo run --release -- [COUNT] [SEED] [NAME] [RUN]` there is the same sweep over them.

mod case;
mod entries;
#[allow(dead_code, unused_imports)] // For tests, too.
#[path = "../../../tests/src/mechanisms/mod.rs"]
mod mechanisms;
mod own;
mod package;
#[allow(dead_code)] // For tests, too.
#[path = "../../../tests/src/random.rs"]
mod random;
mod sweep;
mod table;
mod trial;
mod trusted;

use case::Case;
use mbs_examples::pages::record::Recorder;
use mbs_examples::scenes::{laboratory, scenes, tuning};
use std::path::Path;

/// Random mechanisms in a package.
const MECHANISMS: usize = 30;

fn main() -> Result<(), String> {
    let recorder = Recorder::new("cargo run --release -p mbs-examples --example sweep")?;
    if let [first, folder, rest @ ..] = &recorder.arguments[..]
        && first == "--package"
    {
        let count = rest.first().and_then(|text| text.parse().ok());
        return package::write(Path::new(folder), count.unwrap_or(MECHANISMS))
            .map_err(|error| format!("{folder}: {error}"));
    }
    let mut file = recorder.file("sweep.csv", &table::COLUMNS, 2)?;
    sweep::run(cases(), &recorder.arguments, &mut |row| file.put(row))
}

/// The scenes, those of the laboratory, and the mechanisms of this program.
fn cases() -> Vec<Case> {
    let others = [
        &laboratory::NEAR_PARALLELOGRAM,
        &laboratory::UNEQUAL_MASSES,
        &laboratory::SPRING_PENDULUM,
        &tuning::KITE,
        &tuning::FOUR_BAR_IN_SPACE,
    ];
    let all = scenes()
        .iter()
        .chain(others)
        .chain(&laboratory::MODELS)
        .map(|scene| Case {
            name: scene.name.replace(' ', "-"),
            model: scene.model,
            parameters: Vec::new(),
            step: scene.step,
            duration: scene.duration,
            build: scene.build,
        });
    all.chain(own::cases()).collect()
}
