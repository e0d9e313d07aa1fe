//! A Stewart–Gough platform on six legs, which its drives hold against gravity and shake.
//!
//! `cargo run --release -p mbs-parts --features large --example platform -- 10.0 1e-3`, with the amplitude of the drives, N, and the step.

mod run;

use mbs_parts::spatial::Hexapod;
use mbs_runtime::{Settings, Simulation, mechanism};

mechanism!(Platform {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    plate: Body(
        mass = 10.0_kg,
        inertia = Cylinder(0.5_m, 0.05_m, Z),
        at = [0.0_m, 0.0, 1.0]
    ),
    legs: Assembly(Hexapod, base = ground, platform = plate),
    /// Amplitude of the drives.
    shake: Param(10.0_N),
    /// Stiffness of the control of each leg.
    stiffness: Param(3e3_N_per_m),
    /// Its damping.
    damping: Param(100.0_N_s_per_m),
    drive: Each(0..6, |i| Let(shake * sin(3.0_per_s * t + i * 1.0_rad)
        - stiffness * legs.leg[i].slide.stroke
        - damping * legs.leg[i].slide.speed)),
    up: Each(0..6, |i| Force(
        legs.leg[i].upper.b,
        value = [drive[i], 0.0, 0.0],
        axes = legs.leg[i].lower
    )),
    down: Each(0..6, |i| Force(
        legs.leg[i].lower.a,
        value = [-drive[i], 0.0, 0.0],
        axes = legs.leg[i].lower
    )),
    pose: Output(plate.origin),
});

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let [shake, step] = run::numbers([10.0, 1e-3])?;
    let settings = Settings {
        step,
        ..Settings::default()
    };
    let platform = Platform {
        shake,
        ..Platform::default()
    };
    let mut simulation = Simulation::with_settings(platform, settings)?;
    run::ten_seconds(&mut simulation)
}
