//! Standard output, which may be a closed pipe.

use std::io::{self, Write};

use super::failure::Failure;

/// Prints `text`; a closed pipe (`mbs list | head -1`) is not a failure.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(Failure(format!(
            "cannot write to the standard output: {error}"
        ))),
        _ => Ok(()),
    }
}
