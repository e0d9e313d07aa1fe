//! The columns of a trajectory: time, outputs, coordinates, velocities, energies, errors of the rows.

use std::io;

use super::Frame;
use super::frame_check::Lengths;
use crate::Model;

/// Which coordinates and velocities are columns: states are among the outputs.
#[derive(Debug)]
pub(super) struct Columns {
    /// The names of all columns.
    pub(super) names: Vec<String>,
    coordinates: Vec<usize>,
    velocities: Vec<usize>,
    lengths: Lengths,
}

impl Columns {
    pub(super) fn of(model: &Model) -> Columns {
        let coordinates = model.coordinates.iter().enumerate();
        let velocities = model.velocities.iter().enumerate();
        let coordinates = coordinates.filter(|(_, q)| !model.is_integral(q.name));
        let velocities = velocities.filter(|(_, v)| !model.is_state(v.name));
        let mut columns = Columns {
            names: Vec::new(),
            coordinates: coordinates.map(|(i, _)| i).collect(),
            velocities: velocities.map(|(i, _)| i).collect(),
            lengths: Lengths::of(model),
        };
        columns.names = columns.named(model);
        columns
    }

    fn named(&self, model: &Model) -> Vec<String> {
        let outputs = model.outputs.iter().map(|q| column(q.name, q.unit));
        let coordinates = self.coordinates.iter().map(|&i| &model.coordinates[i]);
        let coordinates = coordinates.map(|q| column(q.name, q.unit));
        let velocities = self.velocities.iter().map(|&i| &model.velocities[i]);
        let velocities = velocities.map(|v| column(&v.name.replace('\'', "_dot"), v.unit));
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

    /// Their values at an instant; an error where the frame, of this number, does not belong to the model.
    pub(super) fn values<'a>(
        &'a self,
        number: usize,
        frame: &'a Frame,
    ) -> io::Result<impl Iterator<Item = f64> + 'a> {
        self.lengths.check(number, frame)?;
        let energy = &frame.energy;
        let fixed = [
            energy.kinetic,
            energy.potential,
            energy.error,
            frame.holonomic_error,
            frame.velocity_error,
        ];
        let coordinates = self.coordinates.iter();
        let velocities = self.velocities.iter();
        Ok(std::iter::once(frame.time)
            .chain(frame.outputs.iter().copied())
            .chain(coordinates.map(|&i| frame.coordinates[i]))
            .chain(velocities.map(|&i| frame.velocities[i]))
            .chain(fixed))
    }
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
