//! Radau IIA: order 5 with every kind of rows, its works, and what it shares with the other methods.

use crate::common::alloc::count;
use crate::common::planar::{DampedSliderCrank, Doubled};
use crate::common::scenes::{DampedSleigh, Shaken, SliderCrankAngles};
use crate::common::spatial::Sprung;
use crate::common::{Parameters, Scene, distance};
use crate::composition::Run;
use mbs_runtime::{Method, RankLoss, Settings, Simulation, SimulationError, mechanism, methods};

fn settings(step: f64) -> Settings {
    Settings {
        method: Method::Radau,
        step,
        placement: false,
        ..Settings::default()
    }
}

fn run<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    settings: Settings,
    time: f64,
) -> Run<T, Q, N, R> {
    let parameters = Parameters(scene);
    let simulation = Simulation::with_methods(parameters, settings, methods::Radau);
    let mut simulation = simulation.unwrap();
    simulation.run_until(time).unwrap();
    simulation
}

fn has_its_slope<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    time: f64,
    h: f64,
) {
    let fine = run(scene.clone(), settings(h / 8.0), time);
    let error = |h: f64| {
        let end = run(scene.clone(), settings(h), time);
        distance(end.positions(), fine.positions())
    };
    let (coarse, half) = (error(h), error(h / 2.0));
    let slope = (coarse / half).log2();
    println!("h = {h}: {coarse:.2e} {half:.2e}, slope {slope:.2}");
    assert!((slope - 5.0).abs() < 0.5, "{slope}");
}

#[test]
fn holonomic_rows_have_the_slope() {
    has_its_slope(DampedSliderCrank, 0.2, 0.04);
}

#[test]
fn nonholonomic_rows_have_the_slope() {
    has_its_slope(DampedSleigh::default(), 2.0, 0.2);
}

#[test]
fn mass_that_depends_on_positions_has_the_slope() {
    has_its_slope(SliderCrankAngles, 0.2, 0.02);
}

#[test]
fn rotations_have_the_slope() {
    let soft = Sprung::<true> {
        stiffness: 100.0,
        damping: 1.0,
        ..Sprung::default()
    };
    has_its_slope(soft, 0.4, 0.04);
}

/// It agrees with the two-level method, which has other equations for its steps.
#[test]
fn other_methods_have_the_same_limit() {
    let end = run(DampedSliderCrank, settings(5e-3), 0.2);
    let other = crate::composition::run(
        DampedSliderCrank,
        crate::composition::settings(8, 1e-2),
        0.2,
    );
    let apart = distance(end.positions(), other.positions());
    assert!(apart < 1e-10, "{apart:e}");
}

/// Works of dampers and drives have the order of the motion.
#[test]
fn works_have_the_slope() {
    let lost = |h: f64| {
        let end = run(DampedSleigh::default(), settings(h), 2.0);
        assert!(end.energy().nonconservative_work < -0.1);
        end.energy().error.abs()
    };
    let slope = (lost(0.2) / lost(0.1)).log2();
    assert!((slope - 5.0).abs() < 0.8, "{slope}");
    let driven = |h: f64| run(Shaken, settings(h), 1.0).energy().error.abs();
    let slope = (driven(0.05) / driven(0.025)).log2();
    assert!(slope > 4.0, "{slope}");
}

/// Stiff forces are damped as they are in the limit: a step is as long as the slow motion allows.
#[test]
fn stiff_dampers_allow_long_steps() {
    let stiff = || Sprung::<true> {
        stiffness: 1e8,
        damping: 1e6,
        ..Sprung::default()
    };
    let end = |h: f64| run(stiff(), settings(h), 0.4);
    let fine = end(1e-4);
    for h in [0.04, 0.01, 2.5e-3, 6.25e-4] {
        let apart = distance(end(h).positions(), fine.positions());
        assert!(apart < 3e-5, "{h}: {apart:e}");
    }
}

#[test]
fn rows_hold() {
    let report = run(DampedSliderCrank, settings(0.02), 0.5).report();
    assert!(report.holonomic_error < 1e-12, "{report:?}");
    assert!(report.velocity_error < 1e-11, "{report:?}");
}

#[test]
fn redundant_rows_are_left_out() {
    let end = run(Doubled, settings(0.01), 0.5);
    let error = end.energy().error.abs();
    assert!(error < 1e-6, "{error:e}");
    assert!(end.report().holonomic_error < 1e-11);
}

/// They are passed on the branch of the motion, and listed.
#[test]
fn singular_poses_are_passed() {
    let end = run(DampedSliderCrank, settings(1e-2), 10.0);
    let other = Settings {
        placement: true,
        ..crate::composition::settings(8, 1e-2)
    };
    let other = crate::composition::run(DampedSliderCrank, other, 10.0);
    let apart = distance(end.positions(), other.positions());
    assert!(apart < 1e-4, "{apart:e}");
    let times = |losses: &[RankLoss]| losses.iter().map(|loss| loss.time).collect::<Vec<_>>();
    let (found, expected) = (times(end.rank_losses()), times(other.rank_losses()));
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-4, "{found} for {expected}");
    }
}

#[test]
fn a_tolerance_chooses_the_steps() {
    let end = |tolerance: f64| {
        let settings = Settings {
            tolerance: Some(tolerance),
            ..settings(1e-2)
        };
        run(DampedSleigh::default(), settings, 2.0)
    };
    let fine = end(1e-11);
    let mut last = None;
    for tolerance in [1e-4, 1e-6, 1e-8] {
        let end = end(tolerance);
        let apart = distance(end.positions(), fine.positions());
        let report = end.report();
        println!("{tolerance:e}: {apart:.1e}, {report:?}");
        assert!(apart < 3.0 * tolerance, "{tolerance:e}: {apart:e}");
        // Of order 5: 2.5 times as many for a hundredth of the error.
        let most = last.map_or(f64::INFINITY, |last| 3.5 * last);
        assert!((report.steps as f64) < most, "{report:?}");
        last = Some(report.steps as f64);
        // The embedded formula sees most pairs, a comparison the others.
        let kept = 3 * report.steps;
        assert!(10 * (report.stages - kept) < 3 * kept, "{report:?}");
    }
}

mechanism!(Disk {
    doc: "A disk that rolls on a plane and leans: its rows turn with it.",
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    lean: Let(0.2_rad),
    upward: Let([0.0, -sin(lean), cos(lean)]),
    omega: Let([0.0, -5.0 * cos(lean), 1.2 - 5.0 * sin(lean)] * 1.0_rad_per_s),
    disk: Body(
        mass = 2.5_kg,
        inertia = diag(0.1, 0.2, 0.1),
        at = [0.0, 0.0, 0.4_m * cos(lean)],
        orientation = turn(X, lean),
        velocity = cross(omega, 0.4_m * upward),
        angular_velocity = omega
    ),
    down: Let(-unit(reject(ground.z, disk.y))),
    contact: Let(disk.origin + 0.4_m * down),
    slip: Let(disk.velocity_at(contact)),
    touch: Holonomic(dot(contact, ground.z)),
    no_slip: Nonholonomic([dot(slip, ground.x), dot(slip, ground.y)]),
});

/// Corrections that end too early would add up.
#[test]
fn many_short_steps_have_no_error() {
    let end = |method: Method, order: u8, step: f64| {
        let settings = Settings {
            method,
            order,
            ..settings(step)
        };
        let mut simulation = Simulation::with_any_method(Disk {}, settings).unwrap();
        simulation.run_until(4.0).unwrap();
        *simulation.positions()
    };
    let exact = end(Method::Projected, 8, 1e-2);
    for (step, most) in [(2e-2, 2e-7), (5e-3, 2e-9), (1.25e-3, 2e-9), (2.5e-4, 4e-9)] {
        let apart = distance(&end(Method::Radau, 2, step), &exact);
        println!("{step}: {apart:.1e}");
        assert!(apart < most, "{step}: {apart:e}");
    }
}

#[test]
fn it_has_an_order_of_its_own() {
    let settings = Settings {
        order: 4,
        ..settings(1e-2)
    };
    let refused =
        Simulation::with_methods(Parameters(DampedSliderCrank), settings, methods::Radau).err();
    assert!(
        matches!(refused, Some(SimulationError::Order { order: 4, .. })),
        "{refused:?}"
    );
}

#[test]
fn a_step_allocates_nothing() {
    let paced = Settings {
        tolerance: Some(1e-6),
        ..settings(1e-2)
    };
    for settings in [settings(1e-2), paced] {
        let parameters = Parameters(DampedSliderCrank);
        let mut simulation =
            Simulation::with_methods(parameters, settings, methods::Radau).unwrap();
        let before = count();
        simulation.run_until(1.0).unwrap();
        assert_eq!(count() - before, 0, "{settings:?}");
    }
}
