//! Random mechanisms as declarations: trees of parts in any pose, with loops that close exactly at the guess, springs
//! and loads; and the same with conditions on positions and velocities.

mod planar;
mod planar_conditions;
mod spatial;
mod spatial_conditions;

pub use planar::{planar, planar_conditioned};
pub use spatial::{spatial, spatial_conditioned};

use crate::random::Random;
use std::fmt::Write;

/// A prescribed motion from a value at t = 0, in this unit.
fn motion(random: &mut Random, start: f64, unit: &str) -> String {
    let [speed, amplitude] = [0.5, 0.2].map(|size| random.within(size));
    let frequency = 2.0 + random.within(1.0);
    format!("{start} + {speed}_{unit}_per_s * t + {amplitude}_{unit} * sin({frequency}_per_s * t)")
}

/// A speed that is prescribed: none, or one that changes with time.
fn speed(random: &mut Random) -> String {
    match random.between(0, 1) {
        0 => String::new(),
        _ => {
            let amplitude = random.within(0.5);
            format!(" - {amplitude}_m_per_s * cos(2.0_per_s * t)")
        }
    }
}

/// A condition on velocities, once or as two rows that say the same.
fn nonholonomic(text: &mut String, name: &str, condition: &str, random: &mut Random) {
    let _ = match random.between(0, 2) {
        0 => write!(
            text,
            "{name}: Nonholonomic([{condition}, -2.0 * ({condition})]), "
        ),
        _ => write!(text, "{name}: Nonholonomic({condition}), "),
    };
}
