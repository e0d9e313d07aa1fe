//! Growth of the equations of a chain: operations of its functions in joint coordinates, and the time of their
//! derivation.
//!
//! `cargo run -p mbs-examples --example chain_costs` (unoptimised, as in users' builds)

use mbs_macros_core::{analyse, dag};
use std::fmt::Write;
use std::time::Instant;

/// Links.
const LENGTHS: [usize; 5] = [2, 4, 8, 16, 32];
/// Functions whose operations are counted.
const FUNCTIONS: [&str; 5] = [
    "momentum",
    "forces",
    "potential_energy",
    "mass_matrix",
    "force_tangents",
];

/// A chain of round bars that hang from the ground by revolutes about X and Y in turn.
fn chain(links: usize) -> String {
    let mut out = String::from(
        "Chain {\nworld: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2], coordinates = Joint),\n",
    );
    for k in 0..links {
        let (from, to) = (k, k + 1);
        let before = match k {
            0 => "ground".to_owned(),
            k => format!("link{}", k - 1),
        };
        let axis = ["X", "Y"][k % 2];
        let _ = writeln!(
            out,
            "link{k}: Bar(mass = 1.0_kg, from = [0.0, 0.0, -{from}.0], to = [0.0, 0.0, -{to}.0], radius = 0.05_m),\n\
             joint{k}: Revolute({before}, link{k}, at = [0.0, 0.0, -{from}.0], axis = {axis}),"
        );
    }
    out + "}"
}

fn main() {
    print!("{:>5}", "links");
    for function in FUNCTIONS {
        print!(" {function:>17}");
    }
    println!(" {:>10}", "derived in");
    for links in LENGTHS {
        let Ok(tokens) = chain(links).parse() else {
            return;
        };
        let start = Instant::now();
        let (_, outcome) = analyse(tokens);
        let Ok(analysis) = outcome else {
            println!("{links:>5} does not derive");
            return;
        };
        let program = dag::lower(&analysis.derived);
        let time = start.elapsed();
        print!("{links:>5}");
        for name in FUNCTIONS {
            let mut functions = program.functions.iter();
            let count = functions
                .find(|function| function.name == name)
                .map_or(0, |function| function.cost().total());
            print!(" {count:>17}");
        }
        println!(" {:>8.2} s", time.as_secs_f64());
    }
}
