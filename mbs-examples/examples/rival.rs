//! The two-level method against explicit Runge–Kutta on the index-1 form, both on the same generated code. For each
//! scene and family: the least processor time of a loop of steps, without `Simulation`, over ten seconds, with the
//! energy error within a bound and with the best order, step and setting of the family. A number of steps counts only
//! if it and four larger ones, up to a tenth more, all stay within the bound and end on the right branch. Times are the
//! least of interleaved repeats.
//!
//! `cargo run --release -p mbs-examples --example rival [SCENE…] [--csv book/src/results/readme]`

use cpu_time::ProcessTime;
use mbs_examples::pages::record::{File, Recorder};
use mbs_examples::pages::rival::{COLUMNS, FAMILIES, KEYS};
use mbs_examples::pages::scene_runs::reference;
use mbs_examples::reference::ReferenceTable;
use mbs_examples::scene::Scene;
use mbs_examples::scenes::{bricard, double_four_bar, pendulum, slider_crank};
use mbs_runtime::output::Frame;
use mbs_runtime::{
    BaselineStepper, BaumgarteSettings, Mechanism, Method, Settings, Simulation, State, System,
    TwoLevelStepper,
};
use std::hint::black_box;

/// s
const DURATION: f64 = 10.0;
/// Bounds of max |E − E₀|, J.
const BOUNDS: [f64; 3] = [1e-1, 1e-3, 1e-6];
/// A run that ends this far from the reference, m, is on another branch.
const ASTRAY: f64 = 0.3;
/// The least and the largest number of steps, and the factor from one to the next.
const STEPS: [f64; 2] = [4.0, 20_000.0];
const FINER: f64 = 1.03;
/// The runs that have to be within the bound, too: at least this number of steps more, and this factor.
const NEIGHBOURS: [(u32, f64); 5] = [(0, 1.0), (1, 1.01), (2, 1.02), (3, 1.05), (4, 1.1)];
const GAINS: [f64; 7] = [0.0, 1.0, 3.0, 10.0, 30.0, 100.0, 300.0];
const REPEATS: usize = 40;

/// One way to integrate.
#[derive(Clone, Copy)]
struct Entry {
    family: &'static str,
    settings: Settings,
}

/// An entry with the index of its bound, its number of steps and its least time, s.
type Run = (Entry, usize, u32, f64);

/// Evaluations of the accelerations in a step of an explicit method.
fn stages(order: u8) -> u32 {
    match order {
        4 => 4,
        6 => 7,
        _ => 12,
    }
}

impl Entry {
    /// Order, gain, tolerance, steps and calls.
    fn cells(&self, steps: u32) -> [String; 5] {
        let order = self.settings.order;
        let (gain, tolerance, calls) = match self.settings.method {
            Method::Baumgarte(baumgarte) => (Some(baumgarte.gain), None, Some(stages(order))),
            Method::Projected => (
                None,
                Some(self.settings.constraint_tolerance),
                Some(stages(order)),
            ),
            _ => (None, Some(self.settings.constraint_tolerance), None),
        };
        [
            order.to_string(),
            gain.map_or_else(String::new, |gain| gain.to_string()),
            tolerance.map_or_else(String::new, |tolerance| format!("{tolerance:e}")),
            steps.to_string(),
            calls.map_or_else(String::new, |calls| (calls * steps).to_string()),
        ]
    }

    fn label(&self) -> String {
        let setting = match self.settings.method {
            Method::Baumgarte(baumgarte) => format!("gain {}", baumgarte.gain),
            _ => format!("tolerance {:.0e}", self.settings.constraint_tolerance),
        };
        format!("order {}, {setting}", self.settings.order)
    }
}

fn entries() -> Vec<Entry> {
    let mut entries = Vec::new();
    for constraint_tolerance in [1e-13, 1e-10, 1e-7] {
        for (family, method, orders) in [
            ("two-level", Method::TwoLevel, &[2, 4, 6, 8][..]),
            ("projected", Method::Projected, &[4, 6, 8]),
        ] {
            for &order in orders {
                let settings = Settings {
                    method,
                    order,
                    constraint_tolerance,
                    ..Settings::default()
                };
                entries.push(Entry { family, settings });
            }
        }
    }
    for gain in GAINS {
        for order in [4, 6, 8] {
            let settings = Settings {
                method: Method::Baumgarte(BaumgarteSettings {
                    gain,
                    ..BaumgarteSettings::default()
                }),
                order,
                ..Settings::default()
            };
            let family = "baumgarte";
            entries.push(Entry { family, settings });
        }
    }
    entries
}

enum Bare<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    TwoLevel(Box<TwoLevelStepper<S, Q, N, R>>),
    Baseline(Box<BaselineStepper<S, Q, N, R>>),
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Bare<S, Q, N, R> {
    fn new(system: S, state: State<Q, N, R>, settings: &Settings) -> Option<Self> {
        match settings.method {
            Method::TwoLevel => TwoLevelStepper::new(system, state, settings)
                .ok()
                .map(|stepper| Bare::TwoLevel(Box::new(stepper))),
            _ => BaselineStepper::new(system, state, settings)
                .ok()
                .map(|stepper| Bare::Baseline(Box::new(stepper))),
        }
    }

    fn step(&mut self, h: f64) -> bool {
        match self {
            Bare::TwoLevel(stepper) => stepper.step(h).is_ok(),
            Bare::Baseline(stepper) => stepper.step(h).is_ok(),
        }
    }

    fn run(&mut self, h: f64, steps: u32) -> bool {
        match self {
            Bare::TwoLevel(stepper) => (0..steps).all(|_| stepper.step(black_box(h)).is_ok()),
            Bare::Baseline(stepper) => (0..steps).all(|_| stepper.step(black_box(h)).is_ok()),
        }
    }

    fn state(&self) -> &State<Q, N, R> {
        match self {
            Bare::TwoLevel(stepper) => stepper.state(),
            Bare::Baseline(stepper) => stepper.state(),
        }
    }
}

/// A scene with its initial state and its reference.
struct Contest<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    system: S,
    start: State<Q, N, R>,
    reference: ReferenceTable,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Contest<S, Q, N, R> {
    fn stepper(&self, settings: &Settings) -> Option<Bare<S, Q, N, R>> {
        Bare::new(self.system.clone(), self.start.clone(), settings)
    }

    fn energy(&self, state: &State<Q, N, R>) -> f64 {
        let (q, v) = (&state.positions, &state.velocities);
        self.system.kinetic_energy(q, v) + self.system.potential_energy(q)
    }

    /// max |E − E₀| of a run that ends on the right branch; infinite for any other.
    fn energy_error(&self, settings: &Settings, steps: u32) -> f64 {
        let h = DURATION / f64::from(steps);
        let settings = Settings {
            step: h,
            ..*settings
        };
        let Some(mut stepper) = self.stepper(&settings) else {
            return f64::INFINITY;
        };
        let initial = self.energy(&self.start);
        let mut worst: f64 = 0.0;
        for _ in 0..steps {
            if !stepper.step(h) {
                return f64::INFINITY;
            }
            worst = worst.max((self.energy(stepper.state()) - initial).abs());
            if !(worst <= BOUNDS[0]) {
                return f64::INFINITY;
            }
        }
        if self.distance(stepper.state()) < ASTRAY {
            worst
        } else {
            f64::INFINITY
        }
    }

    /// The largest position error at the end of a run, against the reference, m.
    fn distance(&self, state: &State<Q, N, R>) -> f64 {
        let mut outputs = vec![0.0; S::MODEL.outputs.len()];
        let (q, v) = (&state.positions, &state.velocities);
        self.system.outputs(DURATION, q, v, &mut outputs);
        let frame = Frame {
            time: DURATION,
            outputs,
            ..Frame::default()
        };
        let deviations = self.reference.compare(&[frame]);
        let positions = deviations.iter().filter(|d| d.column.ends_with("_m"));
        positions
            .map(|deviation| deviation.at_end.unwrap_or(f64::INFINITY))
            .fold(0.0, |most, e| if e > most || e.is_nan() { e } else { most })
    }

    /// For each bound the least number of steps such that the errors of this run and of its neighbours are within the
    /// bound.
    fn coarsest(&self, settings: &Settings) -> [Option<u32>; 3] {
        let mut found = [None; 3];
        let mut count = STEPS[0];
        let mut last = 0;
        while count < STEPS[1] && found.contains(&None) {
            let steps = count.ceil() as u32;
            count *= FINER;
            if steps == last {
                continue;
            }
            last = steps;
            let missing = found.iter().position(Option::is_none);
            let wanted = missing.map_or(0.0, |i| BOUNDS[i]);
            let mut worst: f64 = 0.0;
            for (more, factor) in NEIGHBOURS {
                if worst <= wanted {
                    let neighbour = (f64::from(steps) * factor).ceil() as u32;
                    worst = worst.max(self.energy_error(settings, neighbour.max(steps + more)));
                }
            }
            for (found, bound) in found.iter_mut().zip(BOUNDS) {
                if found.is_none() && worst <= bound {
                    *found = Some(steps);
                }
            }
        }
        found
    }

    fn time(&self, settings: &Settings, steps: u32) -> f64 {
        let h = DURATION / f64::from(steps);
        let settings = Settings {
            step: h,
            ..*settings
        };
        let Some(mut stepper) = self.stepper(&settings) else {
            return f64::INFINITY;
        };
        let start = ProcessTime::now();
        let done = stepper.run(h, steps);
        let time = start.elapsed().as_secs_f64();
        if done { time } else { f64::INFINITY }
    }
}

fn compete<M, S, const Q: usize, const N: usize, const R: usize>(
    scene: &Scene,
    mechanism: M,
    wanted: &[String],
    file: &mut File,
) -> Result<(), String>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    if !wanted.is_empty() && !wanted.iter().any(|name| name == scene.name) {
        return Ok(());
    }
    let (Some(reference), Ok(system), Ok(simulation)) = (
        reference(scene)?,
        mechanism.prepare(),
        Simulation::new(mechanism.clone()),
    ) else {
        return Err(format!("{}: without a reference or a start", scene.name));
    };
    let contest = Contest {
        system,
        start: simulation.state().clone(),
        reference,
    };
    println!("\n{} ({N} velocities, {R} rows), {DURATION} s", scene.name);
    let mut runs: Vec<Run> = Vec::new();
    for entry in entries() {
        for (bound, steps) in contest.coarsest(&entry.settings).into_iter().enumerate() {
            if let Some(steps) = steps {
                runs.push((entry, bound, steps, f64::INFINITY));
            }
        }
    }
    for _ in 0..REPEATS {
        for (entry, _, steps, least) in &mut runs {
            *least = least.min(contest.time(&entry.settings, *steps));
        }
    }
    println!(
        "{:>8}  {:<11} {:>10} {:>7}  {:<24} {:>9}  {:>8}",
        "bound, J", "method", "time, ms", "steps", "setting", "us a step", "ratio"
    );
    for (index, bound) in BOUNDS.iter().enumerate() {
        let mut ours = f64::NAN;
        for family in FAMILIES {
            let of_family = |run: &&Run| run.1 == index && run.0.family == family;
            let best = runs
                .iter()
                .filter(of_family)
                .min_by(|a, b| a.3.total_cmp(&b.3));
            let mut row = vec![scene.name.to_owned(), format!("{bound:e}")];
            row.push(family.to_owned());
            let Some((entry, _, steps, time)) = best else {
                println!("{bound:>8.0e}  {family:<11} {:>10}", "never");
                row.resize(COLUMNS.len(), String::new());
                file.put(row)?;
                continue;
            };
            if family == FAMILIES[0] {
                ours = *time;
            }
            println!(
                "{bound:>8.0e}  {family:<11} {:>10.4} {steps:>7}  {:<24} {:>9.3}  {:>8.2}",
                1e3 * time,
                entry.label(),
                1e6 * time / f64::from(*steps),
                time / ours,
            );
            row.extend(entry.cells(*steps));
            row.push(format!("{:.5}", 1e3 * time));
            file.put(row)?;
        }
    }
    Ok(())
}

fn main() -> Result<(), String> {
    let recorder = Recorder::new("cargo run --release -p mbs-examples --example rival")?;
    let file = &mut recorder.file("rival.csv", &COLUMNS, KEYS)?;
    let scenes = [
        &pendulum::SCENE,
        &slider_crank::SCENE,
        &double_four_bar::SCENE,
        &bricard::SCENE,
    ];
    recorder.check_names(scenes.map(|scene| scene.name))?;
    let wanted = &recorder.arguments;
    compete(
        &pendulum::SCENE,
        pendulum::Pendulum::default(),
        wanted,
        file,
    )?;
    compete(
        &slider_crank::SCENE,
        slider_crank::SliderCrank::default(),
        wanted,
        file,
    )?;
    compete(
        &double_four_bar::SCENE,
        double_four_bar::DoubleFourBar::default(),
        wanted,
        file,
    )?;
    compete(&bricard::SCENE, bricard::Bricard::default(), wanted, file)
}
