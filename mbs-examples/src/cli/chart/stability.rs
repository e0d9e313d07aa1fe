//! `mbs chart stability`.

use std::path::Path;

use mbs_examples::laboratory::outcome_map::draw;
use mbs_examples::laboratory::page::{Picture, page};
use mbs_examples::laboratory::stability::{COLUMNS, KEYS, Map, maps, measure};
use mbs_examples::pages::charts::{cells, map_of};

use super::super::failure::Failure;
use super::super::find::unknown;
use super::super::print::print;
use super::super::progress::Points;
use super::{Chart, write};

const SETTINGS: &str = "outcomes by the criteria of the book";
/// A run is stopped after this processor time, s.
const PATIENCE: f64 = 6.0;
const PATIENCE_QUICK: f64 = 0.2;

pub fn run(chart: &Chart, directory: &Path) -> Result<(), Failure> {
    let patience = if chart.quick {
        PATIENCE_QUICK
    } else {
        PATIENCE
    };
    let all = maps(chart.quick);
    let known = || all.iter().map(|map| map.name);
    for name in &chart.scenes {
        if !known().any(|known| known == name) {
            return Err(Failure(unknown("map", name, known())));
        }
    }
    let wanted = |map: &&Map| chart.scenes.is_empty() || chart.scenes.iter().any(|n| n == map.name);
    let wanted: Vec<&Map> = all.iter().filter(wanted).collect();
    let path = directory.join("stability.csv");
    let (mut store, note) = chart.store(&path, SETTINGS, &COLUMNS, KEYS)?;
    let size = |map: &&Map| map.rows.len() * map.columns.len();
    let progress = Points::new("stability", wanted.iter().map(size).sum::<usize>() as u64);
    let mut pictures = Vec::new();
    let (mut failed, mut tables) = (0, String::new());
    for map in &wanted {
        progress.at(map.name);
        measure(map, patience, &mut store, &mut || progress.tick())
            .map_err(|e| Failure::writing(&path, e))?;
        let cells = cells(map, store.rows());
        let remarks: Vec<String> = cells
            .iter()
            .filter(|cell| cell.outcome.is_failure())
            .map(|c| {
                format!(
                    "{}, {:e}: {} ({})",
                    c.row,
                    c.column,
                    c.outcome.name(),
                    c.detail
                )
            })
            .collect();
        failed += remarks.len();
        tables += &map_of(map, &cells);
        let picture = Picture {
            scene: map.name.to_owned(),
            measure: "outcome".to_owned(),
            svg: draw(map, &cells),
            remarks,
        };
        write(
            &directory.join(format!("stability-{}.svg", map.name)),
            &picture.svg,
        )?;
        pictures.push(picture);
    }
    progress.finish();
    write(&directory.join("stability-tables.txt"), &tables)?;
    let html = page("Where methods fail, and how", &note, &pictures);
    write(&directory.join("stability.html"), &html)?;
    print(&format!(
        "{} maps with {failed} failed cells in {}\n",
        pictures.len(),
        directory.display()
    ))
}
