//! The candidates of the toolkit for a scene: an accuracy, given steps, tolerances, and Baumgarte's terms.

use super::branch::Branch;
use super::candidate::{BOUNDS, Candidate, Outcome, Steps, measured};
use cpu_time::ProcessTime;
use mbs_examples::scene::Scene;
use mbs_runtime::{
    BaselineStepper, BaumgarteSettings, Mechanism, Method, Settings, Simulation, State, System,
    TwoLevelStepper,
};
use std::hint::black_box;

/// Accuracies and tolerances, from the first by this factor.
const COARSEST: f64 = 0.1;
const FINER: f64 = 0.84;
const ACCURACIES: u32 = 130;

fn fine(index: u32) -> f64 {
    COARSEST * FINER.powi(index as i32)
}

/// Calls of the accelerations in a step of an explicit method.
fn calls(settings: &Settings) -> Option<u64> {
    match (settings.method, settings.order) {
        (Method::TwoLevel, _) => None,
        (_, 8) => Some(12),
        (_, 6) => Some(7),
        _ => Some(4),
    }
}

/// A scene, how long it runs, and where it ends.
pub struct Course<'c> {
    pub scene: &'c Scene,
    pub duration: f64,
    pub branch: Branch,
    pub steps: Steps,
}

impl Course<'_> {
    /// Accuracies alone.
    pub fn accuracies(&self) -> Vec<Candidate<'_>> {
        vec![
            self.paced("accuracy", "accuracy".to_owned(), |index| Settings {
                step: 1e-2,
                ..Settings::accuracy(fine(index))
            }),
        ]
    }

    /// Tolerances with each of our methods and orders.
    pub fn tolerances(&self) -> Vec<Candidate<'_>> {
        let methods = [Method::Projected, Method::TwoLevel];
        let orders = methods.map(|method| [8, 6, 4].map(|order| (method, order)));
        let candidate = |(method, order): (Method, u8)| {
            let setting = format!("{} {order}; tolerance", method.name());
            self.paced("ours", setting, move |index| Settings {
                method,
                order,
                step: 1e-2,
                tolerance: Some(fine(index)),
                ..Settings::default()
            })
        };
        orders.into_iter().flatten().map(candidate).collect()
    }

    /// Runs whose steps follow from a number.
    fn paced<'c>(
        &'c self,
        family: &'static str,
        setting: String,
        settings: impl Fn(u32) -> Settings + Copy + 'c,
    ) -> Candidate<'c> {
        Candidate {
            family,
            setting,
            grid: (0..ACCURACIES).collect(),
            name: |index| format!("{:.1e}", fine(index)),
            check: Box::new(move |index| self.check(settings(index))),
            time: Box::new(move |index| {
                let Ok(mut simulation) = (self.scene.build)(&[], settings(index)) else {
                    return f64::INFINITY;
                };
                measured(&mut || simulation.run_until(self.duration).is_ok())
            }),
        }
    }

    fn check(&self, settings: Settings) -> Outcome {
        let mut outcome = Outcome {
            error: f64::INFINITY,
            seconds: f64::INFINITY,
            steps: 0,
            calls: None,
        };
        let Ok(mut simulation) = (self.scene.build)(&[], settings) else {
            return outcome;
        };
        let begun = ProcessTime::now();
        let done = simulation.run_until(self.duration).is_ok();
        outcome.seconds = begun.elapsed().as_secs_f64();
        let report = simulation.report();
        (outcome.steps, outcome.calls) = (report.steps, Some(report.stages));
        let (time, points) = (simulation.time(), simulation.points());
        let outputs = simulation.output_values();
        if done
            && self
                .branch
                .holds(simulation.model(), time, &points, outputs)
        {
            outcome.error = report.energy_error;
        }
        outcome
    }
}

/// A mechanism at its start, for steps without `Simulation`.
pub struct Bare<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    system: S,
    start: State<Q, N, R>,
    /// The work of a constant force on each coordinate, N or N m.
    pub pull: [f64; Q],
}

enum Stepper<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    TwoLevel(Box<TwoLevelStepper<S, Q, N, R>>),
    Baseline(Box<BaselineStepper<S, Q, N, R>>),
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Stepper<S, Q, N, R> {
    fn step(&mut self, h: f64) -> bool {
        match self {
            Stepper::TwoLevel(stepper) => stepper.step(h).is_ok(),
            Stepper::Baseline(stepper) => stepper.step(h).is_ok(),
        }
    }

    fn state(&self) -> &State<Q, N, R> {
        match self {
            Stepper::TwoLevel(stepper) => stepper.state(),
            Stepper::Baseline(stepper) => stepper.state(),
        }
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Bare<S, Q, N, R> {
    pub fn new<M: Mechanism<System = S>>(mechanism: M) -> Result<Self, String> {
        let simulation =
            Simulation::new(mechanism).map_err(|error| format!("{}: {error}", S::MODEL.name))?;
        Ok(Bare {
            system: simulation.system().clone(),
            start: simulation.state().clone(),
            pull: [0.0; Q],
        })
    }

    /// Given steps with each of our methods, orders and tolerances of the rows.
    pub fn given_steps<'c>(&'c self, course: &'c Course) -> Vec<Candidate<'c>> {
        let mut candidates = Vec::new();
        for (method, orders) in [
            (Method::Projected, &[8, 6, 4][..]),
            (Method::TwoLevel, &[8, 6, 4, 2]),
        ] {
            for &order in orders {
                for constraint_tolerance in [1e-13, 1e-10, 1e-7] {
                    let settings = Settings {
                        method,
                        order,
                        constraint_tolerance,
                        ..Settings::default()
                    };
                    let setting = format!(
                        "{} {order}; rows to {constraint_tolerance:e}",
                        method.name()
                    );
                    candidates.push(self.stepped(course, "ours", setting, settings));
                }
            }
        }
        candidates
    }

    /// Runge–Kutta of orders 4 and 8 with Baumgarte's terms; gains in numbers per run of ten seconds.
    pub fn stabilised<'c>(&'c self, course: &'c Course, gains: &[f64]) -> Vec<Candidate<'c>> {
        let mut candidates = Vec::new();
        for (family, order) in [("Baumgarte 4", 4), ("Baumgarte 8", 8)] {
            for gain in gains.iter().map(|gain| gain * 10.0 / course.duration) {
                let method = Method::Baumgarte(BaumgarteSettings {
                    gain,
                    ..BaumgarteSettings::default()
                });
                let settings = Settings {
                    method,
                    order,
                    ..Settings::default()
                };
                candidates.push(self.stepped(
                    course,
                    family,
                    format!("gain {gain:.3}/s"),
                    settings,
                ));
            }
        }
        candidates
    }

    fn stepped<'c>(
        &'c self,
        course: &'c Course,
        family: &'static str,
        setting: String,
        settings: Settings,
    ) -> Candidate<'c> {
        Candidate {
            family,
            setting,
            grid: course.steps.grid(),
            name: |steps| format!("{steps} steps"),
            check: Box::new(move |steps| self.check(course, &settings, steps)),
            time: Box::new(move |steps| {
                let h = course.duration / f64::from(steps);
                let Some(mut stepper) = self.stepper(&settings, h) else {
                    return f64::INFINITY;
                };
                measured(&mut || match &mut stepper {
                    Stepper::TwoLevel(stepper) => {
                        (0..steps).all(|_| stepper.step(black_box(h)).is_ok())
                    }
                    Stepper::Baseline(stepper) => {
                        (0..steps).all(|_| stepper.step(black_box(h)).is_ok())
                    }
                })
            }),
        }
    }

    fn stepper(&self, settings: &Settings, step: f64) -> Option<Stepper<S, Q, N, R>> {
        let settings = Settings { step, ..*settings };
        let (system, start) = (self.system.clone(), self.start.clone());
        match settings.method {
            Method::TwoLevel => TwoLevelStepper::new(system, start, &settings)
                .ok()
                .map(|stepper| Stepper::TwoLevel(Box::new(stepper))),
            _ => BaselineStepper::new(system, start, &settings)
                .ok()
                .map(|stepper| Stepper::Baseline(Box::new(stepper))),
        }
    }

    fn energy(&self, state: &State<Q, N, R>) -> f64 {
        let (q, v) = (&state.positions, &state.velocities);
        let work: f64 = q.iter().zip(self.pull).map(|(q, pull)| q * pull).sum();
        self.system.kinetic_energy(q, v) + self.system.potential_energy(q) - work
    }

    fn check(&self, course: &Course, settings: &Settings, steps: u32) -> Outcome {
        let h = course.duration / f64::from(steps);
        let begun = ProcessTime::now();
        let mut outcome = Outcome {
            error: f64::INFINITY,
            seconds: 0.0,
            steps: u64::from(steps),
            calls: calls(settings).map(|calls| calls * u64::from(steps)),
        };
        let Some(mut stepper) = self.stepper(settings, h) else {
            return outcome;
        };
        let initial = self.energy(&self.start);
        let mut worst: f64 = 0.0;
        let done = (0..steps).all(|_| {
            let stepped = stepper.step(h);
            let error = (self.energy(stepper.state()) - initial).abs();
            worst = worst.max(error);
            stepped && error <= BOUNDS[0]
        });
        outcome.seconds = begun.elapsed().as_secs_f64();
        let state = stepper.state();
        let (q, v) = (&state.positions, &state.velocities);
        let mut points = vec![[0.0; 3]; S::MODEL.points.len()];
        self.system.points(course.duration, q, &mut points);
        let mut outputs = vec![0.0; S::MODEL.outputs.len()];
        self.system.outputs(course.duration, q, v, &mut outputs);
        let time = course.duration;
        if done && course.branch.holds(S::MODEL, time, &points, outputs) {
            outcome.error = worst;
        }
        outcome
    }
}
