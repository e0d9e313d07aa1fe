//! Two points coincide.

use super::held::coincidence;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;
use crate::model::mobilizer::Mobilizer;

pub(super) fn read(arguments: &mut Arguments) -> Option<Joint> {
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
