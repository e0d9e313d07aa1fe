//! Checks of whole entries and of the whole model: known arguments, connected parts, used names, coordinates with mass.

mod arguments;
mod home_poses;
mod massive;
mod whole;

pub(super) use arguments::arguments;
pub(super) use home_poses::home_poses;
pub(super) use massive::massive;
pub(super) use whole::{carried, connected, used};
