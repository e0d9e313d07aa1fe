//! Long functions as parts: pieces of the same shape become one function with a table of places.
//!
//! ```text
//! function  → groups of operations that depend on the same bodies and serve the same outputs   (groups)
//! groups    → shapes: one piece of straight-line code each, for all groups of that form          (shape)
//! shapes    → runs: the order in which the groups are computed, and where values are kept         (schedule)
//! ```
//!
//! The legs of a platform, the bushings of a frame and the bodies of a chain repeat; their code is written and compiled
//! once. No operation is added, removed or regrouped, so that the digits are those of the straight-line code.

mod dominant;
mod form;
mod free_places;
mod groups;
mod kind;
mod labels;
mod literals;
mod long;
mod schedule;
mod sets;
mod shape;
mod signature;

use super::{Function, Operand, Output};

use form::Forms;

pub use labels::Labels;
pub(super) use sets::{EMPTY, Sets};
pub use shape::Shape;

/// A function as parts. Values that pass from one part to another are in an array, the inputs first.
#[derive(Debug)]
pub struct Parts {
    /// What is copied to the first places of the array.
    pub inputs: Vec<Operand>,
    /// The pieces of code.
    pub shapes: Vec<Shape>,
    /// Which rows of which shape are computed, in order.
    pub runs: Vec<Run>,
    /// The outputs that are values, with their places in the array.
    pub outputs: Vec<(Output, usize)>,
    /// Length of the array.
    pub places: usize,
}

/// Rows of a shape's table, computed one after the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Run {
    /// Index of the shape.
    pub shape: usize,
    /// The first of its rows.
    pub first: usize,
    /// How many.
    pub count: usize,
}

impl Parts {
    /// The parts of a function.
    pub fn of(function: &Function, labels: &Labels) -> Parts {
        let mut forms = Forms::new(function);
        let pieces = groups::of(function, labels);
        let (shapes, members) = shape::of(&mut forms, &pieces);
        let rare = schedule::rare(&members, shapes.len());
        let pieces = pieces.join(function, &members, &rare);
        let (shapes, members) = shape::of(&mut forms, &pieces);
        let rare = schedule::rare(&members, shapes.len());
        let order = schedule::ordered(&pieces, &members, &rare);
        let groups = pieces.gather(&order, |group| rare[members[group].shape]);
        let (mut shapes, mut members) = shape::of(&mut forms, &groups);
        literals::write(&mut shapes, &mut members);
        let rare = schedule::rare(&members, shapes.len());
        let order = schedule::ordered(&groups, &members, &rare);
        schedule::of(function, &groups, shapes, members, order)
    }

    /// The runs, in order: the shape of each, and its rows.
    pub fn rows(&self) -> impl Iterator<Item = (usize, &[Vec<u32>])> {
        self.runs.iter().map(|run| {
            let table = &self.shapes[run.shape].table;
            (run.shape, &table[run.first..run.first + run.count])
        })
    }

    /// The number of operations that are written out.
    pub fn operations(&self) -> usize {
        let lengths = self
            .shapes
            .iter()
            .map(|shape| shape.function.operations.len());
        lengths.sum()
    }
}
