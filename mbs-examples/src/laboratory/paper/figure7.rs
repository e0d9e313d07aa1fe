//! Bricard's mechanism.

use super::column::Column;
use super::figure6::{components, runs};
use super::run::{BRICARD, Extent, METHODS};
use super::{Figure, Panel, Scale};

pub fn figure(extent: Extent) -> Figure {
    let place = [
        (Column::Output("corner3.x"), "x"),
        (Column::Output("corner3.y"), "y"),
        (Column::Output("corner3.z"), "z"),
    ];
    let first = [0.0, extent.time(10.0)];
    let energy = |title, window, scale| {
        let axis = "|energy error|, J";
        Panel::of_runs(title, axis, Column::EnergyError, &METHODS, window, scale)
    };
    Figure {
        number: 7,
        title: "Bricard's mechanism, 36 velocities and 36 rows",
        caption: &[
            "Steps of 1e-3 s, accuracy 0.01; BDF chooses its steps.",
            "Released from rest; joints 1 and 6 are on the ground.",
        ],
        subject: &BRICARD,
        columns: [vec![Column::EnergyError], place.map(|p| p.0).to_vec()].concat(),
        runs: runs(extent, 100.0),
        ensemble: &[],
        panels: vec![
            components("position of the third corner", "m", &place, first),
            energy(
                "error of the mechanical energy",
                first,
                Scale::Decades(-12, 2),
            ),
            energy(
                "the same, longer",
                [0.0, extent.time(100.0)],
                Scale::Decades(-12, 2),
            ),
        ],
    }
}
