//! The time of an evaluation and of a step.

use mbs_runtime::{Mechanism, Method, Settings, Simulation, SimulationError, System, methods};
use std::time::Instant;

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

/// The line of a mechanism.
pub fn line<M, S, const Q: usize, const N: usize, const R: usize>() -> Result<(), SimulationError>
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
        "{name:>11}  {N:>10}  {R:>4}  {:>14.2}  {two_level:>17.2}",
        explicit / 12.0
    );
    Ok(())
}

/// The heading of the lines.
pub fn heading() {
    println!("  mechanism  velocities  rows  evaluation, µs  two-level step, µs");
}
