//! A Stewart platform: six legs of given lengths move a plate along a program, which is set each ten milliseconds.
//!
//! `cargo run --release -p mbs-parts --features large --example stewart`

use mbs_runtime::nalgebra::{Rotation3, Vector3};
use mbs_runtime::{Simulation, SimulationError, mechanism};

mechanism!(Stewart {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    length: Each(0..6, |i| Input(1.2_m)),
    speed: Each(0..6, |i| Input(0.0_m_per_s)),
    acceleration: Each(0..6, |i| Input(0.0_m_per_s2)),
    set_at: Input(0.0_s),
    plate: Body(mass = 8.0_kg, inertia = 1.0_kg_m2, at = [0.0, 0.0, 1.0]),
    skew: Each(0..6, |i| Let(18.0_deg * cos(i * pi))),
    x: Each(0..6, |i| Let(1.0_m * cos(i * 60.0_deg - skew[i]))),
    y: Each(0..6, |i| Let(1.0_m * sin(i * 60.0_deg - skew[i]))),
    u: Each(0..6, |i| Let(0.5_m * cos(i * 60.0_deg + skew[i]))),
    v: Each(0..6, |i| Let(0.5_m * sin(i * 60.0_deg + skew[i]))),
    foot: Each(0..6, |i| Let(ground.point(x[i], y[i], 0.0))),
    head: Each(0..6, |i| Let(plate.point(u[i], v[i], 0.0))),
    leg: Each(0..6, |i| Drive(
        norm(head[i] - foot[i]),
        value = length[i],
        rate = speed[i],
        acceleration = acceleration[i],
        since = set_at
    )),
    feet: Each(0..6, |i| Output(foot[i])),
    heads: Each(0..6, |i| Output(head[i])),
    place: Output(plate.origin),
    up: Output(plate.z),
});

/// Place and turn of the plate at t.
pub fn program(t: f64) -> (Vector3<f64>, Rotation3<f64>) {
    let place = [0.1 * t.sin(), 0.1 - 0.1 * t.cos(), 1.0 + 0.05 * t.sin()];
    let turn = Vector3::new(0.1 - 0.1 * t.cos(), 0.15 * t.sin(), 0.0);
    (place.into(), Rotation3::new(turn))
}

/// Lengths of the legs at t; at home the plate is not turned.
fn lengths(home: &StewartOutputs, t: f64) -> [f64; 6] {
    let (place, turn) = program(t);
    let head = |i: usize| place + turn * (home.heads[i] - home.place);
    std::array::from_fn(|i| (head(i) - home.feet[i]).norm())
}

/// The platform after its program.
pub fn follow(until: f64) -> Result<StewartSimulation, SimulationError> {
    let mut platform = Simulation::new(Stewart::default())?;
    let home = platform.outputs();
    while platform.time() < until {
        let (t, d) = (platform.time(), 1e-4);
        let [before, now, after] = [-d, 0.0, d].map(|d| lengths(&home, t + d));
        let mut inputs = platform.inputs_mut();
        (inputs.length, inputs.set_at) = (now, t);
        for i in 0..6 {
            inputs.speed[i] = (after[i] - before[i]) / (2.0 * d);
            inputs.acceleration[i] = (after[i] - 2.0 * now[i] + before[i]) / (d * d);
        }
        drop(inputs);
        platform.run_until(until.min(t + 0.01))?;
    }
    Ok(platform)
}

fn main() -> Result<(), SimulationError> {
    let gap = follow(6.0)?.outputs().place - program(6.0).0;
    println!("after 6 s {:.1e} m from the program", gap.norm());
    Ok(())
}
