//! The parts of the README and the book that programs write.
//!
//! Programs that measure keep their results as CSV below `book/src/results`. `mbs pages` renders these into the pages:
//! into blocks between two comments, and into whole files that pages include. `tests/pages.rs` fails if a page differs
//! from the text rendered from its data. [`registry`] lists the blocks; a new one is a function from
//! [`Data`](data::Data) to Markdown, a line there, and two comments on the page.

pub mod accuracies;
pub mod block;
mod calls;
pub mod candidates;
pub mod cases;
pub mod charts;
mod compile_times;
mod compositions;
mod damped;
pub mod data;
mod derivation;
mod instructions;
pub mod markdown;
pub mod method_changes;
mod model_size;
pub mod orders;
mod others;
mod paper;
pub mod phases;
pub mod random_jumps;
mod random_passages;
pub mod record;
pub mod registry;
pub mod rival;
pub mod rows;
pub mod scene_runs;
mod scenes;
mod springs;
mod sweep;
pub mod symbolic;
pub mod tolerances;
mod tuning;
pub mod update;
mod which;
