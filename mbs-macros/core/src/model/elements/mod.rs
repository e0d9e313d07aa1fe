//! Joints, conditions and force elements, as data in terms of parts and their points. Stage 3 derives their equations.

pub mod bushing;
mod element;
pub mod force;
mod forces;
pub mod joint;
mod joints;
mod kind;
pub(super) mod kinds;
pub mod laws;
mod read;

pub use element::{ForceEntry, JointEntry, ReadForce};
pub(super) use forces::read as read_force;
