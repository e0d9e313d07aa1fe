//! Tests across the workspace; see `tests/`. The pages below are compiled and run as documentation tests.

#[doc = include_str!("../../README.md")]
mod readme {}

#[doc = include_str!("../../book/src/first-mechanism.md")]
mod first_mechanism {}
