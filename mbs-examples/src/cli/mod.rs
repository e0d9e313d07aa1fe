//! The command line. A failure gives a message on stderr that says what to do, and exit code 1.

mod chart;
mod explain;
mod failure;
mod find;
mod list;
mod pages;
mod paper;
mod print;
mod progress;
mod request;
mod results;
mod simulate;
mod summary;

use std::process::ExitCode;

use clap::{Parser, Subcommand};
use mbs_examples::table;

use failure::Failure;

/// Multibody mechanisms, declared with `mechanism!` and integrated with ALF-3F.
#[derive(Parser)]
#[command(name = "mbs", version, arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// List the scenes.
    List(list::List),
    /// Run a scene, write its trajectory, diagrams and animation, and print a summary.
    Simulate(simulate::Simulate),
    /// Show the model of a scene.
    Explain(explain::Explain),
    /// Compare the methods: speed against accuracy, stability, the cost of models.
    Chart(chart::Chart),
    /// Draw the figures of the paper, with other methods beside its own.
    Paper(paper::Paper),
    /// Write measured numbers into the README and the book.
    Pages(pages::Pages),
}

/// Runs the command line of this process.
pub fn main() -> ExitCode {
    let done = match Arguments::try_parse() {
        Ok(arguments) => match arguments.command {
            Command::List(list) => list.run(),
            Command::Simulate(simulate) => simulate.run(),
            Command::Explain(explain) => explain.run(),
            Command::Chart(chart) => chart.run(),
            Command::Paper(paper) => paper.run(),
            Command::Pages(pages) => pages.run(),
        },
        // The options for help and version are not failures.
        Err(message) if !message.use_stderr() => print::print(&message.to_string()),
        Err(message) => {
            let _ = message.print();
            return ExitCode::FAILURE;
        }
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(Failure(message)) => {
            // If stderr is closed, the message is lost.
            let _ = std::io::Write::write_all(
                &mut std::io::stderr(),
                format!("error: {message}\n").as_bytes(),
            );
            ExitCode::FAILURE
        }
    }
}
