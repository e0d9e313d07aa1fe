//! Scenes with references, and the code of the command line `mbs`, which runs and shows them.

pub mod absent;
#[cfg(feature = "laboratory")]
pub mod laboratory;
#[cfg(feature = "laboratory")]
pub mod pages;
pub mod reference;
pub mod scene;
pub mod scenes;

pub use mbs_runtime::output::{plot, table};

mod start;
pub use start::start;
