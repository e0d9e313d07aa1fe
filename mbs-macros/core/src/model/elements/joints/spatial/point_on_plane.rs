//! A point stays on a plane that is fixed in another part.

use super::sliding_point::{self, held_across};
use crate::model::arguments::Arguments;
use crate::model::elements::joint::Joint;

pub(super) fn read(arguments: &mut Arguments) -> Option<Joint> {
    let (point, plane) = sliding_point::points(arguments, "plane")?;
    let normal = arguments.home_axis("normal", 2, plane.owner)?;
    // n · (point − plane) = 0; λ n is the force on the point.
    let normals = [("", normal)];
    Some(held_across(arguments.graph(), point, plane, &normals))
}
