//! Passages with random steps from random phases: failures, wrong branches, and the ratio of the worst to the usual
//! energy error of a step.
//!
//! `cargo run --release -p mbs-examples --example passage_phases [steps per order] [scene] [constraint tolerance] [--csv book/src/results/readme]`
//! Each step is drawn log-uniformly. It is run from several states, drawn from the first ten seconds of the smooth
//! branch, and compared with a fine run from the same state at every half second. Energy alone does not show a wrong
//! branch. On the smooth branch the rods of the slider-crank stay mirror images, and the cranks of the double four-bar
//! stay parallel.

use mbs_examples::pages::phases::{COLUMNS, KEYS};
use mbs_examples::pages::record::{File, Recorder};
use mbs_examples::scenes::{double_four_bar, slider_crank};
use mbs_runtime::nalgebra::SVector;
use mbs_runtime::{Mechanism, Settings, Simulation, SimulationError, State, System};

const ORDERS: [u8; 2] = [2, 8];
/// s
const STEPS: [f64; 2] = [5e-4, 2e-2];
/// Length of a run, and instants of comparison, s.
const DURATION: f64 = 10.0;
const INTERVAL: f64 = 0.5;
/// Number of initial states, and number of runs of each step.
const PHASES: usize = 40;
const PHASES_OF_A_STEP: usize = 7;
/// A mechanism that is this far from the symmetry of the smooth branch, m, has left it.
const ASTRAY: f64 = 0.1;
/// Step of the fine runs, at order 8, s.
const FINE: f64 = 2.5e-3;

/// An initial state, and the poses of its fine run at each instant.
struct Phase<const Q: usize, const N: usize, const R: usize> {
    start: State<Q, N, R>,
    way: Vec<SVector<f64, Q>>,
}

/// Distance of named points from the symmetry of the smooth branch, m.
type Asymmetry = fn(&dyn Fn(&str) -> [f64; 3]) -> f64;

/// The scenes, in their order.
const SCENES: [&str; 2] = ["slider-crank", "double-four-bar"];

fn main() -> Result<(), String> {
    let mut recorder =
        Recorder::new("cargo run --release -p mbs-examples --example passage_phases")?;
    let count: usize = recorder.number(0, 500)?;
    let scene = recorder.arguments.get(1).cloned();
    if let Some(scene) = &scene
        && !SCENES.contains(&scene.as_str())
    {
        return Err(format!(
            "there is no `{scene}` here (there are: {})",
            SCENES.join(", ")
        ));
    }
    let usual = Settings::default();
    let settings = Settings {
        constraint_tolerance: recorder.parsed(2, usual.constraint_tolerance)?,
        ..usual
    };
    let mut file = recorder.file("phases.csv", &COLUMNS, KEYS)?;
    let wanted = |name: &str| scene.as_deref().is_none_or(|scene| scene == name);
    println!(
        "{count} steps an order in [{:e}, {:e}] s, each from {PHASES_OF_A_STEP} phases, {DURATION} s; energy errors in J",
        STEPS[0], STEPS[1]
    );
    println!(
        "\n| scene | order | placement | runs | failed | wrong branch | median energy error | worst | median position error, m | worst | worst energy error / median of a step: median | 90 % | 99 % | largest | steps within 3 |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"
    );
    if wanted("slider-crank") {
        sweep(
            "slider-crank",
            &slider_crank::SliderCrank::default(),
            |point| (point("rod.b")[0] - 2.0 * point("crank.b")[0]).abs(),
            (count, settings),
            &mut file,
        )?;
    }
    if wanted("double-four-bar") {
        sweep(
            "double-four-bar",
            &double_four_bar::DoubleFourBar::default(),
            |point| {
                let height = |name: &str| point(name)[1];
                let first = (height("crank0.b") - height("crank1.b")).abs();
                first.max((height("crank1.b") - height("crank2.b")).abs())
            },
            (count, settings),
            &mut file,
        )?;
    }
    Ok(())
}

fn sweep<M, S, const Q: usize, const N: usize, const R: usize>(
    name: &str,
    mechanism: &M,
    asymmetry: Asymmetry,
    (count, settings): (usize, Settings),
    file: &mut File,
) -> Result<(), String>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let mut random = 0x9e37_79b9_7f4a_7c15_u64;
    let phases = phases(mechanism, &mut random).map_err(|error| format!("{name}: {error}"))?;
    let first = random;
    for placement in [false, true] {
        for order in ORDERS {
            // All rows have the same steps and phases.
            random = first;
            let (mut failed, mut astray) = (0, 0);
            let (mut errors, mut ratios, mut distances) = (Vec::new(), Vec::new(), Vec::new());
            for _ in 0..count {
                let step = STEPS[0] * (STEPS[1] / STEPS[0]).powf(uniform(&mut random));
                let settings = Settings {
                    order,
                    step,
                    placement,
                    ..settings
                };
                let mut of_step = Vec::new();
                for _ in 0..PHASES_OF_A_STEP {
                    let phase = &phases[(uniform(&mut random) * PHASES as f64) as usize];
                    match run(mechanism, settings, phase, asymmetry) {
                        Ok((energy, distance, off)) => {
                            astray += usize::from(!(off < ASTRAY));
                            distances.push(distance);
                            of_step.push(energy);
                        }
                        Err(_) => failed += 1,
                    }
                }
                of_step.sort_by(f64::total_cmp);
                ratios.push(at(&of_step, 1.0) / at(&of_step, 0.5));
                errors.append(&mut of_step);
            }
            errors.sort_by(f64::total_cmp);
            ratios.sort_by(f64::total_cmp);
            distances.sort_by(f64::total_cmp);
            let within = ratios.iter().filter(|ratio| **ratio <= 3.0).count();
            println!(
                "| {name} | {order} | {} | {} | {failed} | {astray} | {:.1e} | {:.1e} | {:.1e} | {:.1e} | {:.2} | {:.2} | {:.1} | {:.1} | {:.1} % |",
                if placement { "yes" } else { "no" },
                count * PHASES_OF_A_STEP,
                at(&errors, 0.5),
                at(&errors, 1.0),
                at(&distances, 0.5),
                at(&distances, 1.0),
                at(&ratios, 0.5),
                at(&ratios, 0.9),
                at(&ratios, 0.99),
                at(&ratios, 1.0),
                100.0 * within as f64 / count as f64,
            );
            let mut row = vec![name.to_owned(), order.to_string()];
            row.push(if placement { "yes" } else { "no" }.to_owned());
            row.push(format!("{:e}", settings.constraint_tolerance));
            row.extend([count * PHASES_OF_A_STEP, failed, astray].map(|n| n.to_string()));
            row.extend(
                [&errors, &distances]
                    .into_iter()
                    .flat_map(|values| [0.5, 1.0].map(|part| format!("{:.4e}", at(values, part)))),
            );
            row.extend([0.5, 0.9, 0.99, 1.0].map(|part| format!("{:.4}", at(&ratios, part))));
            row.push(format!("{:.1}", 100.0 * within as f64 / count as f64));
            file.put(row)?;
        }
    }
    Ok(())
}

/// States of a fine run at random times, and the fine runs from them.
fn phases<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: &M,
    random: &mut u64,
) -> Result<Vec<Phase<Q, N, R>>, SimulationError>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let settings = Settings {
        order: 8,
        step: FINE,
        ..Settings::default()
    };
    let mut phases = Vec::new();
    let mut worst = 0.0_f64;
    for _ in 0..PHASES {
        let mut simulation = Simulation::with_settings(mechanism.clone(), settings)?;
        simulation.run_until(DURATION * uniform(random))?;
        let begin = State::new(0.0, *simulation.positions(), *simulation.velocities());
        let mut fine = Simulation::resume(mechanism.clone(), settings, begin.clone())?;
        let mut way = Vec::new();
        for instant in 1..=(DURATION / INTERVAL) as u32 {
            fine.run_until(f64::from(instant) * INTERVAL)?;
            way.push(*fine.positions());
        }
        worst = worst.max(fine.report().energy_error);
        phases.push(Phase { start: begin, way });
    }
    eprintln!("energy error of the fine runs: {worst:.1e} J");
    Ok(phases)
}

/// The energy error, the largest distance of a coordinate from the fine run, and the largest asymmetry.
fn run<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: &M,
    settings: Settings,
    phase: &Phase<Q, N, R>,
    asymmetry: Asymmetry,
) -> Result<(f64, f64, f64), SimulationError>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let mut simulation = Simulation::resume(mechanism.clone(), settings, phase.start.clone())?;
    let (mut distance, mut off) = (0.0_f64, 0.0_f64);
    for (instant, wanted) in (1..).zip(&phase.way) {
        simulation.run_until(f64::from(instant) * INTERVAL)?;
        let points = simulation.points();
        let index = |name: &str| S::MODEL.points.iter().position(|other| *other == name);
        let now = asymmetry(&|name| index(name).map_or([f64::NAN; 3], |i| points[i]));
        off = if now.is_nan() {
            f64::INFINITY
        } else {
            off.max(now)
        };
        for (now, wanted) in simulation.positions().iter().zip(wanted) {
            let error = (now - wanted).abs();
            distance = if error.is_nan() {
                f64::INFINITY
            } else {
                distance.max(error)
            };
        }
    }
    Ok((simulation.report().energy_error, distance, off))
}

/// A quantile of sorted values.
fn at(values: &[f64], part: f64) -> f64 {
    let index = (part * values.len() as f64) as usize;
    let last = values.len().saturating_sub(1);
    values.get(index.min(last)).copied().unwrap_or(f64::NAN)
}

/// The next number in [0, 1): xorshift64*.
fn uniform(state: &mut u64) -> f64 {
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    (state.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 11) as f64 / (1u64 << 53) as f64
}
