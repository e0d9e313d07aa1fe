//! `mbs chart`: the method laboratory.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use mbs_examples::laboratory::diagram::{MEASURES, draw};
use mbs_examples::laboratory::methods::entries;
use mbs_examples::laboratory::page::{Picture, page};
use mbs_examples::laboratory::provenance::provenance;
use mbs_examples::laboratory::store::Store;
use mbs_examples::laboratory::work_precision::{COLUMNS, Effort, KEYS, Point, measure};
use mbs_examples::laboratory::yardstick::Yardstick;
use mbs_examples::scene::Scene;
use mbs_examples::scenes::scenes;

use super::failure::Failure;
use super::find;
use super::print::print;
use super::progress::Points;

/// Arguments of `mbs chart`.
#[derive(Args)]
pub struct Chart {
    /// Which chart.
    #[arg(value_enum)]
    kind: Kind,
    /// Scenes [default: all that the chart is for].
    scenes: Vec<String>,
    /// Fewer points: two minutes instead of half an hour.
    #[arg(long)]
    quick: bool,
    /// Directory for the files [default: out/chart].
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Kind {
    /// Processor time against errors of position, energy and reactions, for all methods.
    WorkPrecision,
}

/// Scenes of a quick chart.
const QUICK: [&str; 3] = ["slider-crank", "double-four-bar", "bricard"];

impl Chart {
    /// Measures what is not known yet and draws.
    pub fn run(&self) -> Result<(), Failure> {
        let directory = self.out.clone().unwrap_or_else(|| "out/chart".into());
        fs::create_dir_all(&directory).map_err(|e| Failure::writing(&directory, e))?;
        match self.kind {
            Kind::WorkPrecision => self.work_precision(&directory),
        }
    }

    fn note(&self, settings: &str) -> String {
        let extent = if self.quick { "quick" } else { "full" };
        format!("{}; {extent}; {settings}", provenance())
    }

    fn work_precision(&self, directory: &Path) -> Result<(), Failure> {
        let effort = if self.quick { Effort::QUICK } else { Effort::FULL };
        let mut yardsticks = Vec::new();
        for scene in self.with_reference()? {
            match Yardstick::new(scene) {
                Ok(yardstick) => yardsticks.push(yardstick),
                Err(why) => print(&format!("{}: left out, {why}\n", scene.name))?,
            }
        }
        let note = self.note("processor time: least of interleaved repeats, with the energy balance of each step");
        let path = directory.join("work-precision.csv");
        let failed = |e: io::Error| Failure::writing(&path, e);
        let mut store = Store::open(&path, &note, &COLUMNS, KEYS).map_err(failed)?;
        let progress = Points::new("work-precision", yardsticks.len() as u64 * effort.points());
        for yardstick in &yardsticks {
            progress.at(yardstick.scene.name);
            measure(yardstick, &effort, &mut store, &mut || progress.tick()).map_err(failed)?;
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

    fn with_reference(&self) -> Result<Vec<&'static Scene>, Failure> {
        if !self.scenes.is_empty() {
            return self.scenes.iter().map(|name| find::scene(name)).collect();
        }
        let wanted = |scene: &&Scene| {
            scene.reference.is_some() && (!self.quick || QUICK.contains(&scene.name))
        };
        Ok(scenes().iter().filter(wanted).collect())
    }
}

fn pictures(yardstick: &Yardstick, store: &Store) -> Vec<Picture> {
    let scene = yardstick.scene;
    let rows = store.rows().iter().filter(|row| row[0] == scene.name);
    let points: Vec<Point> = rows.clone().filter_map(Point::read).collect();
    let remarks: Vec<String> = rows
        .zip(&points)
        .filter(|(_, point)| point.outcome.is_failure())
        .map(|(row, _)| format!("{}, {} {}: {} ({})", row[1], row[2], row[3], row[5], row[11]))
        .collect();
    let labels: Vec<&str> = entries().iter().map(|entry| entry.label).collect();
    let draw_one = |measure| {
        let title = format!("{}, {} s", scene.title, scene.duration);
        let note = format!("reactions against {}", yardstick.source);
        draw(&title, &note, &labels, &points, measure)
    };
    MEASURES
        .iter()
        .filter(|measure| measure.index != 2 || !scene.model.reactions.is_empty())
        .map(|&measure| Picture {
            scene: scene.name.to_owned(),
            measure: measure.name.to_owned(),
            svg: draw_one(measure),
            remarks: remarks.clone(),
        })
        .collect()
}

fn write(path: &Path, text: &str) -> Result<(), Failure> {
    fs::write(path, text).map_err(|e| Failure::writing(path, e))
}
