//! The README's table of scenes.

use super::data::Data;
use super::markdown::{error, significant, table as markdown};
use super::scene_runs::{FILE, SCENES};

pub fn table(data: &Data) -> Result<String, String> {
    const HEADING: [&str; 9] = [
        "scene",
        "velocities + rows",
        "step, s",
        "run, s",
        "energy error, J",
        "position error",
        "position rows",
        "velocity rows",
        "time a step",
    ];
    let results = data.table(FILE)?;
    let mut rows = Vec::new();
    for (name, what) in SCENES {
        let line = results.find(&[("scene", name)])?;
        let number = |column| line.number(column);
        let (count, rank) = (number("rows")?, number("rank")?);
        let short = match rank < count {
            true => format!(", rank {rank}"),
            false => String::new(),
        };
        let energy = error(number("energy_error_J")?);
        let energy = match name {
            // The drive does positive and negative work of this size.
            "driven-slider-crank" => {
                format!("{energy} (of {:.0} J)", number("kinetic_energy_J")?)
            }
            _ => energy,
        };
        let position = match line.text("position_error")? {
            "" => "–".to_owned(),
            _ => error(number("position_error")?),
        };
        let row = |column| match count {
            0.0 => Ok("–".to_owned()),
            _ => number(column).map(error),
        };
        rows.push(vec![
            format!("`{name}`{what}"),
            format!("{} + {count}{short}", number("velocities")?),
            line.text("step_s")?.to_owned(),
            number("duration_s")?.to_string(),
            energy,
            position,
            row("holonomic_error")?,
            row("velocity_error")?,
            format!("{} µs", significant(number("time_us")?, 2)),
        ]);
    }
    Ok(format!(
        "{}\n\nMeasured at {}; [all digits](book/src/results/{FILE}).",
        markdown(&HEADING, &rows),
        results.source()
    ))
}
