//! Ten seconds from many random starts: which of them fail, and how large the errors of energy are.

use mbs_runtime::{AnySimulation, Settings, SimulationError};
use std::error::Error;

const UNTIL: f64 = 10.0;

/// A source of random numbers (the linear congruential one of D. Knuth's MMIX).
pub struct Random(u64);

impl Random {
    fn new(seed: u64) -> Self {
        let mut random = Random(seed);
        random.unit();
        random
    }

    fn unit(&mut self) -> f64 {
        self.0 = (self.0.wrapping_mul(6_364_136_223_846_793_005))
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn between(&mut self, least: f64, most: f64) -> f64 {
        least + (most - least) * self.unit()
    }
}

/// A simulation from a random start.
pub type Start = fn(&mut Random, Settings) -> Result<Box<dyn AnySimulation>, SimulationError>;

/// If the command line begins with `random`: as many runs as the number behind it says, with the seed behind this, and with
/// the accuracy behind that; without one with steps of constant length, between these, in proportion. Whether it does.
pub fn asked_for(steps: [f64; 2], start: Start) -> Result<bool, Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    if arguments.next().as_deref() != Some("random") {
        return Ok(false);
    }
    let count = arguments.next().map_or(Ok(20), |text| text.parse())?;
    let seed = arguments.next().map_or(Ok(1), |text| text.parse())?;
    let accuracy = arguments.next().map(|text| text.parse()).transpose()?;
    run(start, steps, count, seed, accuracy);
    Ok(true)
}

fn run(
    start: Start,
    [shortest, longest]: [f64; 2],
    count: usize,
    seed: u64,
    accuracy: Option<f64>,
) {
    let mut random = Random::new(seed);
    let (mut failures, mut parts) = (0, Vec::new());
    println!("   step, s  singular poses  rejected  energy error, J  of the kinetic energy");
    for _ in 0..count {
        let step = shortest * (longest / shortest).powf(random.unit());
        let settings = Settings {
            step,
            accuracy,
            ..Settings::default()
        };
        let ended = start(&mut random, settings).and_then(|mut simulation| {
            let mut most: f64 = 0.0;
            while simulation.time() < UNTIL {
                simulation.step()?;
                most = most.max(simulation.energy().kinetic);
            }
            Ok((simulation.report(), most))
        });
        match ended {
            Ok((report, most)) => {
                let part = report.energy_error / most;
                parts.push(part);
                println!(
                    "{step:>10.2e}  {:>14}  {:>8}  {:>15.1e}  {part:>21.1e}",
                    report.rank_losses, report.rejected_steps, report.energy_error
                );
            }
            Err(error) => {
                failures += 1;
                println!("{step:>10.2e}  {error}");
            }
        }
    }
    parts.sort_unstable_by(f64::total_cmp);
    let median = parts.get(parts.len() / 2).copied().unwrap_or(f64::NAN);
    let largest = parts.last().copied().unwrap_or(f64::NAN);
    println!(
        "{count} runs, {failures} failed; energy errors {median:.1e} in the median, {largest:.1e} at most"
    );
}
