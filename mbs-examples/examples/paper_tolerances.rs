//! Algorithm 1 on the slider-crank over its tolerances: where it passes the singular poses, and what it loses there.
//!
//! `cargo run --release -p mbs-examples --example paper_tolerances`

use mbs_examples::scenes::slider_crank::SliderCrank;
use mbs_runtime::{Method, PaperSettings, Settings, Simulation};

fn main() {
    println!("slider-crank, 20 s, h = 1e-3 s");
    println!(
        "{:>10} {:>10} {:>6} {:>10} {:>14} {:>9}  outcome",
        "ψ̇", "update", "ω, 1/s", "reached, s", "energy error, J", "rejected"
    );
    for (velocity, update, frequency) in [
        (1e-2, 1e-3, 0.0),
        (1e-3, 1e-3, 0.0),
        (1e-3, 1e-4, 0.0),
        (1e-3, 1e-5, 0.0),
        (1e-3, 1e-4, 20.0),
        (1e-4, 1e-4, 0.0),
        (1e-6, 1e-4, 0.0),
        (1e-6, 1e-6, 0.0),
    ] {
        let paper = PaperSettings {
            velocity_tolerance: velocity,
            residual_tolerance: update,
            stabilisation_frequency: frequency,
            ..PaperSettings::default()
        };
        let settings = Settings {
            method: Method::Paper(paper),
            ..Settings::default()
        };
        let (time, energy, rejected, outcome) =
            match Simulation::with_settings(SliderCrank::default(), settings) {
                Err(error) => (0.0, 0.0, 0, error.to_string()),
                Ok(mut simulation) => {
                    let outcome = match simulation.run_until(20.0) {
                        Ok(()) => "reaches the end".to_owned(),
                        Err(error) => error
                            .to_string()
                            .split(';')
                            .next()
                            .unwrap_or_default()
                            .to_owned(),
                    };
                    let report = simulation.report();
                    (
                        simulation.time(),
                        report.energy_error,
                        report.rejected_steps,
                        outcome,
                    )
                }
            };
        println!(
            "{velocity:>10.0e} {update:>10.0e} {frequency:>6} {time:>10.3} {energy:>14.2e} {rejected:>9}  {outcome}"
        );
    }
}
