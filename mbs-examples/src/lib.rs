//! Scenes with references, and what the command line `mbs` needs to run and show them.

pub mod laboratory;
pub mod pages;
pub mod plot;
pub mod reference;
pub mod scene;
pub mod scenes;
pub mod table;
