//! `mbs list`: the scenes and the size of their models.

use clap::Args;
use mbs_examples::absent;
use mbs_examples::scene::Scene;
use mbs_examples::scenes::scenes;
use mbs_runtime::{Quantity, Settings};
use serde_json::{Value, json};

use super::failure::Failure;
use super::print::print;
use super::table::{Align, table};

/// Arguments of `mbs list`.
#[derive(Args)]
pub struct List {
    /// Print one array of objects instead of a table.
    #[arg(long)]
    json: bool,
}

impl List {
    /// Prints the list.
    pub fn run(&self) -> Result<(), Failure> {
        if self.json {
            let scenes: Value = scenes().iter().map(object).collect();
            // Not part of the array, but not silent either.
            if let Some(more) = absent::more() {
                eprint!("{}", more.trim_start());
            }
            print(&format!("{scenes:#}\n"))
        } else {
            print(&(text() + &absent::more().unwrap_or_default()))
        }
    }
}

fn text() -> String {
    let heading = [
        ("scene", Align::Left),
        ("coordinates", Align::Right),
        ("rows", Align::Right),
        ("rank", Align::Right),
        ("what", Align::Left),
        ("source", Align::Left),
    ];
    let rows: Vec<_> = scenes()
        .iter()
        .map(|scene| {
            [
                scene.name.to_owned(),
                scene.model.coordinates.len().to_string(),
                scene.model.rows.len().to_string(),
                rank(scene).map_or("?".to_owned(), |rank| rank.to_string()),
                scene.title.to_owned(),
                scene.source.to_owned(),
            ]
        })
        .collect();
    table(heading, &rows)
}

fn object(scene: &Scene) -> Value {
    json!({
        "scene": scene.name,
        "title": scene.title,
        "source": scene.source,
        "coordinates": scene.model.coordinates.len(),
        "velocities": scene.model.velocities.len(),
        "rows": scene.model.rows.len(),
        "rank": rank(scene),
        "duration_s": scene.duration,
        "step_s": scene.step,
        "outputs": scene.model.outputs.iter().map(|output| output.name).collect::<Vec<_>>(),
        "parameters": scene.model.parameters.iter().map(quantity).collect::<Value>(),
        "inputs": scene.model.inputs.iter().map(quantity).collect::<Value>(),
        "reference": scene.reference.map(|reference| reference.file),
    })
}

/// The names for `mbs simulate --set`.
fn quantity(quantity: &Quantity) -> Value {
    json!({"name": quantity.name, "unit": quantity.unit, "default": quantity.default})
}

/// The rank is computed numerically, so that the mechanism has to be assembled.
fn rank(scene: &Scene) -> Option<usize> {
    let settings = Settings {
        step: scene.step,
        ..Settings::default()
    };
    let simulation = (scene.build)(&[], settings).ok()?;
    Some(simulation.assembly().rank)
}
