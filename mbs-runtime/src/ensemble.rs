//! Many runs of one mechanism, over all cores.

use std::num::NonZero;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use crate::{Mechanism, Settings, Simulation, SimulationError, System};

/// Stack of a worker, bytes: large systems keep their vectors there, and threads get less than programs do.
const STACK: usize = 16 << 20;

/// Simulates each of `members`, mechanisms with parameters of their own, over all cores: `run` is called with the
/// assembled simulation of each, runs it and returns its results.
///
/// Results come in the order of the members. The runs are independent, so that the results are bit for bit those of
/// sequential runs. The assembly of a member allocates; its steps do not.
///
/// ```
/// use mbs_runtime::{Settings, mechanism, simulate_ensemble};
///
/// mechanism!(Pendulum {
///     world: Planar(gravity = [0.0, -9.81_m_per_s2]),
///     length: Param(1.0_m),
///     rod: Bar(mass = 1.0_kg, length = length, angle = 0.0_deg),
///     pivot: Revolute(ground.origin, rod.a),
///     lowest: Event(rod.b.x),
/// });
///
/// let lengths = [0.5, 1.0, 1.5, 2.0];
/// let members = lengths.map(|length| Pendulum { length });
/// let quarters = simulate_ensemble(&members, Settings::default(), |simulation| {
///     simulation.run_to_event("lowest", 10.0)
/// });
/// for (quarter, length) in quarters.into_iter().zip(lengths) {
///     let quarter = quarter.expect("it swings").expect("it comes to the lowest point");
///     assert!((quarter / length.sqrt() - 0.4833).abs() < 1e-3);
/// }
/// ```
///
/// # Errors
/// Each member has its own: that of [`Simulation::with_settings`], or what `run` returns. The others run on.
///
/// # Panics
/// If `run` panics, after the other members have ended; their results are lost then.
pub fn simulate_ensemble<M, S, T, const Q: usize, const N: usize, const R: usize>(
    members: &[M],
    settings: Settings,
    run: impl Fn(&mut Simulation<S, Q, N, R>) -> Result<T, SimulationError> + Sync,
) -> Vec<Result<T, SimulationError>>
where
    M: Mechanism<System = S> + Sync,
    S: System<Q, N, R>,
    T: Send,
{
    let start = |member: &M| Simulation::with_settings(member.clone(), settings);
    over_all_cores(members, |member| run(&mut start(member)?))
}

/// The same with any [`Method`](crate::Method), as [`Simulation::with_any_method`].
///
/// # Errors
/// Each member has its own: that of [`Simulation::with_any_method`], or what `run` returns. The others run on.
///
/// # Panics
/// If `run` panics, after the other members have ended; their results are lost then.
pub fn simulate_ensemble_with_any_method<M, S, T, const Q: usize, const N: usize, const R: usize>(
    members: &[M],
    settings: Settings,
    run: impl Fn(&mut Simulation<S, Q, N, R>) -> Result<T, SimulationError> + Sync,
) -> Vec<Result<T, SimulationError>>
where
    M: Mechanism<System = S> + Sync,
    S: System<Q, N, R>,
    T: Send,
{
    let start = |member: &M| Simulation::with_any_method(member.clone(), settings);
    over_all_cores(members, |member| run(&mut start(member)?))
}

/// The results of `run` for all members, in their order.
fn over_all_cores<M: Sync, T: Send>(
    members: &[M],
    run: impl Fn(&M) -> Result<T, SimulationError> + Sync,
) -> Vec<Result<T, SimulationError>> {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut done = Vec::new();
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(member) = members.get(index) else {
                return done;
            };
            done.push((index, run(member)));
        }
    };
    let cores = thread::available_parallelism().map_or(1, NonZero::get);
    let mut results = thread::scope(|scope| {
        let spawn = |_| {
            let worker = thread::Builder::new().stack_size(STACK);
            // If no thread can be started, this one does the work.
            worker.spawn_scoped(scope, work).ok()
        };
        let helpers: Vec<_> = (0..cores.min(members.len())).map_while(spawn).collect();
        let mut results = match helpers.is_empty() {
            true => work(),
            false => Vec::with_capacity(members.len()),
        };
        for helper in helpers {
            match helper.join() {
                Ok(done) => results.extend(done),
                // `run` panicked: the panic is passed to the caller.
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
        results
    });
    results.sort_unstable_by_key(|(index, _)| *index);
    results.into_iter().map(|(_, result)| result).collect()
}
