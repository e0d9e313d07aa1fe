//! A point stays on a line that is fixed in another part.

use super::held::across;
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;

pub(super) fn read(arguments: &mut Arguments) -> Option<Joint> {
    let (point, line) = (arguments.point("point"), arguments.point("line"));
    let (point, line) = (point?, line?);
    if point.owner == line.owner {
        let owner = arguments.owner_name(point.owner);
        return arguments.fail(
            "line",
            format!("the point and the line both belong to `{owner}`"),
        );
    }
    let axis = arguments.axis("axis", line.owner)?;
    // n · (point − line) = 0 with n across the line; λ n is the force on the point.
    Some(across(arguments.graph(), &line, &point, axis, ""))
}
