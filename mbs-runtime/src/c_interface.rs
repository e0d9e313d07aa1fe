//! Mechanisms for programs in C: functions of a static library, and their header.
//!
//! A crate declares a mechanism and names its functions:
//!
//! ```
//! mbs_runtime::mechanism!(Pendulum {
//!     world: Planar(gravity = [0.0, -9.81_m_per_s2]),
//!     length: Param(1.0_m),
//!     rod: Bar(mass = 1.0_kg, length = length, angle = 0.0_deg),
//!     pivot: Revolute(ground.origin, rod.a),
//!     angle: Output(rod.angle),
//! });
//! mbs_runtime::c_library!(pendulum: Pendulum);
//!
//! use mbs_runtime::{Mechanism, c_interface};
//! let header = c_interface::header("pendulum", Pendulum::MODEL);
//! assert!(header.contains("double length; /* in m; 1 by default */"));
//! ```
//!
//! `cargo rustc --crate-type staticlib` makes the library, [`header`] the text of `pendulum.h`. Parameters, inputs and
//! outputs are structs with a `double` for each; a nested name such as `front.arm.length` has underscores for its
//! points. Every call returns a [`Status`]; no panic leaves the library. A simulation is one of
//! [`Settings::placement`](crate::Settings::placement) off: each step has the length it was made with.

mod calls;
mod header;
mod library;
mod status;

pub use header::header;
pub use status::Status;

/// For [`c_library!`](crate::c_library).
#[doc(hidden)]
pub use {calls::*, status::message};
