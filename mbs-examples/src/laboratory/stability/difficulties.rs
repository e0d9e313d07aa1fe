//! Maps for a singular pose together with a second difficulty, and for others that are hard without one: by the methods
//! that a user has by default, from random poses and speeds, half of the runs whole and half in pieces.

use std::f64::consts::PI;

use super::super::methods::{Entry, entries};
use super::maps::{at_step, labels, random, uneven};
use super::{Branch, Course, Map, Problem, Trial};
use crate::scene::Scene;
use crate::scenes::passages;

/// The methods of these maps.
const METHODS: [&str; 9] = [
    "accuracy",
    "two-level 2",
    "two-level 4",
    "two-level 6",
    "two-level 8",
    "two-level tolerance",
    "projected 4",
    "projected 6",
    "projected 8",
];
const STEPS: [f64; 6] = [0.05, 0.02, 0.01, 5e-3, 2e-3, 1e-3];
/// For mechanisms of many velocities, whose steps take long.
const FEW_STEPS: [f64; 4] = [0.05, 0.02, 0.01, 5e-3];
/// For runs of 1000 s.
const LONG_STEPS: [f64; 2] = [0.02, 0.01];
const LONG: f64 = 1000.0;
/// s, where steps are not in the columns.
const STEP: f64 = 0.01;
/// For Bricard's linkage, which turns fast: the declared rate of its first link, rad/s.
const BRICARD_RATE: f64 = 20.0;
const BRICARD_STEPS: [f64; 4] = [5e-3, 2e-3, 1e-3, 5e-4];
/// N m
const PUSH: f64 = 5.0;
/// Damping of a crank, N m s: the least and the greatest.
const DAMPING: [f64; 2] = [1e-3, 0.3];
/// The same over a long run, in which a mechanism with more damping comes to rest.
const LITTLE_DAMPING: [f64; 2] = [1e-4, 1e-3];
/// Interval of interruptions, s: the least and the greatest.
const PIECE: [f64; 2] = [5e-3, 0.5];
/// Damping of the bushing, as a part of √(stiffness · mass).
const BUSHING_DAMPING: f64 = 0.1;

/// The maps. `phases`: runs of a cell.
pub(super) fn maps(phases: usize) -> Vec<Map> {
    use passages::{
        DOUBLE_FOUR_BAR, DRIVEN, IN_SPACE, IN_SPACE_BY_BODIES, ON_SLEIGH, PUSHED, REDUNDANT, ROTOR,
        SHAKEN, SLIDER_CRANK, SPHERICAL, SPHERICAL_BY_BODIES,
    };
    let starts = |scenes: &[&'static Scene], duration| starts(scenes, phases, duration);
    let long = |scenes: &[&'static Scene]| self::starts(scenes, 2, LONG);
    vec![
        by_step(
            "damped-singular",
            "Singular poses with a damper: slider-crank, double four-bar",
            &STEPS,
            damped(starts(&[&SLIDER_CRANK, &DOUBLE_FOUR_BAR], 10.0), DAMPING),
        ),
        by_step(
            "driven-singular",
            "Singular poses with a row on time: driven crank, shaken base",
            &STEPS,
            starts(&[&DRIVEN, &SHAKEN], 10.0),
        ),
        by_step(
            "knife-edge-singular",
            "Singular poses with a nonholonomic row: parallelogram on a sleigh",
            &STEPS,
            starts(&[&ON_SLEIGH], 10.0),
        ),
        by_step(
            "redundant-singular",
            "Singular poses with a redundant row: three cranks and a rod over them",
            &STEPS,
            starts(&[&REDUNDANT], 10.0),
        ),
        by_step(
            "parallelogram-in-space",
            "Singular poses in space: parallelogram, by joints and by bodies",
            &FEW_STEPS,
            starts(&[&IN_SPACE, &IN_SPACE_BY_BODIES], 10.0),
        ),
        by_step(
            "spherical-linkage",
            "Singular poses in space: spherical linkage that folds, by joints and by bodies",
            &FEW_STEPS,
            starts(&[&SPHERICAL, &SPHERICAL_BY_BODIES], 10.0),
        ),
        by_step(
            "bricard-bifurcation",
            "Bifurcation of Bricard's linkage of threefold symmetry",
            &BRICARD_STEPS,
            vec![Problem::new(&passages::THREEFOLD, 5.0).with("rate", BRICARD_RATE); phases.min(4)],
        ),
        by_step(
            "start-in-pose",
            "Start in a singular pose: double four-bar, redundant row, shaken base, in space",
            &STEPS,
            level(starts(
                &[&DOUBLE_FOUR_BAR, &REDUNDANT, &SHAKEN, &IN_SPACE],
                10.0,
            )),
        ),
        by_step(
            "rest-in-pose",
            "Start from rest in a singular pose: double four-bar, redundant row, shaken base, in space",
            &STEPS,
            at_rest(level(starts(
                &[&DOUBLE_FOUR_BAR, &REDUNDANT, &SHAKEN, &IN_SPACE],
                10.0,
            ))),
        ),
        light_links(starts(&[&PUSHED], 10.0)),
        by_step(
            "fast-rotor",
            "Rotor of 1000 rad/s on a pendulum",
            &STEPS,
            starts(&[&ROTOR], 10.0)
                .into_iter()
                .map(|problem| Problem {
                    branch: Branch::Motion,
                    ..problem
                })
                .collect(),
        ),
        by_step(
            "input-jumps",
            "Singular poses with a torque that jumps every 50 ms: double four-bar",
            &STEPS,
            starts(&[&PUSHED], 10.0)
                .into_iter()
                .map(|problem| Problem {
                    jumps: Some(("push", PUSH)),
                    ..problem
                })
                .collect(),
        ),
        stiff_bushing(starts(&[&passages::BUSHING], 10.0)),
        by_step(
            "long-damped",
            "Long run: singular poses with a damper, 1000 s",
            &LONG_STEPS,
            damped(long(&[&SLIDER_CRANK, &DOUBLE_FOUR_BAR]), LITTLE_DAMPING),
        ),
        by_step(
            "long-driven",
            "Long run: singular poses with a row on time, 1000 s",
            &LONG_STEPS,
            long(&[&DRIVEN, &SHAKEN]),
        ),
        by_step(
            "long-knife-edge",
            "Long run: singular poses with a nonholonomic row, 1000 s",
            &LONG_STEPS,
            long(&[&ON_SLEIGH]),
        ),
        by_step(
            "long-redundant",
            "Long run: singular poses with a redundant row, 1000 s",
            &LONG_STEPS,
            long(&[&REDUNDANT]),
        ),
    ]
}

/// Random poses and speeds of these scenes in turn.
fn starts(scenes: &[&'static Scene], count: usize, duration: f64) -> Vec<Problem> {
    let problem = |i: usize| {
        let rate = between([1.0, 4.0], random(i, 0.3));
        let turn = if random(i, 0.1) < 0.5 { -1.0 } else { 1.0 };
        Problem {
            branch: Branch::Output(passages::ASTRAY),
            ..Problem::new(scenes[i % scenes.len()], duration)
        }
        .with("phase", PI * (2.0 * random(i, 0.2) - 1.0))
        .with("rate", turn * rate)
    };
    (0..count).map(problem).collect()
}

/// With all bars level.
fn level(problems: Vec<Problem>) -> Vec<Problem> {
    let with = |problem: Problem| problem.with("phase", 0.0);
    problems.into_iter().map(with).collect()
}

/// From rest: nothing tells the branch.
fn at_rest(problems: Vec<Problem>) -> Vec<Problem> {
    let with = |problem: Problem| Problem {
        branch: Branch::Unknown,
        // A start beside the pose.
        measured_with: Some(("phase", 0.1)),
        ..problem.with("rate", 0.0)
    };
    problems.into_iter().map(with).collect()
}

/// With random damping between two values.
fn damped(problems: Vec<Problem>, range: [f64; 2]) -> Vec<Problem> {
    let with =
        |(i, problem): (usize, Problem)| problem.with("damping", between(range, random(i, 0.7)));
    problems.into_iter().enumerate().map(with).collect()
}

/// The part `part` of the way from the least to the greatest value, by factors.
fn between([least, greatest]: [f64; 2], part: f64) -> f64 {
    least * (greatest / least).powf(part)
}

/// Every scene of a map has runs of both kinds.
fn course(run: usize) -> Course {
    match (run + run / 2) % 2 {
        0 => Course::Whole,
        _ => Course::Pieces(between(PIECE, random(run, 0.2))),
    }
}

fn methods() -> Vec<Entry> {
    let mut entries = entries();
    entries.retain(|entry| METHODS.contains(&entry.label));
    entries
}

fn by_step(name: &'static str, title: &'static str, steps: &[f64], problems: Vec<Problem>) -> Map {
    let steps = steps.to_vec();
    let columns = steps.clone();
    map(
        name,
        title,
        "step, s (with error control: tolerance = (step / 1 s)²)",
        columns,
        move |column| {
            let step = steps[column];
            problems
                .iter()
                .map(|problem| (problem.clone(), step))
                .collect()
        },
    )
}

/// A map with problems and steps of each column.
fn map(
    name: &'static str,
    title: &'static str,
    axis: &'static str,
    columns: Vec<f64>,
    problems: impl Fn(usize) -> Vec<(Problem, f64)> + 'static,
) -> Map {
    let entries = methods();
    Map {
        name,
        title,
        axis,
        rows: labels(&entries),
        columns,
        trials: Box::new(move |row, column| {
            let trial = |(run, (problem, step)): (usize, (Problem, f64))| Trial {
                settings: at_step(&entries[row], &problem, uneven(step, run)),
                problem,
                course: course(run),
            };
            problems(column)
                .into_iter()
                .enumerate()
                .map(trial)
                .collect()
        }),
    }
}

fn light_links(problems: Vec<Problem>) -> Map {
    let masses = [1.0, 1e-2, 1e-4, 1e-6, 1e-8, 1e-12, 0.0];
    map(
        "light-links",
        "Singular poses with light couplers between cranks of 1 kg, step 0.01 s",
        "mass of a coupler, kg",
        masses.to_vec(),
        move |column| {
            let with = |problem: &Problem| {
                let problem = problem.clone().with("coupler_mass", masses[column]);
                (problem, STEP)
            };
            problems.iter().map(with).collect()
        },
    )
}

fn stiff_bushing(problems: Vec<Problem>) -> Map {
    let ratios: Vec<f64> = (-2..=4).map(|e| 10_f64.powi(e)).collect();
    map(
        "stiff-bushing",
        "Stiff bushing in space, with and without damping, step 0.01 s",
        "ω h, with ω² = stiffness / mass",
        ratios.clone(),
        move |column| {
            let with = |(run, problem): (usize, &Problem)| {
                let frequency = ratios[column] / STEP;
                let damping = if run % 2 == 0 { 0.0 } else { BUSHING_DAMPING };
                let problem = Problem {
                    branch: Branch::Unknown,
                    // One vibration takes 2π steps: the slow motion is the same.
                    measured_with: Some(("stiffness", STEP.powi(-2))),
                    ..problem.clone()
                };
                let problem = problem
                    .with("stiffness", frequency * frequency)
                    .with("damping", damping * frequency);
                (problem, STEP)
            };
            problems.iter().enumerate().map(with).collect()
        },
    )
}
