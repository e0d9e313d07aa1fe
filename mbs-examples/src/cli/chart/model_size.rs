//! `mbs chart model-size`.

use std::path::Path;

use mbs_examples::laboratory::model_size::{COLUMNS, KEYS, draw, measure, points};
use mbs_examples::laboratory::yardstick::Yardstick;
use mbs_examples::scenes::laboratory::MODELS;

use super::super::failure::Failure;
use super::super::find;
use super::super::print::print;
use super::super::progress::Points;
use super::super::table::{Align, table};
use super::{Chart, write};

const SETTINGS: &str =
    "processor time: least of interleaved repeats, with the energy balance of each step";

pub fn run(chart: &Chart, directory: &Path) -> Result<(), Failure> {
    let repeats = if chart.quick { 2 } else { 20 };
    let known = MODELS.iter().map(|model| model.name);
    let mut names = chart.scenes.iter();
    if let Some(name) = names.find(|name| !known.clone().any(|known| known == *name)) {
        return Err(find::unknown("model", name, known).into());
    }
    let wanted = |name: &str| chart.scenes.is_empty() || chart.scenes.iter().any(|own| own == name);
    let models = MODELS.iter().filter(|model| wanted(model.name));
    let models: Result<Vec<Yardstick>, String> = models.map(Yardstick::new).collect();
    let models = models?;
    let path = directory.join("model-size.csv");
    let (mut store, _) = chart.store(&path, SETTINGS, &COLUMNS, KEYS)?;
    let progress = Points::new("model-size", points(models.len()) as u64);
    measure(&models, repeats, &mut store, &mut || progress.tick())
        .map_err(|e| Failure::writing(&path, e))?;
    progress.finish();
    write(&directory.join("model-size.svg"), &draw(store.rows()))?;
    let heading = [
        ("model", Align::Left),
        ("method", Align::Left),
        ("bound, m", Align::Right),
        ("velocities", Align::Right),
        ("rows", Align::Right),
        ("rank", Align::Right),
        ("operations", Align::Right),
        ("step, s", Align::Right),
        ("time, s", Align::Right),
    ];
    let rows: Vec<_> = store
        .rows()
        .iter()
        .map(|row| [0, 1, 2, 4, 5, 6, 7, 9, 10].map(|i| row[i].clone()))
        .collect();
    print(&table(heading, &rows))
}
