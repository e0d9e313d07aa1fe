//! The outputs of a body as statements.
//!
//! LLVM needs much more than proportional time for a long block of stores. Most entries of a large constant matrix have
//! one of few values, so that these are written in a loop over the places of each.

use super::blocks::let_all;
use super::body::Body;
use super::progressions::{folded, looped};
use crate::dag::{Operand, Output, Place};
use crate::symbolic::{Map, Symbol};
use std::fmt::Write;

/// Up to so many outputs are written one by one.
const MOST: usize = 600;
/// Fewer places of one value make no loop.
const FEWEST: usize = 8;

/// What the places of a loop have in common: the sink, the number of indices, and the value.
type Kind = (&'static str, usize, Operand);

impl Body<'_> {
    /// Writes into vectors by index and into matrices through their sinks.
    pub(super) fn writes(&self) -> String {
        let outputs = &self.function.outputs;
        let mut alike: Map<Kind, Vec<&Output>> = Map::default();
        if outputs.len() > MOST {
            for output in outputs.iter().filter(|output| is_given(output.value)) {
                alike.entry(kind(output)).or_default().push(output);
            }
        }
        let mut out = String::new();
        let_all(&mut out, &self.constants());
        let mut singles = Vec::new();
        for output in outputs {
            match alike.get_mut(&kind(output)) {
                Some(list) if list.is_empty() => {}
                Some(list) if list.len() >= FEWEST => {
                    put(&mut out, &mut singles, outputs.len());
                    out.push_str(&self.repeated(&std::mem::take(list)));
                }
                _ => singles.push(self.single(output)),
            }
        }
        put(&mut out, &mut singles, outputs.len());
        out
    }

    /// Constants with their values.
    fn constants(&self) -> Vec<(String, String)> {
        let outputs = self.function.outputs.iter();
        let constants = outputs.filter_map(|output| match output.place {
            Place::Constant(slot) => Some((format!("k{slot}"), self.value(output))),
            _ => None,
        });
        constants.collect()
    }

    fn single(&self, output: &Output) -> String {
        let value = self.value(output);
        match output.place {
            Place::Value => value,
            Place::Constant(_) => String::new(),
            _ => {
                let indices = indices(output.place);
                statement(output, &indices, &value) + "\n"
            }
        }
    }

    /// A loop over the places of one value.
    fn repeated(&self, outputs: &[&Output]) -> String {
        let Some(first) = outputs.first() else {
            return String::new();
        };
        let names: Vec<String> = ["i", "j", "k"].map(str::to_owned).into();
        let names = &names[..indices(first.place).len()];
        let value = self.value(first);
        let single = |output: &&Output| statement(output, &indices(output.place), &value);
        if let Some(loops) = looped(outputs.iter().map(single).collect()) {
            return loops;
        }
        let statement = statement(first, names, &value);
        let mut out = String::new();
        if !statement.is_empty() {
            let places = outputs.iter().map(|output| indices(output.place));
            let places: Vec<String> = places
                .map(|place| format!("[{}]", place.join(", ")))
                .collect();
            let _ = writeln!(
                out,
                "for &[{}] in &[{}] {{ {statement} }}",
                names.join(", "),
                places.join(", ")
            );
        }
        out
    }
}

/// Writes statements, as loops where there are many.
fn put(out: &mut String, statements: &mut Vec<String>, outputs: usize) {
    let statements = std::mem::take(statements);
    match outputs > MOST {
        true => out.push_str(&folded(statements)),
        false => out.extend(statements.iter().map(|statement| statement.as_str())),
    }
}

/// Whether a value is not computed in the body.
fn is_given(value: Operand) -> bool {
    match value {
        Operand::Number(_) | Operand::Constant(_) => true,
        Operand::Symbol(symbol) => matches!(symbol, Symbol::Parameter(_)),
        Operand::Value(_) => false,
    }
}

fn kind(output: &Output) -> Kind {
    let indices = match output.place {
        Place::Value | Place::Constant(_) => 0,
        Place::Element(_) => 1,
        Place::Entry(..) => 2,
        Place::Tensor(..) => 3,
    };
    (output.sink, indices, output.value)
}

fn indices(place: Place) -> Vec<String> {
    let list: &[usize] = match place {
        Place::Value | Place::Constant(_) => &[],
        Place::Element(i) => &[i],
        Place::Entry(i, j) => &[i, j],
        Place::Tensor(i, j, k) => &[i, j, k],
    };
    list.iter().map(usize::to_string).collect()
}

/// The statement that writes a value to a place; empty if it need not be written.
fn statement(output: &Output, indices: &[String], value: &str) -> String {
    let sink = output.sink;
    match output.place {
        Place::Element(_) => format!("{sink}[{}] = {value};", indices[0]),
        // Kernels write plain arrays; everything else goes through a sink and leaves its zeros unwritten.
        _ if sink == "w" || sink == "delassus" => {
            format!("{sink}[{}][{}] = {value};", indices[0], indices[1])
        }
        _ if output.value == Operand::number(0.0) => String::new(),
        _ => format!("{sink}.set({}, {value});", indices.join(", ")),
    }
}
