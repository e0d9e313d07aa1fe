//! The message of a command that failed.

use std::io;
use std::path::Path;

use mbs_runtime::SimulationError;

/// What happened and what to do.
#[derive(Debug)]
pub struct Failure(pub String);

impl Failure {
    /// A file or directory that cannot be written.
    pub fn writing(path: &Path, error: io::Error) -> Self {
        let path = path.display();
        Failure(format!(
            "cannot write {path}: {error}; choose another directory with --out"
        ))
    }
}

impl From<String> for Failure {
    fn from(message: String) -> Self {
        Failure(message)
    }
}

impl From<SimulationError> for Failure {
    fn from(error: SimulationError) -> Self {
        Failure(error.to_string())
    }
}
