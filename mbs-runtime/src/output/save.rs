//! The files of a recorded run.

use std::fs;
use std::io::{self, BufWriter};
use std::path::Path;

use super::Recording;
use super::csv::CsvWriter;
use super::motion::write_motion;

impl Recording {
    /// Writes the instants as a table.
    ///
    /// # Errors
    /// `out` cannot be written.
    pub fn write_csv(&self, out: impl io::Write) -> io::Result<()> {
        let mut table = CsvWriter::new(BufWriter::new(out), self.model)?;
        for frame in &self.frames {
            table.write(frame)?;
        }
        if let (Some(error), Some(last)) = (&self.stopped, self.frames.last()) {
            table.stopped(last.time, &error.to_string())?;
        }
        table.finish().map(|_| ())
    }

    /// Writes the animation, one file for any browser.
    ///
    /// # Errors
    /// `out` cannot be written.
    pub fn write_motion(&self, out: impl io::Write) -> io::Result<()> {
        let stopped = self.stopped.as_ref().map(ToString::to_string);
        let mut out = BufWriter::new(out);
        write_motion(
            &mut out,
            self.model,
            &self.frames,
            &self.title,
            stopped.as_deref(),
        )?;
        io::Write::flush(&mut out)
    }

    /// Writes `trajectory.csv` and `motion.html` into a folder, which is made if there is none; with the feature `plot`
    /// also `outputs.svg`, `energy.svg` and `constraints.svg`. Files of these names are replaced.
    ///
    /// # Errors
    /// A file that cannot be written, by its path.
    pub fn save(&self, folder: impl AsRef<Path>) -> io::Result<()> {
        let folder = folder.as_ref();
        fs::create_dir_all(folder).map_err(|error| about(folder, &error))?;
        let place = |name: &str, write: &dyn Fn(fs::File) -> io::Result<()>| {
            let path = folder.join(name);
            let written = fs::File::create(&path).and_then(write);
            written.map_err(|error| about(&path, &error))
        };
        place("trajectory.csv", &|file| self.write_csv(file))?;
        place("motion.html", &|file| self.write_motion(file))?;
        #[cfg(feature = "plot")]
        for (name, picture) in [
            ("outputs.svg", super::plot::outputs(self)),
            ("energy.svg", super::plot::energy(&self.title, &self.frames)),
            (
                "constraints.svg",
                super::plot::constraints(&self.title, &self.frames),
            ),
        ] {
            let picture = picture.map_err(io::Error::other)?;
            place(name, &|mut file| {
                io::Write::write_all(&mut file, picture.as_bytes())
            })?;
        }
        Ok(())
    }
}

fn about(path: &Path, error: &io::Error) -> io::Error {
    io::Error::new(error.kind(), format!("{}: {error}", path.display()))
}
