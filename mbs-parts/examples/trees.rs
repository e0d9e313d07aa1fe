//! Trees of bodies in space by the angles of their joints: processor time for an evaluation of the accelerations, with its
//! share of the rest of an explicit step of order 8, and for a step of the two-level method.
//!
//! `cargo run --release -p mbs-parts --features large --example trees`

use mbs_runtime::{
    Mechanism, Method, Settings, Simulation, SimulationError, System, mechanism, methods,
};
use std::time::Instant;

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

/// Steps that are timed, and their length, s.
const STEPS: u32 = 2000;
const STEP: f64 = 1e-4;

/// Microseconds for a step.
fn time<M, S, const Q: usize, const N: usize, const R: usize>(
    method: Method,
    order: u8,
) -> Result<f64, SimulationError>
where
    M: Mechanism<System = S> + Default,
    S: System<Q, N, R>,
{
    let settings = Settings {
        method,
        order,
        step: STEP,
        ..Settings::default()
    };
    let mut simulation = Simulation::with_methods(M::default(), settings, methods::Projected)?;
    simulation.run_until(10.0 * STEP)?;
    let (before, begin) = (simulation.time(), Instant::now());
    simulation.run_until(before + f64::from(STEPS) * STEP)?;
    Ok(1e6 * begin.elapsed().as_secs_f64() / f64::from(STEPS))
}

fn line<M, S, const Q: usize, const N: usize, const R: usize>() -> Result<(), SimulationError>
where
    M: Mechanism<System = S> + Default,
    S: System<Q, N, R>,
{
    // The best of five, because other programs may run.
    let best = |method, order| -> Result<f64, SimulationError> {
        let times = (0..5).map(|_| time::<M, S, Q, N, R>(method, order));
        times
            .into_iter()
            .try_fold(f64::INFINITY, |best, time| Ok(best.min(time?)))
    };
    let (explicit, two_level) = (best(Method::Projected, 8)?, best(Method::TwoLevel, 2)?);
    let name = S::MODEL.name;
    println!(
        "{name:>8}  {N:>10}  {:>14.2}  {two_level:>17.2}",
        explicit / 12.0
    );
    Ok(())
}

fn main() -> Result<(), SimulationError> {
    println!("    tree  velocities  evaluation, µs  two-level step, µs");
    line::<Chain7, _, _, _, _>()?;
    line::<Chain12, _, _, _, _>()?;
    line::<Walker, _, _, _, _>()?;
    line::<Chain20, _, _, _, _>()?;
    line::<Chain30, _, _, _, _>()
}
