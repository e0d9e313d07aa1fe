//! Thirty links by bodies, on revolutes about Y and Z in turn, that fall from the horizontal: rotations, 180 velocities, 150
//! rows. With 300 for 30 it has 1800 and 1500.
//!
//! `cargo run --release -p mbs-parts --features large,sparse --example spatial_chain -- 1e-3`, with the step.

mod run;

use mbs_runtime::{Settings, Simulation, mechanism};

mechanism!(SpatialChain {
    world: Spatial(
        gravity = [0.0, 0.0, -9.81_m_per_s2],
        coordinates = Reference
    ),
    link: Each(0..30, |k| Bar(
        mass = 1.0_kg,
        from = [k * 0.1_m, 0.0, 0.0],
        to = [(k + 1) * 0.1_m, 0.0, 0.0],
        radius = 0.01_m
    )),
    top: Revolute(ground, link[0], at = [0.0, 0.0, 0.0], axis = Y),
    joint: Each(1..30, |k| Revolute(
        link[k - 1],
        link[k],
        at = [k * 0.1_m, 0.0, 0.0],
        axis = if k % 2 == 0 { Y } else { Z }
    )),
    tip: Output(link[29].b),
});

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let [step] = run::numbers([1e-3])?;
    let settings = Settings {
        step,
        ..Settings::default()
    };
    let mut simulation = Simulation::with_settings(SpatialChain::default(), settings)?;
    run::ten_seconds(&mut simulation)
}
