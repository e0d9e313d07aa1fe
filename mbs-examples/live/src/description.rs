//! The data of a mechanism for the page, as lines of fields with tabs between them.
//!
//! | line | fields |
//! |---|---|
//! | `scene` | name, title, `plane` or `space`, the vector against gravity |
//! | `size` | coordinates, velocities, rows |
//! | `steps` | least, usual, largest, s |
//! | `parameter` | name, unit, default, least and largest value of its slider, what it is |
//! | `point` | name |
//! | `segment` | part, index of the point it begins at, index of the point it ends at |
//! | `joint` | index of a point that a joint holds |
//! | `method` | what the page calls it; in the order of [`METHODS`] |

use crate::{METHODS, Mechanism, STEPS};
use mbs_runtime::World;
use std::fmt::Write;

/// The lines.
pub fn describe(mechanism: &Mechanism) -> String {
    let Mechanism {
        scene,
        step,
        ranges,
        angles,
    } = mechanism;
    let model = scene.model;
    let mut out = String::new();
    let mut line = |fields: &[&dyn std::fmt::Display]| {
        for (i, field) in fields.iter().enumerate() {
            // Writing to a string cannot fail.
            let _ = write!(out, "{}{field}", if i > 0 { "\t" } else { "" });
        }
        out.push('\n');
    };
    let world = match model.world {
        World::Planar => "plane",
        World::Spatial => "space",
    };
    let [x, y, z] = model.up;
    line(&[&"scene", &scene.name, &scene.title, &world, &x, &y, &z]);
    let [q, v, rows] = [
        model.coordinates.len(),
        model.velocities.len(),
        model.rows.len(),
    ];
    line(&[&"size", &q, &v, &rows]);
    line(&[&"steps", &STEPS[0], step, &STEPS[1]]);
    for (p, [least, most]) in model.parameters.iter().zip(*ranges) {
        let unit = if angles.contains(&p.name) {
            "rad"
        } else {
            p.unit
        };
        line(&[
            &"parameter",
            &p.name,
            &unit,
            &p.default,
            least,
            most,
            &p.doc,
        ]);
    }
    for point in model.points {
        line(&[&"point", point]);
    }
    for segment in model.segments {
        line(&[&"segment", &segment.part, &segment.from, &segment.to]);
    }
    let mut joints: Vec<usize> = model.reactions.iter().filter_map(|r| r.at).collect();
    joints.dedup();
    for joint in joints {
        line(&[&"joint", &joint]);
    }
    for (_, title) in METHODS {
        line(&[&"method", &title]);
    }
    out
}
