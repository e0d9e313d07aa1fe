//! The track of a crawler: 60 links in a loop, hung over two pins.
//!
//! `cargo run --release -p mbs-parts --features large --example tracked_chain -- 0.4 1e-3`, with a number from which the start follows and
//! the step.

mod run;

use mbs_runtime::{Settings, Simulation, mechanism};

mechanism!(Track {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    /// The start follows from it.
    seed: Param(0.4),
    link: Each(0..60, |i| Bar(
        mass = 0.5_kg,
        length = 0.1_m,
        angle = i * 6.0_deg + 0.2 * sin(seed * i)
    )),
    pin: Each(0..60, |i| Revolute(link[i].b, link[(i + 1) % 60].a)),
    front: Revolute(ground.origin, link[0].a),
    rear: Revolute(ground.point(-1.0_m, 1.0_m), link[30].a),
    low: Output(link[45].a),
});

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let [seed, step] = run::numbers([0.4, 1e-3])?;
    let settings = Settings {
        step,
        ..Settings::default()
    };
    let mut simulation = Simulation::with_settings(Track { seed }, settings)?;
    run::ten_seconds(&mut simulation)
}
