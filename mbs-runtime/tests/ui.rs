//! What rustc makes of a wrong `mechanism!`. A wrong program costs a run of rustc, and this package has the fewest
//! dependencies, so that a few of each nature are here; `tests/tests/ui.rs` compares the messages of all.

#[test]
fn wrong_programs() {
    trybuild::TestCases::new().compile_fail("tests/ui/*.rs");
}
