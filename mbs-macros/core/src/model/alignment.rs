//! Axes of a joint turned about the joint's axis, so that what the child carries has fewer components.
//!
//! As with the parameters of Denavit and Hartenberg, x points along the next axis, to the next joint, or to the centre of
//! mass. This costs nothing: a turn by θ and one by a constant about the same axis are one turn by their sum.

use super::geometry::{Axes, Vector};
use super::mobilizer::Freedom;
use super::parts::Part;
use super::tree::{Tree, TreeJoint};
use crate::symbolic::{Expr, Graph};

/// Shorter components, relative to the whole, are round-off.
const NONE: f64 = 1e-12;

/// The constant angle by which the axes of a joint turn about z so that x points along a direction of the child, and the
/// turned axes; `inner` are those of the joint in the child. `None` where an axis points there already.
pub(super) fn aligned(
    graph: &mut Graph,
    tree: &Tree,
    joint: &TreeJoint,
    part: &Part,
    inner: &Axes,
) -> Option<(Expr, Axes)> {
    let [x, y] = [inner[0], inner[1]];
    let axes = (graph.numbers(x)?, graph.numbers(y)?);
    let mut directions = directions(graph, tree, joint, part).into_iter();
    let (along, across) = directions.find_map(|direction| {
        let direction = graph.numbers(direction)?;
        let (along, across) = (dot(axes.0, direction), dot(axes.1, direction));
        let is_across = along.hypot(across) > NONE * dot(direction, direction).sqrt();
        is_across.then_some((along, across))
    })?;
    let radius = along.hypot(across);
    if along.abs().min(across.abs()) <= NONE * radius {
        return None;
    }
    let (cos, sin) = (along / radius, across / radius);
    let mut mixed = |a: f64, b: f64| -> Vector {
        let mixed = std::array::from_fn(|k| graph.linear(0.0, &[(x[k], a), (y[k], b)]));
        graph.snapped(mixed)
    };
    let turned = [mixed(cos, sin), mixed(-sin, cos), inner[2]];
    Some((graph.constant(across.atan2(along)), turned))
}

/// Directions of the child, in its own axes: of the joints that it carries, to their places, and to its centre of mass.
fn directions(graph: &mut Graph, tree: &Tree, joint: &TreeJoint, part: &Part) -> Vec<Vector> {
    let place = joint.mobilizer.child.point.local;
    let carried = |other: &&TreeJoint| other.parent == Some(joint.child);
    let mut list = Vec::new();
    for other in tree.joints.iter().filter(carried) {
        let frame = &other.mobilizer.parent;
        let axis = match other.mobilizer.freedoms.first() {
            Some(Freedom::Slide(axis)) => Some(frame.local[*axis]),
            Some(Freedom::Turn(_) | Freedom::Helix(_)) => Some(frame.local[2]),
            Some(Freedom::Rotation) | None => None,
        };
        list.extend(axis);
        list.push(graph.vector_sub(frame.point.local, place));
    }
    list.push(graph.vector_sub(part.center, place));
    list
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
