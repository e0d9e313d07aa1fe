//! The array of the values of a long function.

/// Longer arrays are not on the stack: with 8 bytes for each value this is a sixteenth of the stack of a thread.
const LONGEST_ON_STACK: usize = 16 * 1024;

/// The statement that begins with an array of this length: `values` is a reference to it.
pub(super) fn declaration(length: usize) -> String {
    match length <= LONGEST_ON_STACK {
        true => format!("let values = &mut [0.0; {length}];\n"),
        false => {
            format!("let values = &mut *::mbs_runtime::generated::Values::<{length}>::take();\n")
        }
    }
}
