//! The option `--csv DIR` of programs that measure: the folder for their results.

use std::fmt::Display;
use std::fs;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use crate::laboratory::provenance::provenance;
use crate::laboratory::store::{Row, Store};

/// The arguments of such a program.
pub struct Recorder {
    command: &'static str,
    directory: Option<PathBuf>,
    /// The numbers among the arguments, or what stands for those that were left out: files of other numbers are others.
    numbers: String,
    /// The other arguments.
    pub arguments: Vec<String>,
}

impl Recorder {
    /// The arguments of this process; `command` is the command line for the first line of the files.
    ///
    /// # Errors
    /// `--csv` without a folder.
    pub fn new(command: &'static str) -> Result<Self, String> {
        let mut recorder = Recorder {
            command,
            directory: None,
            numbers: String::new(),
            arguments: Vec::new(),
        };
        let mut arguments = std::env::args().skip(1);
        while let Some(argument) = arguments.next() {
            match argument.as_str() {
                "--csv" => {
                    let folder = arguments.next();
                    let folder = folder.ok_or("`--csv` takes the folder for the results")?;
                    recorder.directory = Some(folder.into());
                }
                // Cargo passes this to every benchmark.
                "--bench" => {}
                _ => recorder.arguments.push(argument),
            }
        }
        Ok(recorder)
    }

    /// The number at this place of the arguments, or the usual one; to be called before [`Recorder::file`], whose first line
    /// has it.
    ///
    /// # Errors
    /// An argument that is no such number.
    pub fn number<T: FromStr + Display>(&mut self, place: usize, usual: T) -> Result<T, String> {
        let number = self.parsed(place, usual)?;
        self.numbers.push_str(&format!(" {number}"));
        Ok(number)
    }

    /// The same of a number that the rows have in a column of their own.
    ///
    /// # Errors
    /// An argument that is no such number.
    pub fn parsed<T: FromStr>(&self, place: usize, usual: T) -> Result<T, String> {
        match self.arguments.get(place) {
            None => Ok(usual),
            Some(text) => text
                .parse()
                .map_err(|_| format!("`{text}` is no number here")),
        }
    }

    /// Refuses arguments that are none of these names.
    ///
    /// # Errors
    /// An unknown name.
    pub fn check_names<'a>(&self, known: impl IntoIterator<Item = &'a str>) -> Result<(), String> {
        let known: Vec<&str> = known.into_iter().collect();
        let mut names = self.arguments.iter();
        match names.find(|name| !known.contains(&name.as_str())) {
            None => Ok(()),
            Some(name) if known.is_empty() => Err(format!("`{name}`: this takes no names")),
            Some(name) => Err(format!(
                "there is no `{name}` here (there are: {})",
                known.join(", ")
            )),
        }
    }

    /// A file of the directory. Its rows are kept if machine, commit and numbers are the same.
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
        let numbers = match self.numbers.as_str() {
            "" => String::new(),
            numbers => format!(" --{numbers}"),
        };
        let note = format!("{}; {}{numbers}", provenance(), self.command);
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
