//! `mbs chart work-precision`.

use std::path::Path;

use mbs_examples::laboratory::diagram::draw;
use mbs_examples::laboratory::methods::entries;
use mbs_examples::laboratory::page::{Picture, page};
use mbs_examples::laboratory::store::{Row, Store};
use mbs_examples::laboratory::work_precision::{COLUMNS, Effort, KEYS, Point, measure};
use mbs_examples::laboratory::yardstick::Yardstick;
use mbs_examples::pages::charts::{IN_FULL, fronts, measures};
use mbs_examples::scene::Scene;
use mbs_examples::scenes::scenes;

use super::super::failure::Failure;
use super::super::find;
use super::super::print::print;
use super::super::progress::Points;
use super::{Chart, write};

const SETTINGS: &str =
    "processor time: least of interleaved repeats, with the energy balance of each step";

pub fn run(chart: &Chart, directory: &Path) -> Result<(), Failure> {
    let effort = if chart.quick {
        Effort::QUICK
    } else {
        Effort::FULL
    };
    let mut yardsticks = Vec::new();
    for scene in wanted(chart)? {
        match Yardstick::new(scene) {
            Ok(yardstick) => yardsticks.push(yardstick),
            Err(why) => print(&format!("{}: left out, {why}\n", scene.name))?,
        }
    }
    let path = directory.join("work-precision.csv");
    let (mut store, note) = chart.store(&path, SETTINGS, &COLUMNS, KEYS)?;
    let progress = Points::new("work-precision", yardsticks.len() as u64 * effort.points());
    for yardstick in &yardsticks {
        progress.at(yardstick.scene.name);
        measure(yardstick, &effort, &mut store, &mut || progress.tick())
            .map_err(|e| Failure::writing(&path, e))?;
    }
    progress.finish();
    let pictures: Vec<Picture> = yardsticks
        .iter()
        .flat_map(|yardstick| pictures(yardstick, &store))
        .collect();
    for picture in &pictures {
        let name = format!("work-precision-{}-{}.svg", picture.scene, picture.measure);
        write(&directory.join(name), &picture.svg)?;
    }
    let measured: Vec<&Scene> = yardsticks.iter().map(|yardstick| yardstick.scene).collect();
    let text = fronts(&measured, store.rows());
    write(&directory.join("work-precision-tables.txt"), &text)?;
    let html = page("Processor time against accuracy", &note, &pictures);
    write(&directory.join("work-precision.html"), &html)?;
    print(&format!(
        "{} points of {} scenes, {} pictures and work-precision.html in {}\n",
        store.rows().len(),
        yardsticks.len(),
        pictures.len(),
        directory.display()
    ))
}

/// The points of a scene, each with its row.
fn points<'s>(store: &'s Store, scene: &Scene) -> (Vec<&'s Row>, Vec<Point>) {
    let rows = store.rows().iter().filter(|row| row[0] == scene.name);
    rows.filter_map(|row| Some((row, Point::read(row)?)))
        .unzip()
}

fn wanted(chart: &Chart) -> Result<Vec<&'static Scene>, Failure> {
    if !chart.scenes.is_empty() {
        return chart.scenes.iter().map(|name| find::scene(name)).collect();
    }
    let wanted = |scene: &&Scene| {
        scene.reference.is_some() && (!chart.quick || IN_FULL.contains(&scene.name))
    };
    Ok(scenes().iter().filter(wanted).collect())
}

fn pictures(yardstick: &Yardstick, store: &Store) -> Vec<Picture> {
    let scene = yardstick.scene;
    let (rows, points) = points(store, scene);
    let remarks: Vec<String> = rows
        .iter()
        .zip(&points)
        .filter(|(_, point)| point.outcome.is_failure())
        .map(|(row, _)| {
            format!(
                "{}, {} {}: {} ({})",
                row[1], row[2], row[3], row[5], row[11]
            )
        })
        .collect();
    let entries = entries();
    let labels: Vec<&str> = entries.iter().map(|entry| entry.label).collect();
    let title = format!("{}, {} s", scene.title, scene.duration);
    let note = format!("reactions against {}", yardstick.source);
    measures(scene)
        .map(|measure| Picture {
            scene: scene.name.to_owned(),
            measure: measure.name.to_owned(),
            svg: draw(&title, &note, &labels, &points, measure),
            remarks: remarks.clone(),
        })
        .collect()
}
