//! What assembly has moved.

use crate::Coordinate;
use crate::report::Change;

/// Changes below this, in lengths of the mechanism and radians (per second), are round-off.
const LEAST: f64 = 1e-9;

/// The coordinates or velocities that assembly has changed, the largest change first.
pub(super) fn changes(
    named: &'static [Coordinate],
    declared: &[f64],
    started: &[f64],
    length: f64,
) -> Vec<Change> {
    let size = |change: &Change| {
        let way = (change.started - change.declared).abs();
        match change.unit {
            "m" | "m/s" => way / length,
            _ => way,
        }
    };
    let values = declared.iter().zip(started);
    let changes = named.iter().zip(values);
    let changes = changes.map(|(own, (&declared, &started))| Change {
        name: own.name,
        unit: own.unit,
        declared,
        started,
    });
    let mut changes: Vec<Change> = changes.filter(|change| size(change) > LEAST).collect();
    changes.sort_by(|a, b| size(b).total_cmp(&size(a)));
    changes
}
