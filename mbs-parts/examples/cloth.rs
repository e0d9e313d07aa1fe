//! A cloth of 20 × 20 rods, hung up at two corners, from a random start: hundreds of loops, and poses in which rods are in
//! line and rows lose their independence.
//!
//! `cargo run --release -p mbs-parts --features large --example cloth -- 0.3 1e-3`, with a number from which the start follows and the step;
//! with `random 20 1` twenty runs from random starts with random steps, and the seed 1.

mod random;
mod run;

use mbs_runtime::{Settings, Simulation, mechanism};

mechanism!(Cloth {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    /// The start follows from it.
    seed: Param(0.3),
    /// Of the knots at the start.
    speed: Param(0.0_m_per_s),
    knot: Each((0..20, 0..20), |i, j| Particle(
        mass = 0.01_kg,
        at = if i == 0 && (j == 0 || j == 19) {
            [0.0_m, j * 0.09_m, 0.0]
        } else {
            [
                i * 0.09_m + 0.01_m * sin(seed * (17 * i + 5 * j + 1)),
                j * 0.09_m + 0.01_m * sin(seed * (7 * i + 11 * j + 2)),
                0.02_m * sin(seed * (3 * i + 13 * j + 4)),
            ]
        },
        velocity = [0.0_m_per_s, 0.0, speed * sin(seed * (5 * i + 3 * j + 2))]
    )),
    along: Each((0..19, 0..20), |i, j| Distance(
        knot[i][j].origin,
        knot[i + 1][j].origin,
        length = 0.1_m
    )),
    across: Each((0..20, 0..19), |i, j| Distance(
        knot[i][j].origin,
        knot[i][j + 1].origin,
        length = 0.1_m
    )),
    left: Spherical(ground.origin, knot[0][0].origin),
    right: Spherical(ground.point(0.0_m, 1.71_m, 0.0_m), knot[0][19].origin),
    corner: Output(knot[19][19].origin),
});

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let at_random = random::asked_for([5e-4, 4e-3], |random, settings| {
        let cloth = Cloth {
            seed: random.between(0.1, 100.0),
            speed: random.between(-1.0, 1.0),
        };
        Ok(Box::new(Simulation::with_settings(cloth, settings)?))
    })?;
    if at_random {
        return Ok(());
    }
    let [seed, step] = run::numbers([0.3, 1e-3])?;
    let settings = Settings {
        step,
        ..Settings::default()
    };
    let mut simulation = Simulation::with_settings(
        Cloth {
            seed,
            ..Cloth::default()
        },
        settings,
    )?;
    run::ten_seconds(&mut simulation)
}
