//! Wrong programs: what the user sees. Each has one mistake and shows one message, at the offending tokens.

#[test]
fn wrong_programs() {
    trybuild::TestCases::new().compile_fail("tests/ui/*.rs");
}

/// What a user does not see: warnings.
#[test]
fn generated_code_is_clean() {
    trybuild::TestCases::new().pass("tests/clean/*.rs");
}
