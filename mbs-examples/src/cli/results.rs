//! The files of a run.

use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};

use mbs_examples::plot;
use mbs_examples::scene::Scene;
use mbs_runtime::output::Frame;
use mbs_runtime::output::csv::CsvWriter;
use mbs_runtime::output::motion::write_motion;

use super::failure::Failure;
use super::simulate::Run;

/// Names of the files, in the order in which they are listed.
pub const FILES: [&str; 4] = [
    "trajectory.csv",
    "energy.svg",
    "constraints.svg",
    "motion.html",
];

/// Bytes of whole rows that are kept before they are written.
const ROOM: usize = 1 << 12;

/// The directory of a run in progress.
///
/// The trajectory holds whole rows at any instant, even if the run is killed or the disk is full. Pictures appear when
/// they are complete. A run that finds its trajectory replaced by that of another run ends with an error.
pub struct Results {
    directory: PathBuf,
    file: File,
    /// Rows that are not written yet.
    rows: CsvWriter<Vec<u8>>,
    /// Bytes of whole rows in the file.
    written: u64,
}

impl Results {
    /// Makes the directory and begins the trajectory.
    pub fn create(directory: &Path, scene: &Scene) -> Result<Self, Failure> {
        fs::create_dir_all(directory).map_err(|e| Failure::writing(directory, e))?;
        // Files of an earlier run are removed: if this run is interrupted, they must not look like its results. A run
        // that still writes keeps its own trajectory, without a name.
        for name in &FILES {
            let _ = fs::remove_file(directory.join(name));
        }
        let path = directory.join(FILES[0]);
        let file = File::create(&path).map_err(|e| Failure::writing(&path, e))?;
        let rows =
            CsvWriter::new(Vec::new(), scene.model).map_err(|e| Failure::writing(&path, e))?;
        let mut results = Results {
            directory: directory.to_owned(),
            file,
            rows,
            written: 0,
        };
        results.write()?;
        Ok(results)
    }

    /// Writes one instant.
    pub fn record(&mut self, frame: &Frame) -> Result<(), Failure> {
        let path = || self.directory.join(FILES[0]);
        let kept = self.rows.write(frame);
        kept.map_err(|e| Failure::writing(&path(), e))?;
        match self.rows.get_ref().len() < ROOM {
            true => Ok(()),
            false => self.write(),
        }
    }

    /// Writes the rows; what a failure leaves of a row is cut off.
    fn write(&mut self) -> Result<(), Failure> {
        let rows = self.rows.get_mut();
        if let Err(error) = self.file.write_all(rows) {
            let _ = self.file.set_len(self.written);
            return Err(Failure::writing(&self.directory.join(FILES[0]), error));
        }
        self.written += rows.len() as u64;
        rows.clear();
        Ok(())
    }

    /// Ends the trajectory and writes the pictures.
    pub fn finish(mut self, run: &Run) -> Result<(), Failure> {
        let [trajectory, energy, constraints, motion] = FILES;
        let stopped = run.stopped.as_ref().map(ToString::to_string);
        if let Some(reason) = &stopped {
            let marked = self.rows.stopped(run.simulation.time(), reason);
            marked.map_err(|e| Failure::writing(&self.directory.join(trajectory), e))?;
        }
        self.write()?;
        let found = fs::metadata(self.directory.join(trajectory)).map(|file| file.len());
        if found.ok() != Some(self.written) {
            return Err(Failure(format!(
                "{} now holds the trajectory of another run, and that of this one is lost; give each run a directory with --out",
                self.directory.display()
            )));
        }

        let title = match stopped {
            Some(_) => format!("{} (stopped early)", run.scene.title),
            None => run.scene.title.to_owned(),
        };
        self.place(energy, plot::energy(&title, &run.frames)?.as_bytes())?;
        let picture = plot::constraints(&title, &run.frames)?;
        self.place(constraints, picture.as_bytes())?;
        let (model, mut page) = (run.scene.model, Vec::new());
        let title = run.scene.title;
        write_motion(&mut page, model, &run.frames, title, stopped.as_deref())
            .map_err(|e| Failure::writing(&self.directory.join(motion), e))?;
        self.place(motion, &page)
    }

    /// Writes a file that has its name only when it is complete.
    fn place(&self, name: &str, content: &[u8]) -> Result<(), Failure> {
        let path = self.directory.join(name);
        let unfinished = self
            .directory
            .join(format!(".{name}.{}", std::process::id()));
        let placed = fs::write(&unfinished, content).and_then(|()| fs::rename(&unfinished, &path));
        placed.map_err(|error| {
            let _ = fs::remove_file(&unfinished);
            Failure::writing(&path, error)
        })
    }
}
