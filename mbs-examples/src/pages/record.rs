//! The option `--csv DIR` of programs that measure: the folder for their results.

use std::fs;
use std::path::{Path, PathBuf};

use crate::laboratory::provenance::provenance;
use crate::laboratory::store::{Row, Store};

/// The arguments of such a program.
pub struct Recorder {
    command: &'static str,
    directory: Option<PathBuf>,
    /// The other arguments.
    pub arguments: Vec<String>,
}

impl Recorder {
    /// The arguments of this process; `command` is the command line for the first line of the files.
    pub fn new(command: &'static str) -> Self {
        let mut recorder = Recorder {
            command,
            directory: None,
            arguments: Vec::new(),
        };
        let mut arguments = std::env::args().skip(1);
        while let Some(argument) = arguments.next() {
            match argument.as_str() {
                "--csv" => recorder.directory = arguments.next().map(PathBuf::from),
                // Cargo passes this to every benchmark.
                "--bench" => {}
                _ => recorder.arguments.push(argument),
            }
        }
        recorder
    }

    /// A file of the directory. Its rows are kept if machine and commit are the same.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn file(&self, name: &str, columns: &[&str], keys: usize) -> Result<File, String> {
        let store = match &self.directory {
            None => None,
            Some(directory) => Some(self.open(directory, name, columns, keys)?),
        };
        Ok(File { store })
    }

    fn open(
        &self,
        directory: &Path,
        name: &str,
        columns: &[&str],
        keys: usize,
    ) -> Result<Store, String> {
        let path = directory.join(name);
        let note = format!("{}; {}", provenance(), self.command);
        fs::create_dir_all(directory)
            .and_then(|()| Store::open(&path, &note, columns, keys))
            .map_err(|error| format!("{}: {error}", path.display()))
    }
}

/// A file of results, or none.
pub struct File {
    store: Option<Store>,
}

impl File {
    /// Keeps a row.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn put(&mut self, row: Row) -> Result<(), String> {
        let Some(store) = &mut self.store else {
            return Ok(());
        };
        let written = store.put(row).and_then(|()| store.compact());
        written.map_err(|error| error.to_string())
    }
}
