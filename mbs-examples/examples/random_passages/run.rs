//! A random run through singular poses, and how it ended.

use crate::random::Random;
use mbs_examples::scene::Scene;
use mbs_examples::scenes::passages;
use mbs_runtime::{AnySimulation, Settings, SimulationError};

/// The length of a run, s.
const DURATION: f64 = 5.0;
/// A pose this far from the branch of the motion is on another one, m.
const ASTRAY: f64 = 0.02;
/// The largest torque of an input, N m.
const PUSH: f64 = 5.0;
/// An error of energy that is wrong, as a part of the greatest kinetic energy.
const WRONG: f64 = 0.1;

/// What was drawn.
#[derive(Debug)]
pub struct Run {
    settings: Settings,
    parameters: Vec<(String, f64)>,
    /// The run is interrupted every so often, s.
    piece: Option<f64>,
}

/// How a run ended.
#[allow(dead_code)] // What is in it is printed.
#[derive(Debug)]
pub enum End {
    /// On its branch, with this error of energy as a part of the greatest kinetic energy.
    Passed { energy: f64, poses: usize },
    /// With an error.
    Stopped(SimulationError),
    /// On another branch, at this time.
    Astray(f64),
    /// With a wrong energy.
    Energy(f64),
}

impl Run {
    /// The run of this number.
    pub fn draw(scene: &Scene, seed: usize, number: usize) -> Self {
        let random = &mut Random::of(&format!("{seed} {} {number}", scene.name));
        let mut among =
            |least: f64, most: f64| 0.5 * (least + most) + random.within(0.5 * (most - least));
        let mut log = |least: f64, most: f64| among(least.ln(), most.ln()).exp();
        let damping = if number % 2 == 1 { log(1e-3, 0.3) } else { 0.0 };
        let sort = log(1.0, 6.0_f64.exp()).ln();
        let settings = match sort as usize {
            0 => Settings {
                order: 2,
                step: log(5e-4, 1e-2),
                ..Settings::default()
            },
            sort @ 1..=3 => Settings {
                order: 2 * sort as u8 + 2,
                step: log(2e-3, 3e-2),
                ..Settings::default()
            },
            4 => Settings::for_tolerance(log(1e-8, 1e-3)),
            _ => Settings::accuracy(log(1e-8, 1e-3)),
        };
        let piece = log(2.5e-5, 0.5);
        let rate = log(1.0, 4.0);
        let turn = among(-1.0, 1.0);
        let phase = among(-std::f64::consts::PI, std::f64::consts::PI);
        Run {
            settings,
            parameters: [
                ("phase", phase),
                ("rate", rate.copysign(turn)),
                ("damping", damping),
            ]
            .map(|(name, value)| (name.to_owned(), value))
            .to_vec(),
            piece: (piece > 5e-3).then_some(piece),
        }
    }

    /// Whether a damper brakes it.
    pub fn is_damped(&self) -> bool {
        self.parameters
            .iter()
            .any(|(name, value)| name == "damping" && *value > 0.0)
    }

    /// Runs it.
    pub fn execute(&self, scene: &Scene) -> End {
        match (scene.build)(&self.parameters, self.settings) {
            Ok(mut simulation) => self.follow(scene, &mut *simulation),
            Err(error) => End::Stopped(error),
        }
    }

    fn follow(&self, scene: &Scene, simulation: &mut dyn AnySimulation) -> End {
        let mut outputs = scene.model.outputs.iter();
        let place = outputs.position(|output| output.name == passages::ASTRAY);
        let mut kinetic: f64 = 0.0;
        let mut count = 0.0;
        while simulation.time() < DURATION {
            count += 1.0;
            if !scene.model.inputs.is_empty() && (self.piece.is_some() || count % 10.0 == 0.0) {
                let push = PUSH * f64::sin(13.0 * count);
                if let Err(error) = simulation.set_input("push", push) {
                    return End::Stopped(error);
                }
            }
            let moved = match self.piece {
                Some(piece) => simulation.run_until(count * piece),
                None => simulation.step(),
            };
            if let Err(error) = moved {
                return End::Stopped(error);
            }
            kinetic = kinetic.max(simulation.energy().kinetic);
            let astray = place.map_or(f64::NAN, |place| simulation.output_values()[place].abs());
            if !(astray < ASTRAY) {
                return End::Astray(simulation.time());
            }
        }
        let report = simulation.report();
        let energy = report.energy_error / kinetic;
        match energy < WRONG {
            true => End::Passed {
                energy,
                poses: report.rank_losses,
            },
            false => End::Energy(energy),
        }
    }
}
