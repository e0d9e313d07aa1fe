//! A point that slides on something fixed in another part.

use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::{Condition, Joint, ReactionComponent};
use crate::model::geometry::{Point, Vector};
use crate::symbolic::Graph;

/// λ · axes: the force on the first of two points, one condition for each axis, which is fixed in the part of the other.
pub(super) fn held_across(
    graph: &mut Graph,
    point: Point,
    other: Point,
    axes: &[(&str, Vector)],
) -> Joint {
    let gap = graph.vector_sub(point.position, other.position);
    let conditions = axes
        .iter()
        .map(|(suffix, axis)| Condition::position(suffix, graph.dot(*axis, gap), Dimension::LENGTH))
        .collect();
    let reactions = ["fx", "fy", "fz"]
        .into_iter()
        .enumerate()
        .map(|(k, name)| ReactionComponent {
            name,
            dimension: Dimension::FORCE,
            terms: axes
                .iter()
                .enumerate()
                .map(|(condition, (_, axis))| (condition, axis[k]))
                .filter(|&(_, x)| !graph.is_zero(x))
                .collect(),
        })
        .collect();
    Joint {
        conditions,
        reactions,
        points: vec![other, point],
        ..Joint::default()
    }
}

/// Two different parts, the second of which has axes.
pub(super) fn points(arguments: &mut Arguments, surface: &str) -> Option<(Point, Point)> {
    let (point, other) = (arguments.point("point"), arguments.point(surface));
    let (point, other) = (point?, other?);
    let owner = arguments.owner_name(other.owner);
    if point.owner == other.owner {
        return arguments.fail(
            surface,
            format!("the point and the {surface} both belong to `{owner}`"),
        );
    }
    if arguments.is_particle(other.owner) || arguments.is_slender(other.owner) {
        return arguments.fail(
            surface,
            format!("`{owner}` has no orientation that could hold a {surface}; use a `Body`, or a `Bar` with `radius =`"),
        );
    }
    Some((point, other))
}
