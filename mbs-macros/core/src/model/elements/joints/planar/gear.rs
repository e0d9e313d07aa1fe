//! The angles of two parts against the ground keep a ratio.

use super::held::torque;
use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::{Condition, Joint};
use crate::model::elements::joints::relation;

pub(super) fn read(arguments: &mut Arguments) -> Option<Joint> {
    let (parent, child) = (arguments.part("parent"), arguments.part("child"));
    let owners = [parent?, child?];
    if owners[0] == owners[1] {
        return arguments.fail(
            "child",
            "a gear couples two different parts; name another part",
        );
    }
    let mut angles = [None; 2];
    for (slot, field) in ["parent", "child"].into_iter().enumerate() {
        let owner = owners[slot];
        let angle = arguments
            .frame(owner)
            .angle
            .filter(|_| !arguments.is_particle(owner));
        if angle.is_none() {
            let name = arguments.owner_name(owner);
            return arguments.fail(
                field,
                format!("`{name}` has no angle that a gear could couple; use a Body or a Bar"),
            );
        }
        angles[slot] = angle;
    }
    let (ratio, offset) = (
        arguments.scalar("ratio"),
        arguments.scalar_or("offset", 0.0),
    );
    let ([parent, child], ratio, offset) = ([angles[0]?, angles[1]?], ratio?, offset?);
    let graph = arguments.graph();
    let expr = relation::affine(graph, parent, child, ratio, offset);
    Some(Joint {
        conditions: vec![Condition::position("", expr, Dimension::NONE)],
        reactions: vec![torque(graph, 0)],
        owners: owners.to_vec(),
        ..Joint::default()
    })
}
