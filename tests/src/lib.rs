//! What the tests across the workspace share; the tests themselves are in `tests/`. The pages below are compiled and run
//! as documentation tests.

pub mod compiled;
pub mod differences;
pub mod fixtures;
pub mod interpreted;
pub mod laws;
pub mod random;
pub mod reference;
pub mod table;
pub mod tampered;

#[doc = include_str!("../../README.md")]
mod readme {}

#[doc = include_str!("../../book/src/first-mechanism.md")]
mod first_mechanism {}
