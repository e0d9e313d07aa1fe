//! A plate of 8 × 8 bodies on bushings with dampers, clamped at one edge: rotations and velocity forces, no rows. With 20
//! for 8 and 19 for 7 it has 2400 velocities.
//!
//! `cargo run --release -p mbs-parts --features large,sparse --example bushing_grid -- 1e-2`, with the step: the stiffest
//! vibration has ω h = 28.

mod run;

use mbs_runtime::{Settings, Simulation, mechanism};

mechanism!(Plate {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    stiffness: Param(5e4_N_per_m),
    damping: Param(5.0_N_s_per_m),
    torsion_stiffness: Param(2e3_Nm),
    torsion_damping: Param(5.0_N_m_s),
    block: Each((0..8, 0..8), |i, j| Body(
        mass = 0.5_kg,
        inertia = diag(1.0e-3_kg_m2, 1.2e-3, 1.5e-3),
        at = [i * 0.2_m, j * 0.2_m, 0.0]
    )),
    along: Each((0..7, 0..8), |i, j| Bushing(
        block[i][j],
        block[i + 1][j],
        at = [i * 0.2_m + 0.1_m, j * 0.2_m, 0.0],
        stiffness = stiffness,
        damping = damping,
        torsion_stiffness = torsion_stiffness,
        torsion_damping = torsion_damping
    )),
    across: Each((0..8, 0..7), |i, j| Bushing(
        block[i][j],
        block[i][j + 1],
        at = [i * 0.2_m, j * 0.2_m + 0.1_m, 0.0],
        stiffness = stiffness,
        damping = damping,
        torsion_stiffness = torsion_stiffness,
        torsion_damping = torsion_damping
    )),
    clamp: Each(0..8, |j| Bushing(
        ground,
        block[0][j],
        at = [-0.1_m, j * 0.2_m, 0.0],
        stiffness = stiffness,
        damping = damping,
        torsion_stiffness = torsion_stiffness,
        torsion_damping = torsion_damping
    )),
    corner: Output(block[7][7].origin),
});

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let [step] = run::numbers([1e-2])?;
    let settings = Settings {
        step,
        ..Settings::default()
    };
    let mut simulation = Simulation::with_settings(Plate::default(), settings)?;
    run::ten_seconds(&mut simulation)?;
    println!(
        "dissipated: {:.3} J",
        -simulation.energy().nonconservative_work
    );
    Ok(())
}
