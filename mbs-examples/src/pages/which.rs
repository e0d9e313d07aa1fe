//! The fastest method of each scene, in one table.

use super::data::Data;
use super::markdown::{significant, table as markdown};
use crate::laboratory::tables::{POSITION, ranking};
use crate::laboratory::work_precision::Point;
use crate::scene::Scene;
use crate::scenes::scenes;
use mbs_runtime::World;

/// Position errors, m or rad.
const BOUNDS: [(f64, &str); 2] = [(1e-3, "1e-3"), (1e-6, "1e-6")];

pub fn table(data: &Data) -> Result<String, String> {
    let results = data.table("work-precision.csv")?;
    let mut heading = vec!["scene".to_owned(), "what it has".to_owned()];
    for (_, bound) in BOUNDS {
        heading.push(format!("fastest for {bound}, ms"));
        heading.push("best `two-level`, ratio".to_owned());
        heading.push("`bdf`, ratio".to_owned());
    }
    let mut rows = Vec::new();
    for scene in scenes() {
        let own = results.rows.iter().filter(|row| row[0] == scene.name);
        let points: Vec<Point> = own.filter_map(Point::read).collect();
        if points.is_empty() {
            continue;
        }
        let mut row = vec![format!("`{}`", scene.name), what(scene)];
        for (bound, _) in BOUNDS {
            row.extend(places(&points, bound));
        }
        rows.push(row);
    }
    let heading: Vec<&str> = heading.iter().map(String::as_str).collect();
    let table = markdown(&heading, &rows);
    Ok(format!("{table}\n\nMeasured at {}.\n", results.source()))
}

/// The fastest method, and how much longer others take.
fn places(points: &[Point], bound: f64) -> [String; 3] {
    let ranking = ranking(points, POSITION, bound);
    let none = || "–".to_owned();
    let Some(&(fastest, least)) = ranking.first() else {
        return [none(), none(), none()];
    };
    let ratio = |family: &str| {
        let best = ranking.iter().find(|(name, _)| name.starts_with(family));
        best.map_or_else(none, |(_, cpu)| significant(cpu / least, 2))
    };
    [
        format!("`{fastest}`, {}", significant(1e3 * least, 2)),
        ratio("two-level"),
        ratio("bdf"),
    ]
}

/// Numbers of velocities and rows, and the properties on which the choice of a method depends.
fn what(scene: &Scene) -> String {
    let model = scene.model;
    let (structure, rows) = (&model.structure, model.rows.len());
    let redundant = model.mobility.is_some_and(|mobility| mobility.rank < rows);
    let traits = [
        (model.world == World::Spatial, "spatial"),
        (redundant, "redundant rows"),
        (structure.holonomic_rows < rows, "nonholonomic rows"),
        (structure.velocity_forces, "forces of velocity"),
        (structure.rheonomic, "driven"),
    ];
    let mut text = format!("{} + {rows}", model.velocities.len());
    for (_, name) in traits.iter().filter(|(holds, _)| *holds) {
        text += &format!(", {name}");
    }
    text
}
