//! Bars, bodies, particles and states: which coordinates each takes on its own.
//!
//! | part | coordinates | mass matrix | rows |
//! |---|---|---|---|
//! | bar | its two end points (*natural*) | constant | its length |
//! | planar bar whose angle a joint or force uses | centre and angle (*reference*) | constant | none |
//! | planar body | centre of mass and angle (*reference*) | constant | none |
//! | body in space, bar in space with a radius or inertia | centre of mass and unit quaternion, with the angular velocity in body axes as quasi-velocity (*rigid*) | constant | none |
//! | particle | its point | constant | none |
//! | state | its integral over time | 1, which is not in T | none |
//! | any, with `frame =` or `position =` | none: it follows `Coordinate`s (*prescribed*) | depends on q | none |

mod inertia;
mod part;
mod planar;
mod point;
mod shape;
mod shape_arguments;
mod spatial;
mod state;
mod wish;

pub use part::{Home, Part, Representation, StartPlace};
pub use shape::Shape;
