//! The coordinates of a joint of the tree in the home pose of space, and their rates.

use super::guesses::Guesses;
use crate::model::defaults::{OF_ANGLES, Sampled};
use crate::model::geometry::{Attachment, Axes, Owner, Vector};
use crate::model::mobilizer::Freedom;
use crate::model::parts::Part;
use crate::model::resolver::Resolver;
use crate::model::tree::TreeJoint;
use crate::symbolic::{Expr, Graph};

/// The frame of a joint on one of its partners, in the ground's axes.
struct Side {
    origin: Vector,
    axes: Axes,
    /// The velocity of its origin.
    velocity: Vector,
    /// Its angular velocity, where that was declared.
    declared_spin: Option<Vector>,
    spin: Vector,
}

impl Side {
    fn new(
        resolver: &mut Resolver,
        parts: &[Part],
        speeds: &[Vector],
        attachment: &Attachment,
    ) -> Side {
        let zero = resolver.graph.zero_vector();
        let owner = attachment.point.owner;
        let home = resolver.home(owner);
        let (speed, declared_spin) = match owner {
            Owner::Ground => (zero, None),
            Owner::Part(part) => (speeds[part], parts[part].guess.spin),
        };
        let spin = declared_spin.unwrap_or(zero);
        let graph = &mut resolver.graph;
        let arm = graph.turn(&home.axes, attachment.point.local);
        let swing = graph.cross(spin, arm);
        Side {
            origin: graph.vector_add(home.origin, arm),
            axes: graph.compose(&home.axes, &attachment.local),
            velocity: graph.vector_add(speed, swing),
            declared_spin,
            spin,
        }
    }
}

/// Guesses the coordinates of a joint of the tree; `length` is the largest one of the mechanism.
pub(super) fn joint_guess(
    resolver: &mut Resolver,
    parts: &[Part],
    speeds: &[Vector],
    joint: &TreeJoint,
    length: Sampled,
    guesses: &mut Guesses,
) {
    let [parent, child] = [&joint.mobilizer.parent, &joint.mobilizer.child]
        .map(|attachment| Side::new(resolver, parts, speeds, attachment));
    let sign = joint.mobilizer.sign();
    let mut set = |resolver: &mut Resolver, local, motion, rate| {
        let [value, rate] = [motion, rate].map(|x| resolver.graph.scale(sign, x));
        guesses.set(local, value, rate);
    };
    let mut turns = joint.freedoms().filter(|(freedom, _)| freedom.turns());
    match (turns.next(), turns.next()) {
        (Some((_, first)), Some((Freedom::Turn(Some(between)), second))) => {
            let graph = &mut resolver.graph;
            let relative = graph.vector_sub(child.spin, parent.spin);
            let rates = [
                graph.dot(parent.axes[2], relative),
                graph.dot(child.axes[2], relative),
            ];
            let angles = two_angles(graph, &parent.axes, between, &child.axes);
            for ((local, angle), rate) in [first, second].into_iter().zip(angles).zip(rates) {
                let angle = resolver.settled(angle, OF_ANGLES);
                set(resolver, local, angle, rate);
            }
        }
        (Some((freedom, local)), _) => {
            let graph = &mut resolver.graph;
            let (sin, cos) = (
                graph.dot(parent.axes[1], child.axes[0]),
                graph.dot(parent.axes[0], child.axes[0]),
            );
            let angle = graph.atan2(sin, cos);
            let relative = graph.vector_sub(child.spin, parent.spin);
            let rate = graph.dot(parent.axes[2], relative);
            let angle = resolver.settled(angle, OF_ANGLES);
            let rate = match freedom {
                Freedom::Helix(lead) => helix_rate(resolver, *lead, rate, &parent, &child),
                _ => rate,
            };
            set(resolver, local, angle, rate);
        }
        (None, _) => {}
    }
    for (freedom, local) in joint.freedoms() {
        let Freedom::Slide(axis) = *freedom else {
            continue;
        };
        let graph = &mut resolver.graph;
        let gap = graph.vector_sub(child.origin, parent.origin);
        let stroke = graph.dot(parent.axes[axis], gap);
        let speed = speed_along(graph, axis, gap, &parent, &child);
        let stroke = resolver.settled(stroke, length);
        set(resolver, local, stroke, speed);
    }
}

/// How fast the child slides along an axis, which turns with the parent.
fn speed_along(graph: &mut Graph, axis: usize, gap: Vector, parent: &Side, child: &Side) -> Expr {
    let swing = graph.cross(parent.spin, gap);
    let relative = graph.vector_sub(child.velocity, parent.velocity);
    let relative = graph.vector_sub(relative, swing);
    graph.dot(parent.axes[axis], relative)
}

/// Whether a helix turns as fast as the child slides, because no angular velocity was declared.
pub(super) fn turns_as_it_slides(resolver: &Resolver, joint: &TreeJoint) -> bool {
    let mut freedoms = joint.mobilizer.freedoms.iter();
    let partners = [joint.parent, Some(joint.child)];
    let mut spins = partners.into_iter().flatten();
    let is_helix = |freedom: &Freedom| match freedom {
        Freedom::Helix(lead) => resolver.by_default(*lead) != 0.0,
        _ => false,
    };
    freedoms.any(is_helix) && spins.all(|part| resolver.parts[part].guess.spin.is_none())
}

/// The rate of a helix: that of the declared angular velocities; without any, as fast as the child slides.
fn helix_rate(
    resolver: &mut Resolver,
    lead: Expr,
    rate: Expr,
    parent: &Side,
    child: &Side,
) -> Expr {
    let declared = [parent, child]
        .iter()
        .any(|side| side.declared_spin.is_some());
    if declared || resolver.by_default(lead) == 0.0 {
        return rate;
    }
    let graph = &mut resolver.graph;
    let gap = graph.vector_sub(child.origin, parent.origin);
    let speed = speed_along(graph, 2, gap, parent, child);
    graph.div(speed, lead)
}

/// The angles of two turns one after the other: about the third axis of `parent`, then about the third of `between`, which is
/// given in the axes that the first has turned, and is that of `child`.
fn two_angles(graph: &mut Graph, parent: &Axes, between: &Axes, child: &Axes) -> [Expr; 2] {
    let pin = child[2];
    let start = graph.turn(parent, between[2]);
    let across = graph.cross(parent[2], start);
    let (sin, cos) = (graph.dot(across, pin), graph.dot(start, pin));
    let middle = [between[0], between[1]].map(|[x, y, z]| {
        let turned = [
            [(cos, x, 1.0), (sin, y, -1.0)],
            [(sin, x, 1.0), (cos, y, 1.0)],
        ];
        let [x, y] = turned.map(|terms| {
            let terms = terms.map(|(a, b, sign)| (graph.mul(a, b), sign));
            graph.linear(0.0, &terms)
        });
        graph.turn(parent, [x, y, z])
    });
    let first = graph.atan2(sin, cos);
    let [along, square] = middle.map(|axis| graph.dot(axis, child[0]));
    [first, graph.atan2(square, along)]
}
