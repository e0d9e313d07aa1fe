//! The command line. A failure gives a message on stderr that says what to do, and exit code 1.

#[cfg(feature = "laboratory")]
mod chart;
#[cfg(feature = "laboratory")]
mod cost;
#[cfg(feature = "laboratory")]
mod explain;
mod failure;
mod find;
mod list;
#[cfg(feature = "laboratory")]
mod pages;
#[cfg(feature = "laboratory")]
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
#[cfg_attr(not(feature = "laboratory"), command(after_help = find::in_laboratory()))]
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
    #[cfg(feature = "laboratory")]
    Explain(explain::Explain),
    /// Compare the methods: speed against accuracy, stability, the cost of models.
    #[cfg(feature = "laboratory")]
    Chart(chart::Chart),
    /// Draw the figures of the paper, with other methods beside its own.
    #[cfg(feature = "laboratory")]
    Paper(paper::Paper),
    /// Write measured numbers into the README and the book.
    #[cfg(feature = "laboratory")]
    Pages(pages::Pages),
    /// The commands of the feature.
    #[cfg(not(feature = "laboratory"))]
    #[command(external_subcommand)]
    Other(Vec<String>),
}

/// Runs the command line of this process.
pub fn main() -> ExitCode {
    let done = match Arguments::try_parse() {
        Ok(arguments) => match arguments.command {
            Command::List(list) => list.run(),
            Command::Simulate(simulate) => simulate.run(),
            #[cfg(feature = "laboratory")]
            Command::Explain(explain) => explain.run(),
            #[cfg(feature = "laboratory")]
            Command::Chart(chart) => chart.run(),
            #[cfg(feature = "laboratory")]
            Command::Paper(paper) => paper.run(),
            #[cfg(feature = "laboratory")]
            Command::Pages(pages) => pages.run(),
            #[cfg(not(feature = "laboratory"))]
            Command::Other(words) => Err(other(&words)),
        },
        // `help` knows the commands of this build only.
        #[cfg(not(feature = "laboratory"))]
        Err(_) if absent_in_help().is_some() => Err(other(absent_in_help().as_slice())),
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

/// The command after `help`, if this build does not have it.
#[cfg(not(feature = "laboratory"))]
fn absent_in_help() -> Option<String> {
    let mut words = std::env::args_os().skip(1);
    let is_help = words.next()? == "help";
    let command = words.next()?.into_string().ok()?;
    let is_absent = mbs_examples::absent::COMMANDS.contains(&command.as_str());
    (is_help && is_absent).then_some(command)
}

/// A command that this build does not have.
#[cfg(not(feature = "laboratory"))]
fn other(words: &[String]) -> Failure {
    use mbs_examples::absent;
    let name = words.first().map_or("", String::as_str);
    if absent::COMMANDS.contains(&name) {
        return Failure(find::absent(&format!("the command `{name}`")));
    }
    let known = ["list", "simulate"].into_iter().chain(absent::COMMANDS);
    Failure(find::unknown("command", name, known))
}
