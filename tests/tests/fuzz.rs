//! Changed declarations, compiled in child processes: each is accepted or refused with a message, in time, and on a stack
//! of the size that the compiler of Rust has. More of them: `cargo run --release -p mbs-macros-core --example fuzz 1000000`.

#[path = "../../mbs-macros/core/examples/fuzz/child.rs"]
mod child;
#[path = "../../mbs-macros/core/examples/fuzz/find.rs"]
mod find;
#[path = "../../mbs-macros/core/examples/fuzz/mutate.rs"]
mod mutate;
#[path = "../../mbs-macros/core/examples/fuzz/seeds.rs"]
mod seeds;
#[path = "../../mbs-macros/core/examples/fuzz/tree.rs"]
mod tree;

use mbs_tests::pages::root;
use std::time::Duration;

/// This program again, with nothing but the child below.
fn command() -> find::Command {
    let own = std::env::current_exe().expect("this program");
    let arguments = ["--exact", "fuzz::child_process", "--nocapture"];
    find::Command::new(own, arguments.map(str::to_owned).into())
}

/// Compiles for the tests below, in a process of its own.
#[test]
fn child_process() {
    if std::env::var_os(find::IS_CHILD).is_some() {
        child::serve();
    }
}

#[test]
fn changed_declarations_are_answered() {
    let command = command();
    let seeds = find::weighted(&command, seeds::declarations(&root()));
    assert!(seeds.len() > 100, "{} declarations", seeds.len());
    let mut faults = Vec::new();
    let limit = Duration::from_secs(20);
    let report = find::run(&command, &seeds, 2, 2500, limit, |event| {
        if let find::Event::Found(found) = event {
            let (fault, text) = (&found.fault, tree::text(&found.input));
            faults.push(format!("{}: {fault}\n{text}", found.number));
        }
    });
    println!("{report}");
    assert!(faults.is_empty(), "{}", faults.join("\n\n"));
    assert!(report.accepted > 10 && report.refused > 100, "{report}");
}

/// Inputs that once were not answered.
#[test]
fn the_corpus_is_answered() {
    let (command, folder) = (command(), root().join("tests/corpus"));
    let mut checked = 0;
    for entry in std::fs::read_dir(folder).expect("the corpus is there") {
        let path = entry.expect("readable").path();
        let text = std::fs::read_to_string(&path).expect("readable");
        if let Err(fault) = find::check(&command, &text) {
            panic!("{}: {fault}\n{text}", path.display());
        }
        checked += 1;
    }
    assert!(checked > 5, "{checked} inputs only");
}
