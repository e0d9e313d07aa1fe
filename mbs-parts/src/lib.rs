//! Assemblies for mechanisms: each is declared once by [`assembly!`](mbs_runtime::assembly), and stands in a mechanism as
//! often as wanted.
//!
//! ```
//! use mbs_parts::planar::FourBar;
//! use mbs_runtime::{Simulation, mechanism};
//!
//! mechanism!(Press {
//!     world: Planar(gravity = [0.0, -9.81_m_per_s2]),
//!     linkage: Assembly(
//!         FourBar,
//!         left = ground.origin,
//!         right = ground.point(0.7_m, 0.0_m),
//!         rate = 5.0_rad_per_s
//!     ),
//!     tool: Particle(mass = 0.5_kg),
//!     rod: Distance(linkage.rocker.b, tool.origin, length = 0.4_m),
//!     guide: Holonomic(tool.origin.x - 0.7_m),
//! });
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let press = Press {
//!     linkage: FourBar { crank_length: 0.2, ..FourBar::default() },
//! };
//! let mut simulation = Simulation::new(press)?;
//! simulation.run_until(0.1)?;
//! # Ok(())
//! # }
//! ```
//!
//! The struct of an assembly's name holds its parameters; its ports are what the surroundings give, and are listed with it.

pub mod planar;
pub mod spatial;
