//! The README's table of scenes: errors of each scene with its own step, and the least time of a step; then the
//! residuals of the rows with other steps.
//!
//! `cargo run --release -p mbs-examples --example scene_table [--csv book/src/results/readme]`

use mbs_examples::pages::record::Recorder;
use mbs_examples::pages::rows;
use mbs_examples::pages::scene_runs::{COLUMNS, KEYS, SCENES, run, scene, time};

/// Times are the least of this number of interleaved repeats.
const REPEATS: usize = 10;

fn main() -> Result<(), String> {
    let recorder = Recorder::new("cargo run --release -p mbs-examples --example scene_table")?;
    recorder.check_names([])?;
    let mut file = recorder.file("scenes.csv", &COLUMNS, KEYS)?;
    let scenes = SCENES.map(|(name, _)| scene(name));
    let scenes = scenes.into_iter().collect::<Result<Vec<_>, _>>()?;
    let mut least = vec![f64::INFINITY; scenes.len()];
    for _ in 0..REPEATS {
        for (scene, least) in scenes.iter().zip(&mut least) {
            *least = least.min(time(scene)?);
        }
    }
    println!("{}", COLUMNS.join(" "));
    for (scene, least) in scenes.iter().zip(least) {
        let mut row = run(scene)?;
        if let Some(time) = row.last_mut() {
            *time = format!("{least:.4}");
        }
        println!("{}", row.join(" "));
        file.put(row)?;
    }
    let mut file = recorder.file("rows.csv", &rows::COLUMNS, rows::KEYS)?;
    println!("\n{}", rows::COLUMNS.join(" "));
    for scene in scenes.iter().filter(|scene| !scene.model.rows.is_empty()) {
        for step in rows::steps(scene) {
            file.put(rows::run(scene, step)?)?;
        }
        println!("{}", scene.name);
    }
    Ok(())
}
