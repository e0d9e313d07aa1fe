//! Random runs of every scene: steps of three decades, every method that accepts the scene, in one piece or some, with
//! placement and without. The end of each run is compared with the motion that fine runs agree on.
//!
//! `cargo run --release -p mbs-examples --example sweep [COUNT] [SEED] [SCENE] [RUN] [--csv book/src/results/readme]`
//!
//! It fails if a run of the two-level or the projected method is lost without a word, or if a run panics.

mod case;
mod entries;
mod own;
mod random;
mod sweep;
mod table;
mod trial;
mod trusted;

use case::Case;
use mbs_examples::pages::record::Recorder;
use mbs_examples::scenes::{laboratory, scenes, tuning};
use std::collections::BTreeMap;
use table::Count;

/// The names of methods in which no run may be lost.
const OURS: [&str; 2] = ["two-level", "projected"];

fn main() -> Result<(), String> {
    let recorder = Recorder::new("cargo run --release -p mbs-examples --example sweep");
    let mut arguments = recorder.arguments.iter();
    let mut number = |default: usize| match arguments.next() {
        Some(text) => text.parse().map_err(|_| format!("`{text}` is no number")),
        None => Ok(default),
    };
    let (count, seed) = (number(1000)?, number(1)? as u64);
    let scene = recorder.arguments.get(2);
    let only = recorder.arguments.get(3).and_then(|text| text.parse().ok());
    let cases: Vec<Case> = cases()
        .into_iter()
        .filter(|case| scene.is_none_or(|scene| *scene == case.name))
        .collect();
    let mut file = recorder.file("sweep.csv", &table::COLUMNS, 2)?;
    let mut methods: BTreeMap<&str, Count> = BTreeMap::new();
    std::panic::set_hook(Box::new(|_| {}));
    let each = count.div_ceil(cases.len().max(1));
    for case in &cases {
        let counts = match sweep::sweep(case, each, seed, only) {
            Ok(counts) => counts,
            Err(message) => {
                println!("{message}");
                continue;
            }
        };
        for (label, count) in counts {
            let mut row = vec![case.name.clone(), label.to_owned()];
            row.extend(count.cells());
            file.put(row)?;
            methods.entry(label).or_default().join(&count);
        }
    }
    println!("\nall mechanisms");
    let mut wrong = 0;
    for entry in entries::entries() {
        let Some(count) = methods.get(entry.label) else {
            continue;
        };
        println!("  {:24}{count}", entry.label);
        let ours = OURS.iter().any(|name| entry.label.starts_with(name));
        wrong += count.panics + if ours { count.lost } else { 0 };
    }
    match wrong {
        0 => Ok(()),
        wrong => Err(format!("{wrong} runs are lost without a word, or panicked")),
    }
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
