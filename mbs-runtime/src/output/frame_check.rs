//! Whether frames belong to a model: they are public, and may come from a program or a file.

use std::io;

use super::Frame;
use crate::Model;

/// Refuses frames of which a list is not as long as that of the model, or the time is not finite.
pub(super) fn check_frames(model: &Model, frames: &[Frame]) -> io::Result<()> {
    check_times(frames)?;
    check_columns(model, frames)?;
    for (number, frame) in frames.iter().enumerate() {
        let (points, reactions) = (model.points.len(), model.reactions.len());
        check_length(number, "points", frame.points.len(), points)?;
        check_length(number, "reactions", frame.reactions.len(), reactions)?;
    }
    Ok(())
}

/// Refuses frames that have not a value in each column of the table.
pub(super) fn check_columns(model: &Model, frames: &[Frame]) -> io::Result<()> {
    let table = Lengths::of(model);
    let mut numbered = frames.iter().enumerate();
    numbered.try_for_each(|(number, frame)| table.check(number, frame))
}

/// Refuses frames of which the time is not finite.
pub(super) fn check_times(frames: &[Frame]) -> io::Result<()> {
    match frames.iter().position(|frame| !frame.time.is_finite()) {
        Some(number) => Err(invalid(format!(
            "frame {number} has the time {} s, which is not finite",
            frames[number].time
        ))),
        None => Ok(()),
    }
}

/// The lengths of the lists of a frame that a table has as columns.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lengths {
    coordinates: usize,
    velocities: usize,
    outputs: usize,
}

impl Lengths {
    pub(super) fn of(model: &Model) -> Self {
        Lengths {
            coordinates: model.coordinates.len(),
            velocities: model.velocities.len(),
            outputs: model.outputs.len(),
        }
    }

    /// Refuses a frame of which one of these lists has another length.
    pub(super) fn check(&self, number: usize, frame: &Frame) -> io::Result<()> {
        let coordinates = frame.coordinates.len();
        check_length(number, "coordinates", coordinates, self.coordinates)?;
        let velocities = frame.velocities.len();
        check_length(number, "velocities", velocities, self.velocities)?;
        check_length(number, "outputs", frame.outputs.len(), self.outputs)
    }
}

fn check_length(number: usize, list: &str, found: usize, wanted: usize) -> io::Result<()> {
    match found == wanted {
        true => Ok(()),
        false => Err(invalid(format!(
            "frame {number} has {found} {list}; the model has {wanted}"
        ))),
    }
}

fn invalid(text: String) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, text)
}
