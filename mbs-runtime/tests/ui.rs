//! What rustc makes of a wrong `mechanism!`. A wrong program costs a run of rustc, and this package has the fewest
//! dependencies, so that a few of each nature are here; `tests/tests/ui.rs` compares the messages of all but assemblies.

#[test]
fn wrong_programs() {
    let programs = trybuild::TestCases::new();
    programs.compile_fail("tests/ui/*.rs");
    // Uses of assemblies of another crate.
    programs.compile_fail("tests/parts/*.rs");
}
