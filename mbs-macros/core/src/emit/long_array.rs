//! The array of the values of a long function.

/// Longer arrays are not on the stack: with 8 bytes for each value this is a sixteenth of the stack of a thread.
const LONGEST_ON_STACK: usize = 16 * 1024;

/// The statement that begins with an array of this length, as `values`.
pub(super) fn declaration(length: usize) -> String {
    match length <= LONGEST_ON_STACK {
        true => format!("let mut values = [0.0; {length}];\n"),
        false => format!(
            "let mut values = ::mbs_runtime::generated::Values::<{length}>::take();\nlet values = &mut *values;\n"
        ),
    }
}

/// The array as a reference that is written through.
pub(super) fn borrowed(length: usize) -> &'static str {
    match length <= LONGEST_ON_STACK {
        true => "&mut values",
        false => "values",
    }
}
