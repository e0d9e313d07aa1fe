//! The angles of two parts relative to the ground have a constant ratio.

use super::held::torque;
use crate::dimension::Dimension;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::{Condition, Joint};
use crate::model::elements::joints::relation;
use crate::model::elements::kind::JointKind;
use crate::schema::{Absent, Expects, Group, JointTraits, Kind, field, positional};

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "Gear",
        group: Group::Joint,
        fields: &[
            positional(
                "parent",
                Expects::PartAngle,
                Absent::Required,
                "the driving part",
            ),
            positional(
                "child",
                Expects::PartAngle,
                Absent::Required,
                "the driven part; the reaction is the torque on it",
            ),
            field(
                "ratio",
                Expects::Known(Dimension::NONE),
                Absent::Required,
                "angle of the child per angle of the parent (negative for external gears)",
            ),
            field(
                "offset",
                Expects::Known(Dimension::NONE),
                Absent::Assumed("0"),
                "angle of the child when the parent's is zero",
            ),
        ],
        doc: "The angles of two parts against the ground keep a ratio.",
        joint: Some(JointTraits::NONE),
    },
    read,
};

fn read(arguments: &mut Arguments) -> Option<Joint> {
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
