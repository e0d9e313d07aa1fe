//! What the examples share: numbers from the command line, and ten seconds with a line for each.

use mbs_runtime::AnySimulation;
use std::time::Instant;

/// The numbers of the command line in the place of these.
pub fn numbers<const COUNT: usize>(
    mut defaults: [f64; COUNT],
) -> Result<[f64; COUNT], Box<dyn std::error::Error>> {
    for (number, text) in defaults.iter_mut().zip(std::env::args().skip(1)) {
        *number = text.parse()?;
    }
    Ok(defaults)
}

/// Runs for ten seconds.
pub fn ten_seconds(simulation: &mut dyn AnySimulation) -> Result<(), Box<dyn std::error::Error>> {
    let begin = Instant::now();
    println!("  t, s  kinetic, J  potential, J  energy error, J  processor, s");
    for second in 1..=10 {
        simulation.run_until(f64::from(second))?;
        let energy = simulation.energy();
        println!(
            "{second:>6}  {:>10.3}  {:>12.3}  {:>15.1e}  {:>12.2}",
            energy.kinetic,
            energy.potential,
            energy.error,
            begin.elapsed().as_secs_f64()
        );
    }
    let report = simulation.report();
    println!(
        "{} steps, {} stages, {} singular poses passed, rows to {:.0e}",
        report.steps, report.stages, report.rank_losses, report.holonomic_error
    );
    Ok(())
}
