//! `mbs explain`: the model of a scene.

use clap::Args;
use mbs_examples::scene::Scene;
use mbs_runtime::{AnySimulation, Settings};

use super::cost::cost;
use super::failure::Failure;
use super::find;
use super::print::print;

/// Arguments of `mbs explain`.
#[derive(Args)]
pub struct Explain {
    /// Name of the scene; `mbs list` shows them.
    scene: String,
    /// Print the equations in LaTeX instead.
    #[arg(long)]
    latex: bool,
    /// Print the size of each generated function instead.
    #[arg(long, conflicts_with = "latex")]
    cost: bool,
}

impl Explain {
    /// Prints the explanation.
    pub fn run(&self) -> Result<(), Failure> {
        let scene = find::scene(&self.scene)?;
        if self.latex {
            return print(&scene.model.latex()?);
        }
        if self.cost {
            return print(&cost(scene.model)?);
        }
        print(&explain(scene))
    }
}

fn explain(scene: &Scene) -> String {
    let mut text = format!("{}: {}\n", scene.name, scene.title);
    if !scene.source.is_empty() {
        text = text + scene.source + "\n";
    }
    text += &format!("\n{}\nAt the start\n", scene.model.explain());
    let settings = Settings {
        step: scene.step,
        ..Settings::default()
    };
    text + &match (scene.build)(&[], settings) {
        Ok(simulation) => assembled(simulation.as_ref()),
        Err(error) => format!("  assembly     failed: {error}\n"),
    }
}

/// Rank, redundant rows and flow of the assembled mechanism.
fn assembled(simulation: &dyn AnySimulation) -> String {
    let verdict = simulation.assembly();
    let mut text = format!("  rank         {}\n", verdict.rank);
    if !verdict.redundant_rows.is_empty() {
        text += &format!("  redundant    {}\n", verdict.redundant_rows.join(", "));
    }
    text + &format!("  flow         {}\n", simulation.flow().name())
}
