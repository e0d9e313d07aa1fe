//! `mbs` against equations in bar angles, written as straight-line code by hand with plain arrays and numbers in place of
//! parameters, as one writes them with computer algebra; and an accuracy against Runge–Kutta steps with Baumgarte's terms
//! on the generated equations. Milliseconds of one core for the motion of a scene with the energy error within a bound, on
//! the right branch, with the best setting of each that a search found. Both sides are compiled by the same optimiser, and
//! timed in turns.
//!
//! `cargo run --release -p mbs-examples --example symbolic [SCENE…] [--csv book/src/results/readme]`

mod branch;
mod candidate;
mod chain;
mod contest;
mod equations;
mod exact;
mod ours;
mod rival;
mod slider_crank;
mod tableau;
mod trial;

use branch::{Branch, without_brackets};
use candidate::{BOUNDS, Candidate, Steps};
use chain::Chain;
use contest::Contest;
use equations::Equations;
use mbs_examples::pages::record::{File, Recorder};
use mbs_examples::pages::scene_runs::reference;
use mbs_examples::pages::symbolic::{COLUMNS, FAMILIES, KEYS, STABILISED};
use mbs_examples::scene::Scene;
use mbs_examples::scenes;
use mbs_runtime::{AnySimulation, Mechanism, Settings, System};
use ours::{Bare, Course};
use slider_crank::SliderCrank;
use trial::DURATION;

/// How long the equations are compared, s, with how many steps, and how far apart they may be, m. It is before the first
/// singular pose, where round-off grows in long chains.
const COMPARED: (f64, u32, f64) = (0.5, 500, 1e-9);
/// The power that may be lost in a motion off all symmetries, W: the error of a difference quotient.
const LOST: f64 = 1e-5;
/// Gains of Baumgarte's terms, per run of ten seconds.
const GAINS: [f64; 10] = [0.0, 1.0, 3.0, 5.0, 10.0, 20.0, 30.0, 60.0, 100.0, 300.0];
/// Numbers of steps that are tried, and those for a scene whose steps take long.
const FINE: Steps = Steps {
    most: 20_000,
    factor: 1.01,
};
const COARSE: Steps = Steps {
    most: 10_000,
    factor: 1.03,
};
const STABILISED_BOUNDS: [f64; 2] = [1e-1, 1e-6];

/// What the program was asked for.
enum Wish {
    /// All scenes, or these.
    Table(Vec<String>),
    /// One run: part, scene, candidate, value.
    Count(String, String, usize, u32),
}

impl Wish {
    fn read(arguments: &[String]) -> Result<Self, String> {
        let [mode, part, scene, candidate, value] = arguments else {
            return Ok(Wish::Table(arguments.to_vec()));
        };
        if mode != "--count" {
            return Ok(Wish::Table(arguments.to_vec()));
        }
        let number = |text: &str| text.parse::<u32>().map_err(|error| error.to_string());
        let candidate = number(candidate)? as usize;
        Ok(Wish::Count(
            part.clone(),
            scene.clone(),
            candidate,
            number(value)?,
        ))
    }

    fn includes(&self, part: &str, scene: &str) -> bool {
        match self {
            Wish::Table(wanted) => wanted.is_empty() || wanted.iter().any(|name| name == scene),
            Wish::Count(of, name, ..) => of == part && name == scene,
        }
    }
}

/// The rival and ours on a scene with bar angles.
fn against_symbolic<M, S, E, const A: usize, const Q: usize, const N: usize, const R: usize>(
    scene: &Scene,
    mechanism: M,
    branch: fn(f64) -> Branch,
    angles: fn(f64) -> [f64; A],
    steps: Steps,
    wish: &Wish,
    file: &mut File,
) -> Result<(), String>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
    E: Equations<A>,
{
    if !wish.includes("symbolic", scene.name) {
        return Ok(());
    }
    let course = Course {
        scene,
        duration: DURATION,
        branch: branch(DURATION),
        steps,
    };
    let bare = Bare::new(mechanism)?;
    let mut candidates = trial::candidates::<E, A>(angles(DURATION), steps);
    candidates.extend(course.accuracies());
    candidates.extend(bare.given_steps(&course));
    candidates.extend(course.tolerances());
    settle(
        "symbolic",
        scene.name,
        &BOUNDS,
        &FAMILIES,
        &candidates,
        wish,
        file,
    )
}

/// An accuracy and Baumgarte's terms on a scene.
fn against_stabilised<M, S, const Q: usize, const N: usize, const R: usize>(
    scene: &Scene,
    mechanism: M,
    columns: &'static [&'static str],
    pull: [f64; Q],
    wish: &Wish,
    file: &mut File,
) -> Result<(), String>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    if !wish.includes("stabilised", scene.name) {
        return Ok(());
    }
    let table = reference(scene)?.ok_or_else(|| format!("{}: without a reference", scene.name))?;
    let course = Course {
        scene,
        duration: scene.duration,
        branch: Branch::Reference(table, columns),
        steps: FINE,
    };
    let mut bare = Bare::new(mechanism)?;
    bare.pull = pull;
    let mut candidates = course.accuracies();
    candidates.extend(bare.stabilised(&course, &GAINS));
    let bounds = &STABILISED_BOUNDS;
    settle(
        "stabilised",
        scene.name,
        bounds,
        &STABILISED,
        &candidates,
        wish,
        file,
    )
}

/// The table of a scene, or one run of it.
fn settle(
    part: &str,
    scene: &str,
    bounds: &[f64],
    families: &[&'static str],
    candidates: &[Candidate],
    wish: &Wish,
    file: &mut File,
) -> Result<(), String> {
    if let Wish::Count(_, _, candidate, value) = wish {
        let candidate = candidates.get(*candidate).ok_or("no such candidate")?;
        println!("{:.5} ms", 1e3 * (candidate.time)(*value));
        return Ok(());
    }
    let contest = Contest {
        scene,
        part,
        bounds,
        families,
        candidates,
    };
    contest.hold(file)
}

/// Compares the tips of the cranks with those of the generated equations after a while, and the energy at any angles.
fn same_motion<E: Equations<A>, const A: usize>(
    scene: &Scene,
    tips: impl Fn(&[f64; A]) -> Vec<(String, [f64; 2])>,
    wish: &Wish,
) -> Result<(), String> {
    if let Wish::Count(..) = wish {
        return Ok(());
    }
    let (time, steps, allowed) = COMPARED;
    let failed = |error| format!("{}: {error}", scene.name);
    let settings = Settings {
        step: 1e-3,
        ..Settings::accuracy(1e-11)
    };
    let mut simulation: Box<dyn AnySimulation> = (scene.build)(&[], settings).map_err(failed)?;
    simulation.run_until(time).map_err(failed)?;
    let angles = trial::after::<E, A>(time, steps);
    let points = simulation.points();
    let mut off: f64 = 0.0;
    for (name, [x, y]) in tips(&angles) {
        let known = simulation
            .model()
            .points
            .iter()
            .position(|known| without_brackets(known) == name);
        let point = known.map(|index| points[index]);
        let point = point.ok_or_else(|| format!("{}: no point {name}", scene.name))?;
        let away = (point[0] - x).hypot(point[1] - y);
        if !(away <= allowed) {
            return Err(format!("{}: {name} is {away:e} m away", scene.name));
        }
        off = off.max(away);
    }
    let power = trial::power::<E, A>();
    if !(power <= LOST) {
        return Err(format!("{}: {power:e} W in a free motion", scene.name));
    }
    println!(
        "{}: the same motion to {off:.1e} m, energy kept to {power:.1e} W",
        scene.name
    );
    Ok(())
}

/// Tips of the cranks of a chain.
fn tips<const N: usize>(angles: &[f64; N]) -> Vec<(String, [f64; 2])> {
    let cranks = angles.iter().step_by(2).enumerate();
    cranks
        .map(|(i, angle)| {
            let tip = [i as f64 + angle.cos(), angle.sin()];
            (format!("crank{i}.b"), tip)
        })
        .collect()
}

/// The angles of a chain of parallelograms.
fn parallelograms<const L: usize, const N: usize>(time: f64) -> [f64; N] {
    let crank = exact::cranks(L, time);
    std::array::from_fn(|bar| if bar % 2 == 0 { crank } else { 0.0 })
}

fn main() -> Result<(), String> {
    let recorder = Recorder::new("cargo run --release -p mbs-examples --example symbolic")?;
    let wish = &Wish::read(&recorder.arguments)?;
    let file = &mut recorder.file("symbolic.csv", &COLUMNS, KEYS)?;
    let stabilised = &mut recorder.file("stabilised.csv", &COLUMNS, KEYS)?;
    same_motion::<SliderCrank, 2>(
        &scenes::slider_crank::SCENE,
        |[crank, rod]| {
            let tip = [crank.cos(), crank.sin()];
            let end = [tip[0] + rod.cos(), tip[1] + rod.sin()];
            vec![("crank.b".to_owned(), tip), ("rod.b".to_owned(), end)]
        },
        wish,
    )?;
    same_motion::<Chain<2, 5>, 5>(&scenes::double_four_bar::SCENE, tips, wish)?;
    same_motion::<Chain<10, 21>, 21>(&scenes::four_bar_10::SCENE, tips, wish)?;
    same_motion::<Chain<40, 81>, 81>(&scenes::four_bar_40::SCENE, tips, wish)?;

    against_symbolic::<_, _, SliderCrank, 2, _, _, _>(
        &scenes::slider_crank::SCENE,
        scenes::slider_crank::SliderCrank::default(),
        |time| Branch::SliderCrank(exact::slider_crank(time)),
        |time| [exact::slider_crank(time), -exact::slider_crank(time)],
        FINE,
        wish,
        file,
    )?;
    against_symbolic::<_, _, Chain<2, 5>, 5, _, _, _>(
        &scenes::double_four_bar::SCENE,
        scenes::double_four_bar::DoubleFourBar::default(),
        |time| Branch::Cranks(exact::cranks(2, time)),
        parallelograms::<2, 5>,
        FINE,
        wish,
        file,
    )?;
    against_symbolic::<_, _, Chain<10, 21>, 21, _, _, _>(
        &scenes::four_bar_10::SCENE,
        scenes::four_bar_10::FourBar10::default(),
        |time| Branch::Cranks(exact::cranks(10, time)),
        parallelograms::<10, 21>,
        FINE,
        wish,
        file,
    )?;
    against_symbolic::<_, _, Chain<40, 81>, 81, _, _, _>(
        &scenes::four_bar_40::SCENE,
        scenes::four_bar_40::FourBar40::default(),
        |time| Branch::Cranks(exact::cranks(40, time)),
        parallelograms::<40, 81>,
        COARSE,
        wish,
        file,
    )?;

    against_stabilised(
        &scenes::slider_crank::SCENE,
        scenes::slider_crank::SliderCrank::default(),
        &["p1x_m", "p1y_m", "p2x_m"],
        std::array::from_fn(|_| 0.0),
        wish,
        stabilised,
    )?;
    against_stabilised(
        &scenes::double_four_bar::SCENE,
        scenes::double_four_bar::DoubleFourBar::default(),
        &["b0x_m", "b0y_m"],
        std::array::from_fn(|_| 0.0),
        wish,
        stabilised,
    )?;
    // The work of the motor; the crank is the first coordinate.
    let andrews = scenes::andrews::Andrews::default();
    let mut pull = std::array::from_fn(|_| 0.0);
    pull[0] = andrews.motor;
    against_stabilised(
        &scenes::andrews::SCENE,
        andrews,
        &[
            "gamma_rad",
            "phi_rad",
            "delta_rad",
            "omega_rad",
            "epsilon_rad",
        ],
        pull,
        wish,
        stabilised,
    )?;
    against_stabilised(
        &scenes::bricard::SCENE,
        scenes::bricard::Bricard::default(),
        &["p3x_m", "p3y_m", "p3z_m", "p2x_m", "p2z_m", "p5y_m"],
        std::array::from_fn(|_| 0.0),
        wish,
        stabilised,
    )
}
