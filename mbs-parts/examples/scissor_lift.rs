//! A scissor lift of 50 stages, which falls through the poses in which all arms are in line. Its plate is held level twice:
//! one row is redundant for ever.
//!
//! `cargo run --release -p mbs-parts --features large --example scissor_lift -- 0.3 2e-4`, with the rate of the first arm at the start,
//! rad/s, and the step; with `random 20 1` twenty runs from random angles and rates with random steps, and the seed 1.

mod random;
mod run;

use mbs_parts::planar::ScissorStage;
use mbs_runtime::{Settings, Simulation, mechanism};

mechanism!(ScissorLift {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    /// Angle of the arms at the start.
    angle: Param(40.0_deg),
    /// Their rate.
    rate: Param(0.3_rad_per_s),
    slide: Particle(mass = 0.5_kg, at = [1.0_m * cos(angle), 0.0]),
    rail: Holonomic(slide.origin.y),
    stage: Each(0..50, |i| Assembly(
        ScissorStage,
        left = if i == 0 {
            ground.origin
        } else {
            stage[i - 1].falling.b
        },
        right = if i == 0 {
            slide.origin
        } else {
            stage[i - 1].rising.b
        },
        angle = angle,
        rate = rate
    )),
    plate: Body(mass = 2.0_kg, inertia = 0.1_kg_m2),
    hinge: Revolute(stage[49].falling.b, plate.origin),
    roller: Holonomic(dot(stage[49].rising.b - plate.origin, plate.y)),
    level: Holonomic(plate.angle),
    top: Output(plate.origin),
});

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let at_random = random::asked_for([1e-4, 2e-3], |random, settings| {
        let lift = ScissorLift {
            angle: random.between(0.1, 1.5),
            rate: random.between(-2.0, 2.0),
            ..ScissorLift::default()
        };
        Ok(Box::new(Simulation::with_settings(lift, settings)?))
    })?;
    if at_random {
        return Ok(());
    }
    let [rate, step] = run::numbers([0.3, 2e-4])?;
    let settings = Settings {
        step,
        ..Settings::default()
    };
    let lift = ScissorLift {
        rate,
        ..ScissorLift::default()
    };
    let mut simulation = Simulation::with_settings(lift, settings)?;
    run::ten_seconds(&mut simulation)
}
