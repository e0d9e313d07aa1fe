//! Two points coincide.

use super::held::coincidence;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;
use crate::model::elements::kind::JointKind;
use crate::model::mobilizer::Mobilizer;
use crate::schema::common::{CHILD, PARENT};
use crate::schema::{Group, JointTraits, Kind};

pub(super) const KIND: JointKind = JointKind {
    kind: Kind {
        name: "Revolute",
        group: Group::Joint,
        fields: &[PARENT, CHILD],
        doc: "The two points coincide. Between ends of bars, particles and the ground they are merged: no coordinate and no row. It has `angle` and `rate`: those of the child less those of the parent.",
        joint: Some(JointTraits {
            carries: true,
            arguments_elsewhere: &["at", "axis"],
            turns: true,
            ..JointTraits::NONE
        }),
    },
    read,
};

fn read(arguments: &mut Arguments) -> Option<Joint> {
    let (parent, child) = (arguments.point("parent"), arguments.point("child"));
    let (parent, child) = (parent?, child?);
    if parent.owner == child.owner {
        let owner = arguments.owner_name(parent.owner);
        return arguments.fail(
            "child",
            format!("both points belong to `{owner}`: a joint holds two different parts"),
        );
    }
    Some(Joint {
        mobilizer: Some(Mobilizer::of_points(&parent, &child)),
        coincident: Some([parent.clone(), child.clone()]),
        merges: Some([parent.clone(), child.clone()]),
        ..coincidence(arguments.graph(), &parent, &child)
    })
}
