//! The files of a run.

use std::fs::{self, File};
use std::io::{BufWriter, Write};
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

/// The directory of a run in progress.
pub struct Results {
    directory: PathBuf,
    trajectory: CsvWriter<BufWriter<File>>,
}

impl Results {
    /// Makes the directory and begins the trajectory.
    pub fn create(directory: &Path, scene: &Scene) -> Result<Self, Failure> {
        fs::create_dir_all(directory).map_err(|e| Failure::writing(directory, e))?;
        // Files of an earlier run are removed: if this run is interrupted, they must not look like its results.
        for name in &FILES[1..] {
            let _ = fs::remove_file(directory.join(name));
        }
        let path = directory.join(FILES[0]);
        let trajectory = File::create(&path)
            .and_then(|file| CsvWriter::new(BufWriter::new(file), scene.model))
            .map_err(|e| Failure::writing(&path, e))?;
        Ok(Results {
            directory: directory.to_owned(),
            trajectory,
        })
    }

    /// Writes one instant.
    pub fn record(&mut self, frame: &Frame) -> Result<(), Failure> {
        let written = self.trajectory.write(frame);
        written.map_err(|e| Failure::writing(&self.directory.join(FILES[0]), e))
    }

    /// Ends the trajectory and writes the pictures.
    pub fn finish(mut self, run: &Run) -> Result<(), Failure> {
        let [trajectory, energy, constraints, motion] = FILES.map(|name| self.directory.join(name));
        let stopped = run.stopped.as_ref().map(ToString::to_string);
        let marked = match &stopped {
            Some(reason) => self.trajectory.stopped(run.simulation.time(), reason),
            None => Ok(()),
        };
        marked
            .and_then(|()| self.trajectory.finish())
            .map_err(|e| Failure::writing(&trajectory, e))?;

        let title = match stopped {
            Some(_) => format!("{} (stopped early)", run.scene.title),
            None => run.scene.title.to_owned(),
        };
        let picture = plot::energy(&title, &run.frames)?;
        fs::write(&energy, picture).map_err(|e| Failure::writing(&energy, e))?;
        let picture = plot::constraints(&title, &run.frames)?;
        fs::write(&constraints, picture).map_err(|e| Failure::writing(&constraints, e))?;
        File::create(&motion)
            .map(BufWriter::new)
            .and_then(|mut out| {
                let model = run.scene.model;
                write_motion(
                    &mut out,
                    model,
                    &run.frames,
                    run.scene.title,
                    stopped.as_deref(),
                )?;
                out.flush()
            })
            .map_err(|e| Failure::writing(&motion, e))
    }
}
