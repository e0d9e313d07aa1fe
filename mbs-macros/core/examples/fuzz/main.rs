//! Changed declarations for the compiler: it accepts each, or refuses it with a message.
//!
//! `cargo run --release -p mbs-macros-core --example fuzz [COUNT] [SEED] [FOLDER]` changes all declarations of the repository, by
//! tokens and by meaning, and compiles them in child processes, so that hangs, exhausted stacks and exhausted memory
//! are seen. Found inputs are made smaller and written to `tests/corpus`, where a test runs them from then on. If a folder
//! is given, the first accepted inputs are written to it as a package, which `cargo check` has to accept, too.

mod child;
mod find;
mod mutate;
mod package;
mod seeds;
mod tree;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Accepted inputs in the package.
const SAMPLE: usize = 400;

fn main() {
    let mut arguments = std::env::args().skip(1);
    let first = arguments.next();
    if first.as_deref() == Some(child::MODE) {
        return child::serve();
    }
    let count = first.map_or(1000, |text| text.parse().expect("a number of inputs"));
    let seed = arguments.next();
    let seed = seed.map_or(1, |text| text.parse().expect("the seed, a number"));
    let folder = arguments.next().map(PathBuf::from);
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let seeds = seeds::declarations(&root);
    println!("{} declarations", seeds.len());
    let own = std::env::current_exe().expect("this program");
    let command = find::Command::new(own, vec![child::MODE.to_owned()]);
    let seeds = find::weighted(&command, seeds);
    let mut known: BTreeSet<String> = BTreeSet::new();
    let mut accepted = Vec::new();
    let report = find::run(&command, &seeds, seed, count, Duration::MAX, |event| {
        let found = match event {
            find::Event::Found(found) => found,
            find::Event::Accepted(input) => {
                if folder.is_some() && accepted.len() < SAMPLE && package::stands_alone(input) {
                    accepted.push(input.to_vec());
                }
                return;
            }
        };
        if !known.insert(found.fault.signature()) {
            return;
        }
        let small = find::smaller(&command, found);
        println!(
            "input {} of seed {seed}: {}\n{small}\n",
            found.number, found.fault
        );
        let file = root.join(format!("tests/corpus/{seed}-{}.txt", found.number));
        if let Err(error) = std::fs::write(&file, &small) {
            println!("{}: {error}", file.display());
        }
    });
    println!("{report}, {} faults", known.len());
    if let Some(folder) = folder {
        let runtime = root.join("mbs-runtime");
        match package::write(&folder, &runtime, &accepted) {
            Ok(()) => println!("{} accepted in {}", accepted.len(), folder.display()),
            Err(error) => println!("{}: {error}", folder.display()),
        }
    }
    if !known.is_empty() {
        std::process::exit(1);
    }
}
