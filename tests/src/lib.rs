//! What the tests across the workspace share; the tests themselves are in `tests/`.

pub mod compiled;
pub mod differences;
pub mod fixtures;
pub mod interpreted;
pub mod laws;
pub mod random;
pub mod table;
pub mod tampered;
