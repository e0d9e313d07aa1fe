//! Joints, conditions and force elements, as data: what each says of parts and their points. What they mean as equations is
//! stage 3.

mod element;
pub mod force;
mod forces;
pub mod joint;
mod joints;
mod kind;
pub(super) mod kinds;
mod read;

pub use element::{ForceEntry, JointEntry};
