//! What a wheel of the plane and a disk of space share where they roll: speeds at the contact.

use crate::model::arguments::Arguments;
use crate::model::geometry::{Owner, Point, Vector};

/// The velocity of the wheel against what it rolls on, at a place that both have, in the ground's axes.
pub(super) fn slip(arguments: &mut Arguments, wheel: &Point, track: &Point, at: Vector) -> Vector {
    let speeds = [wheel.owner, track.owner].map(|owner| velocity_at(arguments, owner, at));
    arguments.graph().vector_sub(speeds[0], speeds[1])
}

fn velocity_at(arguments: &mut Arguments, owner: Owner, at: Vector) -> Vector {
    let frame = arguments.frame(owner);
    let graph = arguments.graph();
    let arm = graph.vector_sub(at, frame.origin);
    let swing = graph.cross(frame.spin, arm);
    let velocity = graph.vector_rate(frame.origin);
    graph.vector_add(velocity, swing)
}

/// The wheel's centre and a point of what it rolls on: of two different parts with orientations.
pub(super) fn partners(arguments: &mut Arguments, fields: [&str; 2]) -> Option<[Point; 2]> {
    let points = fields.map(|field| arguments.point(field));
    let [Some(wheel), Some(track)] = points else {
        return None;
    };
    if wheel.owner == track.owner {
        let owner = arguments.owner_name(wheel.owner);
        return arguments.fail(
            fields[1],
            format!("both points belong to `{owner}`: a wheel rolls on another part"),
        );
    }
    for (field, owner) in fields.into_iter().zip([wheel.owner, track.owner]) {
        if arguments.is_particle(owner) || arguments.is_slender(owner) {
            let name = arguments.owner_name(owner);
            return arguments.fail(
                field,
                format!("`{name}` has no orientation, so that it cannot roll; use a `Body`"),
            );
        }
    }
    Some([wheel, track])
}
