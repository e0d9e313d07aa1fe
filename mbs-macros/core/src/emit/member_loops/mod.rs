//! Long functions whose parts repeat at even distances, as loops.
//!
//! From one member of a family to the next the places of a part grow by the same steps. A loop then counts them: it reads
//! arguments and writes results where they are, so that there is no table, and only what passes from one part to another
//! is in an array.

mod members;
mod repetitions;
mod write;

use crate::contract::{Method, Shape as Argument};
use crate::dag::{Output, Parts};
use crate::symbolic::{Graph, Map};

/// Fewer turns make no loop.
const FEWEST: usize = 8;

/// An array, or what stands for one.
#[derive(Clone, PartialEq, Eq, Hash)]
enum Array {
    /// What passes from one part to another.
    Values,
    /// An argument of the function.
    Argument(String),
    /// The same for all members.
    Common(String),
    /// A number for each member, as bits: lengths that differ by round-off, say.
    Numbers(Vec<u64>),
    /// A result with this number of indices.
    Result(&'static str, usize),
}

/// A place in an array.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Spot {
    array: usize,
    at: [usize; 3],
}

/// A use of a shape, or a result that is an argument.
struct Member {
    /// The shape; none for a result that is an argument.
    shape: Option<usize>,
    /// What is read, then where values go.
    spots: Vec<Spot>,
    /// Of each value that is left to how many places it goes: to the array first.
    goes: Vec<usize>,
}

/// Members that follow each other: some of them in each turn.
struct Repetition {
    first: usize,
    period: usize,
    times: usize,
}

/// A function in loops.
struct Loops<'a> {
    graph: &'a Graph,
    parts: &'a Parts,
    arrays: Vec<Array>,
    known: Map<Array, usize>,
    /// Where the inputs of the parts stand.
    inputs: Vec<Spot>,
    members: Vec<Member>,
}

/// The body of a method that computes the parts, and writes these outputs from their places; `None` if that would be long.
pub(super) fn body(
    graph: &Graph,
    parts: &Parts,
    outputs: &[(Output, usize)],
    method: &Method,
) -> Option<String> {
    let last = method.arguments.last().map(|last| last.shape);
    if matches!(last, Some(Argument::Values | Argument::Points)) {
        return None;
    }
    let mut loops = Loops {
        graph,
        parts,
        arrays: Vec::new(),
        known: Map::default(),
        inputs: Vec::new(),
        members: Vec::new(),
    };
    loops.find_inputs(outputs)?;
    let runs = loops.find_members(outputs);
    let plan = loops.plan(runs)?;
    Some(loops.write(&plan, outputs, method))
}

impl Loops<'_> {
    fn array(&mut self, array: Array) -> usize {
        let next = self.arrays.len();
        let index = *self.known.entry(array.clone()).or_insert(next);
        if index == next {
            self.arrays.push(array);
        }
        index
    }

    fn value(&mut self, place: usize) -> Spot {
        let array = self.array(Array::Values);
        Spot {
            array,
            at: [place, 0, 0],
        }
    }
}
