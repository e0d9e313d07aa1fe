//! Trees of bodies in space by the angles of their joints: processor time for an evaluation of the accelerations, with its
//! share of the rest of an explicit step of order 8, and for a step of the two-level method.
//!
//! `cargo run --release -p mbs-parts --features large --example trees`

use mbs_runtime::{SimulationError, mechanism};

#[path = "run/timing.rs"]
mod timing;
use timing::line;

macro_rules! chain {
    ($name:ident, $links:tt, $last:tt) => {
        mechanism!($name {
            world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2], coordinates = Joint),
            link: Each(0..$links, |k| Bar(
                mass = 1.0_kg,
                from = [k * 0.1_m, 0.0, 0.0],
                to = [(k + 1) * 0.1_m, 0.0, 0.0],
                radius = 0.01_m
            )),
            top: Revolute(ground, link[0], at = [0.0, 0.0, 0.0], axis = Y),
            joint: Each(1..$links, |k| Revolute(
                link[k - 1],
                link[k],
                at = [k * 0.1_m, 0.0, 0.0],
                axis = if k % 2 == 0 { Y } else { Z }
            )),
            tip: Output(link[$last].b),
        });
    };
}

chain!(Chain7, 7, 6);
chain!(Chain12, 12, 11);
chain!(Chain20, 20, 19);
chain!(Chain30, 30, 29);

mechanism!(Walker {
    doc: "A body with four legs of three joints each.",
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2], coordinates = Joint),
    trunk: Body(
        mass = 10.0_kg,
        inertia = diag(0.1_kg_m2, 0.3_kg_m2, 0.3_kg_m2),
        at = [0.0, 0.0, 1.0],
        free = true
    ),
    hip: Each(0..4, |i| Bar(
        mass = 1.0_kg,
        from = [i * 0.2_m, 0.0, 1.0],
        to = [i * 0.2_m, 0.1, 1.0],
        radius = 0.05_m
    )),
    thigh: Each(0..4, |i| Bar(
        mass = 1.0_kg,
        from = hip[i].b,
        to = [i * 0.2_m, 0.1, 0.6],
        radius = 0.05_m
    )),
    shank: Each(0..4, |i| Bar(
        mass = 1.0_kg,
        from = thigh[i].b,
        to = [i * 0.2_m, 0.1, 0.2],
        radius = 0.05_m
    )),
    spread: Each(0..4, |i| Revolute(trunk, hip[i], at = hip[i].a, axis = X)),
    swing: Each(0..4, |i| Revolute(
        hip[i],
        thigh[i],
        at = hip[i].b,
        axis = Y
    )),
    bend: Each(0..4, |i| Revolute(
        thigh[i],
        shank[i],
        at = thigh[i].b,
        axis = Y
    )),
    foot: Each(0..4, |i| Output(shank[i].b)),
});

fn main() -> Result<(), SimulationError> {
    timing::heading();
    line::<Chain7, _, _, _, _>()?;
    line::<Chain12, _, _, _, _>()?;
    line::<Walker, _, _, _, _>()?;
    line::<Chain20, _, _, _, _>()?;
    line::<Chain30, _, _, _, _>()
}
