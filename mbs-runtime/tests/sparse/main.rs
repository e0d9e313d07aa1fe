//! Large mechanisms with sparse factors: `cargo test -p mbs-runtime --features sparse --test sparse`.

mod beam;
mod chains;
mod crank;
mod redundant;
mod singular;
mod snake;

use mbs_runtime::{Flow, Mechanism, Settings, Simulation, System};

/// The end of a run, with what may not depend on the factors.
struct End {
    positions: Vec<f64>,
    energy_error: f64,
    rows: f64,
}

/// Runs a mechanism for `time` seconds with steps of `h`.
fn run<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: M,
    settings: Settings,
    time: f64,
) -> End
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let mut simulation: Simulation<S, Q, N, R> =
        Simulation::with_settings(mechanism, settings).expect("it assembles");
    simulation.run_until(time).expect("it runs");
    let report = simulation.report();
    End {
        positions: simulation.positions().iter().copied().collect(),
        energy_error: report.energy_error,
        rows: report.holonomic_error.max(report.velocity_error),
    }
}

/// The largest difference of positions.
fn apart(a: &End, b: &End) -> f64 {
    let pairs = a.positions.iter().zip(&b.positions);
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

fn settings(step: f64, flow: Option<Flow>) -> Settings {
    Settings {
        step,
        flow,
        ..Settings::default()
    }
}

/// Compares the implicit flow, which has sparse factors, with a dense one: both are of second order, with different errors.
fn have_the_same_limit(steps: [f64; 2], dense: Flow, run: impl Fn(f64, Option<Flow>) -> End) {
    let ends = steps.map(|step| {
        let [sparse, dense] = [Flow::Implicit, dense].map(|flow| run(step, Some(flow)));
        assert!(sparse.rows < 1e-11, "{}", sparse.rows);
        apart(&sparse, &dense)
    });
    assert!(ends[0] < 1e-3 && ends[1] < 0.3 * ends[0], "{ends:?}");
}
