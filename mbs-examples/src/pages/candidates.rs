//! The coordinate descriptions that the compiler compared.

use mbs_runtime::Model;

use super::data::Data;
use super::scene_runs::scene;
use crate::table::{Align, table};

use Align::{Left, Right};

/// The table of the candidates, with the heading of `mbs explain`.
pub fn considered(model: &Model) -> String {
    let rows = model.candidates.iter().map(|candidate| {
        [
            candidate.formulation.to_owned(),
            cut(candidate.cut),
            candidate.velocities.to_string(),
            candidate.rows.to_string(),
            candidate
                .rank
                .map_or_else(String::new, |rank| rank.to_string()),
            candidate
                .operations
                .map_or_else(|| "more".to_owned(), |operations| operations.to_string()),
            if candidate.taken { "taken" } else { "" }.to_owned(),
        ]
    });
    let rows: Vec<_> = rows.collect();
    let heading = [
        ("choice", Left),
        ("loops cut at", Left),
        ("velocities", Right),
        ("rows", Right),
        ("rank", Right),
        ("operations", Right),
        ("", Left),
    ];
    format!(
        "Coordinates considered, with the estimated operations of a step\n{}",
        table(heading, &rows)
    )
}

/// The joints that close loops; their number where there are many.
fn cut(joints: &[&str]) -> String {
    match joints.len() {
        0..=3 => joints.join(", "),
        many => format!("{many} joints"),
    }
}

/// The tables of two scenes, as `mbs explain` prints them.
pub fn text(_: &Data) -> Result<String, String> {
    let parts =
        ["slider-crank", "bricard"].map(|name| scene(name).map(|scene| considered(scene.model)));
    let parts: Vec<String> = parts.into_iter().collect::<Result<_, _>>()?;
    Ok(format!("```text\n{}```", parts.join("\n")))
}
