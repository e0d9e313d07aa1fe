//! A trajectory as a table: one row per frame, units in the header (`crank.b.x_dot_m_per_s`).

use std::fmt::Write as _;
use std::io::{self, Write};

use super::Frame;
use crate::{Coordinate, Model};

/// Writes frames as they come, so that a run that stops leaves all rows up to there.
#[derive(Debug)]
pub struct CsvWriter<W: Write> {
    out: W,
    /// The coordinates and velocities in columns.
    columns: [Vec<usize>; 2],
}

impl<W: Write> CsvWriter<W> {
    /// Writes the header.
    ///
    /// # Errors
    /// `out` cannot be written.
    pub fn new(mut out: W, model: &Model) -> io::Result<Self> {
        out.write_all((header(model).join(",") + "\n").as_bytes())?;
        let columns = [
            coordinates(model).map(|(i, _)| i).collect(),
            velocities(model).map(|(i, _)| i).collect(),
        ];
        Ok(CsvWriter { out, columns })
    }

    /// Writes one row, at once: behind a buffer, too, an interrupted run leaves whole rows. Every number reads back to the same bits.
    ///
    /// # Errors
    /// `out` cannot be written.
    pub fn write(&mut self, frame: &Frame) -> io::Result<()> {
        let mut row = format!("{:?}", frame.time);
        let energy = &frame.energy;
        let balance = [energy.kinetic, energy.potential, energy.error];
        let errors = [frame.holonomic_error, frame.velocity_error];
        let [q, v] = &self.columns;
        let columns = frame
            .outputs
            .iter()
            .chain(q.iter().filter_map(|&i| frame.coordinates.get(i)))
            .chain(v.iter().filter_map(|&i| frame.velocities.get(i)))
            .chain(&balance)
            .chain(&errors);
        for value in columns {
            // Writing to a string cannot fail.
            let _ = write!(row, ",{value:?}");
        }
        row.push('\n');
        self.out.write_all(row.as_bytes())
    }

    /// Marks the table of a run that did not reach its end, with a last line `# stopped at t = …`.
    ///
    /// # Errors
    /// `out` cannot be written.
    pub fn stopped(&mut self, time: f64, reason: &str) -> io::Result<()> {
        // A comment is one line.
        let reason = reason.split_whitespace().collect::<Vec<_>>().join(" ");
        self.out
            .write_all(format!("# stopped at t = {time:?} s: {reason}\n").as_bytes())
    }

    /// The writer.
    pub fn get_ref(&self) -> &W {
        &self.out
    }

    /// The writer, to take out what it holds.
    pub fn get_mut(&mut self) -> &mut W {
        &mut self.out
    }

    /// Writes what is still buffered and returns the writer.
    ///
    /// # Errors
    /// `out` cannot be written.
    pub fn finish(mut self) -> io::Result<W> {
        self.out.flush()?;
        Ok(self.out)
    }
}

/// The coordinates in columns, with their indices. States are columns among the outputs.
fn coordinates(model: &Model) -> impl Iterator<Item = (usize, &'static Coordinate)> {
    let own = model.coordinates.iter().enumerate();
    own.filter(|(_, q)| !model.is_integral(q.name))
}

/// The velocities in columns.
fn velocities(model: &Model) -> impl Iterator<Item = (usize, &'static Coordinate)> {
    let own = model.velocities.iter().enumerate();
    own.filter(|(_, v)| !model.is_state(v.name))
}

/// The names of the columns.
fn header(model: &Model) -> Vec<String> {
    let outputs = model.outputs.iter().map(|q| column(q.name, q.unit));
    let coordinates = coordinates(model).map(|(_, q)| column(q.name, q.unit));
    let velocities = velocities(model).map(|(_, v)| column(&v.name.replace('\'', "_dot"), v.unit));
    let fixed = [
        "kinetic_J",
        "potential_J",
        "energy_error_J",
        "holonomic_error",
        "velocity_error",
    ];
    std::iter::once("time_s".to_owned())
        .chain(outputs)
        .chain(coordinates)
        .chain(velocities)
        .chain(fixed.map(str::to_owned))
        .collect()
}

/// `("x_dot", "m/s^2")` → `x_dot_m_per_s2`: a name that needs no quoting in any program that reads tables.
pub fn column(name: &str, unit: &str) -> String {
    let unit = unit
        .strip_prefix("1/")
        .map_or_else(|| unit.to_owned(), |rest| format!("per_{rest}"));
    let mut unit = unit.replace('/', "_per_").replace('²', "2");
    unit.retain(|c| c.is_alphanumeric() || c == '_');
    if unit.is_empty() {
        name.to_owned()
    } else {
        format!("{name}_{unit}")
    }
}

#[cfg(test)]
mod tests {
    use super::column;

    #[test]
    fn units_become_part_of_the_name() {
        assert_eq!(column("x", "m"), "x_m");
        assert_eq!(column("a", "m/s^2"), "a_m_per_s2");
        assert_eq!(column("s_dot", "1/s"), "s_dot_per_s");
        assert_eq!(column("torque", "N m"), "torque_Nm");
        assert_eq!(column("ratio", ""), "ratio");
    }
}
