//! The two-level method against explicit Runge–Kutta on the index-1 form, both on the same generated code.
//!
//! For each scene and method: the least processor time of a loop of bare steps over ten seconds whose energy error stays
//! within a bound, with the best order, step and setting of each. A setting counts only if it and the two next finer steps
//! (1 % and 2 % more of them) all stay within the bound and end on the right branch. Times are the least of interleaved
//! repeats.
//!
//! `cargo run --release -p mbs-examples --example rival [SCENE…]`

use cpu_time::ProcessTime;
use mbs_examples::reference::ReferenceTable;
use mbs_examples::scene::Scene;
use mbs_examples::scenes::{bricard, double_four_bar, pendulum, slider_crank};
use mbs_runtime::output::Frame;
use mbs_runtime::{
    BaselineStepper, BaumgarteSettings, Energy, Mechanism, Method, Settings, Simulation, State,
    System, TwoLevelStepper,
};
use std::hint::black_box;

/// s
const DURATION: f64 = 10.0;
/// Bounds of max |E − E₀|, J.
const BOUNDS: [f64; 3] = [1e-1, 1e-3, 1e-6];
/// A run that ends this far from the reference, m, is on another branch.
const ASTRAY: f64 = 0.3;
/// Numbers of steps grow by this factor.
const FINER: f64 = 1.1;
/// Numbers of steps that are tried.
const STEPS: [f64; 2] = [60.0, 100_000.0];
const REPEATS: usize = 40;

/// One way to integrate.
#[derive(Clone, Copy)]
struct Entry {
    family: &'static str,
    settings: Settings,
}

impl Entry {
    fn label(&self) -> String {
        let setting = match self.settings.method {
            Method::Baumgarte(baumgarte) => format!("gain {}", baumgarte.gain),
            _ => format!("tolerance {:.0e}", self.settings.constraint_tolerance),
        };
        format!("order {}, {setting}", self.settings.order)
    }
}

/// The first is what the others are measured by; `rk4-gain10` is order 4 with gain 10 alone.
const FAMILIES: [&str; 4] = ["two-level", "rk4-gain10", "baumgarte", "projected"];

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
    for gain in [3.0, 10.0, 30.0] {
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
            if gain == 10.0 && order == 4 {
                let family = "rk4-gain10";
                entries.push(Entry { family, settings });
            }
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

/// A scene with all that its runs start from.
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

    /// How far the end of a run is from the reference in its worst position, m.
    fn distance(&self, state: &State<Q, N, R>) -> f64 {
        let mut outputs = vec![0.0; S::MODEL.outputs.len()];
        let (q, v) = (&state.positions, &state.velocities);
        self.system.outputs(DURATION, q, v, &mut outputs);
        let frame = Frame {
            time: DURATION,
            coordinates: vec![],
            velocities: vec![],
            outputs,
            points: vec![],
            reactions: vec![],
            energy: Energy::default(),
            holonomic_error: 0.0,
            velocity_error: 0.0,
        };
        let deviations = self.reference.compare(&[frame]);
        let positions = deviations.iter().filter(|d| d.column.ends_with("_m"));
        positions
            .map(|deviation| deviation.at_end.unwrap_or(f64::INFINITY))
            .fold(0.0, |most, e| if e > most || e.is_nan() { e } else { most })
    }

    /// For each bound the least number of steps with which it holds, and holds with 1 % and 2 % more.
    fn coarsest(&self, settings: &Settings) -> [Option<u32>; 3] {
        let mut found = [None; 3];
        let mut count = STEPS[0];
        while count < STEPS[1] && found.contains(&None) {
            let tried = [1.0, 1.01, 1.02].map(|factor| (count * factor).ceil() as u32);
            let wanted = found
                .iter()
                .position(Option::is_none)
                .map_or(0.0, |i| BOUNDS[i]);
            let mut worst: f64 = 0.0;
            for steps in tried {
                if worst <= wanted {
                    worst = worst.max(self.energy_error(settings, steps));
                }
            }
            for (found, bound) in found.iter_mut().zip(BOUNDS) {
                if found.is_none() && worst <= bound {
                    *found = Some(tried[0]);
                }
            }
            count *= FINER;
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

fn compete<M, S, const Q: usize, const N: usize, const R: usize>(scene: &Scene, mechanism: M)
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let wanted: Vec<String> = std::env::args().skip(1).collect();
    if !wanted.is_empty() && !wanted.iter().any(|name| name == scene.name) {
        return;
    }
    let reference = scene
        .reference
        .and_then(|r| ReferenceTable::find(&r, scene.model).ok().flatten());
    let (Some(reference), Ok(system), Ok(simulation)) = (
        reference,
        mechanism.prepare(),
        Simulation::new(mechanism.clone()),
    ) else {
        println!("{}: without a reference or a start", scene.name);
        return;
    };
    let contest = Contest {
        system,
        start: simulation.state().clone(),
        reference,
    };
    println!("\n{} ({N} velocities, {R} rows), {DURATION} s", scene.name);
    let mut runs = Vec::new();
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
            let best = runs
                .iter()
                .filter(|run| run.1 == index && run.0.family == family)
                .min_by(|a, b| a.3.total_cmp(&b.3));
            match best {
                Some((entry, _, steps, time)) => {
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
                }
                None => println!("{bound:>8.0e}  {family:<11} {:>10}", "never"),
            }
        }
    }
}

fn main() {
    compete(&pendulum::SCENE, pendulum::Pendulum::default());
    compete(&slider_crank::SCENE, slider_crank::SliderCrank::default());
    compete(
        &double_four_bar::SCENE,
        double_four_bar::DoubleFourBar::default(),
    );
    compete(&bricard::SCENE, bricard::Bricard::default());
}
