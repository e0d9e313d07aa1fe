//! The tables of the charts, as files that the book's pages include; `mbs chart` writes them, too, from the points it has just
//! measured.

use super::data::Data;
use crate::laboratory::diagram::{MEASURES, Measure};
use crate::laboratory::methods::entries;
use crate::laboratory::stability::{Cell, Map, maps};
use crate::laboratory::store::Row;
use crate::laboratory::tables::{
    COARSE_BOUNDS, FINE_BOUNDS, failed_cells, failures, front, refused,
};
use crate::laboratory::work_precision::Point;
use crate::scene::Scene;
use crate::scenes::scenes;

/// Scenes that are shown in full; those of a quick chart.
pub const IN_FULL: [&str; 3] = ["slider-crank", "double-four-bar", "bricard"];

/// The measures of a scene.
pub fn measures(scene: &Scene) -> impl Iterator<Item = Measure> {
    let reacts = !scene.model.reactions.is_empty();
    MEASURES
        .into_iter()
        .filter(move |measure| measure.index != 2 || reacts)
}

/// Source of the points of speed against accuracy.
pub fn work_precision_source(data: &Data) -> Result<String, String> {
    Ok(data.table("work-precision.csv")?.source())
}

/// Source of the cells of the maps.
pub fn stability_source(data: &Data) -> Result<String, String> {
    Ok(data.table("stability.csv")?.source())
}

/// Speed against accuracy, from the committed points.
pub fn work_precision(data: &Data) -> Result<String, String> {
    let results = data.table("work-precision.csv")?;
    let measured = |scene: &&Scene| results.rows.iter().any(|row| row[0] == scene.name);
    let measured: Vec<&Scene> = scenes().iter().filter(measured).collect();
    Ok(fronts(&measured, &results.rows))
}

/// The fastest methods in these scenes, and the runs that failed.
pub fn fronts(scenes: &[&Scene], rows: &[Row]) -> String {
    let entries = entries();
    let labels: Vec<&str> = entries.iter().map(|entry| entry.label).collect();
    let (mut shown, mut others) = (String::new(), String::from("## The other scenes\n"));
    let mut failed =
        String::from("## Runs that failed\n\n| scene | method | runs |\n|---|---|---|\n");
    let mut refusals = Vec::new();
    for scene in scenes {
        let own = rows.iter().filter(|row| row[0] == scene.name);
        let points: Vec<Point> = own.filter_map(Point::read).collect();
        let picture = |measure: &str| format!("work-precision-{}-{measure}.svg", scene.name);
        if IN_FULL.contains(&scene.name) {
            shown += &format!("\n## `{}`\n", scene.name);
            for measure in ["energy", "position"] {
                shown += &format!("\n![{measure} error]({})\n", picture(measure));
            }
            shown += &format!("\n{}", front(&points, &FINE_BOUNDS));
        } else {
            let links: Vec<String> = measures(scene)
                .map(|measure| format!("[{}]({})", measure.name, picture(measure.name)))
                .collect();
            let front = front(&points, &COARSE_BOUNDS);
            others += &format!("\n`{}`: {}\n\n{front}", scene.name, links.join(", "));
        }
        failed += &failures(scene.name, &points, &labels);
        let list = refused(&points, &labels);
        if !list.is_empty() {
            refusals.push(format!("`{}`: {}", scene.name, list.join(", ")));
        }
    }
    if !refusals.is_empty() {
        failed += &format!("\nNot applicable: {}.\n", refusals.join("; "));
    }
    format!("{shown}\n{others}\n{failed}")
}

/// The maps of stability, from the committed cells.
pub fn stability(data: &Data) -> Result<String, String> {
    let results = data.table("stability.csv")?;
    let maps = maps(false);
    let measured = |map: &&Map| results.rows.iter().any(|row| row[0] == map.name);
    Ok(maps
        .iter()
        .filter(measured)
        .map(|map| map_of(map, &cells(map, &results.rows)))
        .collect())
}

/// The cells of a map.
pub fn cells(map: &Map, rows: &[Row]) -> Vec<Cell> {
    let own = rows.iter().filter(|row| row[0] == map.name);
    own.filter_map(Cell::read).collect()
}

/// A map with every cell that failed.
pub fn map_of(map: &Map, cells: &[Cell]) -> String {
    format!(
        "\n## {0}\n\n![{0}](stability-{1}.svg)\n\n{2}",
        map.title,
        map.name,
        failed_cells(map, cells)
    )
}
