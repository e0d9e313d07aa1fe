//! The axes in which the components of a force are given.

use crate::model::arguments::Arguments;
use crate::model::geometry::Owner;

/// Those of `axes =`, or the ground's.
pub(super) fn force_in(arguments: &mut Arguments) -> Option<Owner> {
    if !arguments.has("axes") {
        return Some(Owner::Ground);
    }
    let owner = arguments.part("axes")?;
    let name = arguments.owner_name(owner);
    if arguments.is_particle(owner) || arguments.is_slender(owner) {
        return arguments.fail("axes", format!("`{name}` has no axes; use a `Body`"));
    }
    Some(owner)
}
