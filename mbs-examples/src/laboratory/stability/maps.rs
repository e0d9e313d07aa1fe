//! The maps, each for one difficulty at which methods are said to fail.

use mbs_runtime::{Method, PaperSettings, PenaltySettings, ProjectionSettings, Settings};

use super::super::methods::{Control, Entry, entries, entry};
use super::{Branch, Course, Map, Problem, Trial, difficulties};
use crate::scene::Scene;
use crate::scenes::{laboratory, scenes};

/// Maps that take too long for the quick form, beside the long runs.
const SLOW: [&str; 5] = [
    "redundant-bodies",
    "bricard-bifurcation",
    "spherical-linkage",
    "stiff-bushing",
    "rest-in-pose",
];

/// A scene of the list.
fn listed(name: &str) -> &'static Scene {
    let scene = scenes().iter().find(|scene| scene.name == name);
    scene.expect("the scenes of the maps are listed")
}

/// All maps; the quick form has fewer columns and phases.
pub fn maps(quick: bool) -> Vec<Map> {
    let phases = if quick { 2 } else { 8 };
    let mut maps = vec![
        by_step(
            "singular-slider-crank",
            "Singular poses: slider-crank, random phases",
            &[0.1, 0.05, 0.02, 0.01, 5e-3, 2e-3, 1e-3],
            slider_cranks(phases),
        ),
        by_step(
            "singular-double-four-bar",
            "Singular poses: double four-bar, random phases",
            &[0.1, 0.05, 0.02, 0.01, 5e-3, 2e-3, 1e-3],
            double_four_bars(phases),
        ),
        by_step(
            "redundant-joint",
            "Redundant rows: Bricard's mechanism, 5 coordinates and 5 rows",
            &[0.2, 0.1, 0.05, 0.02, 0.01, 5e-3],
            vec![Problem::new(listed("bricard"), 10.0)],
        ),
        by_step(
            "redundant-bodies",
            "Redundant rows: Bricard's mechanism, 30 velocities and 30 rows",
            &[0.1, 0.05, 0.02, 0.01],
            vec![Problem::new(listed("bricard-reference"), 5.0)],
        ),
        by_step(
            "near-singular",
            "Nearly singular: a parallelogram 1e-6 off",
            &[0.01, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5],
            vec![Problem::new(&laboratory::NEAR_PARALLELOGRAM, 2.0)],
        ),
        mass_ratio(),
        stiff_spring(),
        by_step(
            "long-pendulum",
            "Long run: pendulum, 2000 s",
            &[0.1, 0.05, 0.02, 0.01, 5e-3],
            vec![Problem::new(listed("pendulum"), 2000.0)],
        ),
        by_step(
            "long-double-four-bar",
            "Long run: double four-bar, 1000 s",
            &[0.05, 0.02, 0.01, 5e-3],
            vec![Problem::new(listed("double-four-bar"), 1000.0)],
        ),
        penalties(),
        mass_scales(),
    ];
    maps.extend(difficulties::maps(phases));
    if quick {
        maps.retain(|map| !map.name.starts_with("long") && !SLOW.contains(&map.name));
        for map in &mut maps {
            thin(map);
        }
    }
    maps
}

/// Every third column.
fn thin(map: &mut Map) {
    let all = std::mem::take(&mut map.columns);
    map.columns = all.into_iter().step_by(3).collect();
    let trials = std::mem::replace(&mut map.trials, Box::new(|_, _| Vec::new()));
    map.trials = Box::new(move |row, column| trials(row, 3 * column));
}

/// A map over steps. Methods that choose their steps have tolerances in the same columns.
fn by_step(name: &'static str, title: &'static str, steps: &[f64], problems: Vec<Problem>) -> Map {
    let columns = steps.to_vec();
    let entries = entries();
    Map {
        name,
        title,
        axis: "step, s (with error control: tolerance = (step / 1 s)²)",
        rows: labels(&entries),
        columns: columns.clone(),
        trials: Box::new(move |row, column| {
            let trial = |(phase, problem): (usize, &Problem)| Trial {
                settings: at_step(&entries[row], problem, uneven(columns[column], phase)),
                problem: problem.clone(),
                course: Course::Instants,
            };
            problems.iter().enumerate().map(trial).collect()
        }),
    }
}

pub(super) fn labels(entries: &[Entry]) -> Vec<String> {
    entries.iter().map(|entry| entry.label.to_owned()).collect()
}

pub(super) fn at_step(entry: &Entry, problem: &Problem, step: f64) -> Settings {
    let control = match entry.control {
        Control::Step => step,
        Control::Tolerance | Control::Accuracy => step * step,
    };
    // Settings with the unit of a frequency are those of ten seconds, for runs of any duration.
    let mut settings = entry.settings(problem.duration.min(10.0), control);
    if entry.control != Control::Step {
        settings.step = settings.step.min(0.1);
    }
    settings
}

/// Steps within 10 % of the given one, so that singular poses are at different positions within a step. The first is
/// the step itself.
pub(super) fn uneven(step: f64, phase: usize) -> f64 {
    step * (0.9 + 0.2 * random(phase, 0.5))
}

/// Evenly spread over [0, 1): multiples of the golden section.
pub(super) fn random(i: usize, start: f64) -> f64 {
    (start + 0.618_033_988_749_895 * i as f64).fract()
}

fn slider_cranks(phases: usize) -> Vec<Problem> {
    let problem = |i| {
        let start = (25.0 + 40.0 * random(i, 0.5)).to_radians();
        Problem::new(listed("slider-crank"), 10.0).with("start", start)
    };
    (0..phases).map(problem).collect()
}

fn double_four_bars(phases: usize) -> Vec<Problem> {
    let problem = |i| {
        let turning = -0.6 - 0.8 * random(i, 0.5);
        Problem::new(listed("double-four-bar"), 10.0).with("turning", turning)
    };
    (0..phases).map(problem).collect()
}

fn mass_ratio() -> Map {
    let columns: Vec<f64> = (-6..=6).step_by(2).map(|e| 10_f64.powi(e)).collect();
    let ratios = columns.clone();
    let entries = entries();
    Map {
        name: "mass-ratio",
        title: "Mass of the rod over that of the crank, step 0.01 s",
        axis: "ratio of masses",
        rows: labels(&entries),
        columns,
        trials: Box::new(move |row, column| {
            let problem =
                Problem::new(&laboratory::UNEQUAL_MASSES, 10.0).with("rod_mass", ratios[column]);
            let settings = at_step(&entries[row], &problem, 0.01);
            vec![Trial {
                problem,
                settings,
                course: Course::Instants,
            }]
        }),
    }
}

fn stiff_spring() -> Map {
    const STEP: f64 = 0.01;
    let columns: Vec<f64> = (-2..=4).map(|e| 10_f64.powi(e)).collect();
    let stiffnesses = columns.clone();
    let entries = entries();
    Map {
        name: "stiff-spring",
        title: "Stiff spring on a bar, step 0.01 s",
        axis: "ω h, with ω² = stiffness / mass",
        rows: labels(&entries),
        columns,
        trials: Box::new(move |row, column| {
            let stiffness = (stiffnesses[column] / STEP).powi(2);
            let problem = Problem {
                branch: Branch::Unknown,
                ..Problem::new(&laboratory::SPRING_PENDULUM, 10.0)
            };
            let problem = problem.with("stiffness", stiffness);
            let settings = at_step(&entries[row], &problem, STEP);
            vec![Trial {
                problem,
                settings,
                course: Course::Instants,
            }]
        }),
    }
}

/// Rows `method: scene` for mechanisms that pass singular poses, one of them with redundant rows.
fn by_scene(
    name: &'static str,
    title: &'static str,
    axis: &'static str,
    columns: Vec<f64>,
    names: &[&'static str],
    set: fn(Method, f64) -> Method,
) -> Map {
    let scenes = [
        listed("slider-crank"),
        listed("double-four-bar"),
        &laboratory::MODELS[3],
    ];
    let pairs: Vec<(Entry, &'static Scene)> = names
        .iter()
        .filter_map(|name| entry(name))
        .flat_map(|entry| scenes.map(|scene| (entry, scene)))
        .collect();
    let row = |(entry, scene): &(Entry, &Scene)| match scene.name {
        "bodies in space" => format!("{}: slider-crank in space", entry.label),
        name => format!("{}: {name}", entry.label),
    };
    let values = columns.clone();
    Map {
        name,
        title,
        axis,
        rows: pairs.iter().map(row).collect(),
        columns,
        trials: Box::new(move |row, column| {
            let (entry, scene) = pairs[row];
            let problem = Problem::new(scene, 10.0);
            let mut settings = at_step(&entry, &problem, 1e-3);
            settings.method = set(settings.method, values[column]);
            vec![Trial {
                problem,
                settings,
                course: Course::Instants,
            }]
        }),
    }
}

fn penalties() -> Map {
    by_scene(
        "penalty",
        "Constant penalties, step 0.001 s",
        "penalty, in the unit of each method",
        (0..=14).step_by(2).map(|e| 10_f64.powi(e)).collect(),
        &["alf3f-paper", "m-alf", "index3-projections", "penalty"],
        |method, value| match method {
            Method::Paper(settings) => Method::Paper(PaperSettings {
                penalty: value,
                max_penalty: value,
                ..settings
            }),
            Method::MAlf(settings) => Method::MAlf(PaperSettings {
                penalty: value,
                max_penalty: value,
                ..settings
            }),
            Method::Index3Projections(_) => {
                Method::Index3Projections(ProjectionSettings { penalty: value })
            }
            Method::Penalty(settings) => Method::Penalty(PenaltySettings {
                penalty: value,
                ..settings
            }),
            other => other,
        },
    )
}

fn mass_scales() -> Map {
    by_scene(
        "mass-scale",
        "Factor on the effective masses of the rows, constant penalties, step 0.001 s",
        "factor on m̄",
        (-4..=4).map(|e| 10_f64.powi(e)).collect(),
        &["alf3f-paper", "alf3f-paper 1e4"],
        |method, value| match method {
            Method::Paper(settings) => Method::Paper(PaperSettings {
                mass_scale: value,
                max_penalty: settings.penalty,
                ..settings
            }),
            other => other,
        },
    )
}
