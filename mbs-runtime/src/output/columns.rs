//! The columns of a trajectory: time, outputs, coordinates, velocities, energies, errors of the rows.

use super::Frame;
use crate::Model;

/// The names of the columns.
pub(super) fn names(model: &Model) -> Vec<String> {
    let outputs = model.outputs.iter().map(|q| column(q.name, q.unit));
    let coordinates = model.coordinates.iter().map(|q| column(q.name, q.unit));
    let velocities = model
        .velocities
        .iter()
        .map(|v| column(&v.name.replace('\'', "_dot"), v.unit));
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

/// Their values at an instant.
pub(super) fn values(frame: &Frame) -> impl Iterator<Item = f64> + '_ {
    let energy = &frame.energy;
    let fixed = [
        energy.kinetic,
        energy.potential,
        energy.error,
        frame.holonomic_error,
        frame.velocity_error,
    ];
    std::iter::once(frame.time)
        .chain(frame.outputs.iter().copied())
        .chain(frame.coordinates.iter().copied())
        .chain(frame.velocities.iter().copied())
        .chain(fixed)
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
