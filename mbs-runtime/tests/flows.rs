//! Every kind of structure: the flow chosen, order of convergence, reversal, energy.

use crate::common::planar::{FourBar, SliderCrank};
use crate::common::scenes::*;
use crate::common::{Hand, Parameters, Scene, distance};
use mbs_runtime::{Flow, Settings, Simulation, State};

type Run<T, const Q: usize, const N: usize, const R: usize> = Simulation<Hand<T, Q, N, R>, Q, N, R>;

fn start<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    step: f64,
) -> Run<T, Q, N, R> {
    Simulation::with_settings(
        Parameters(scene),
        Settings {
            step,
            ..Settings::default()
        },
    )
    .unwrap()
}

fn run<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    step: f64,
    time: f64,
) -> Run<T, Q, N, R> {
    let mut simulation = start(scene, step);
    simulation.run_until(time).unwrap();
    println!(
        "{} h = {step}: {:?}",
        simulation.flow().name(),
        simulation.report()
    );
    simulation
}

/// The ratio of differences of three runs with steps h, h/2, h/4: 4 at second order.
fn order_ratio<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    step: f64,
    time: f64,
) -> f64 {
    let [a, b, c] =
        [1.0, 2.0, 4.0].map(|divisor| *run(scene.clone(), step / divisor, time).positions());
    let ratio = distance(&a, &b) / distance(&b, &c);
    println!(
        "differences {:e} {:e}, ratio {ratio}",
        distance(&a, &b),
        distance(&b, &c)
    );
    ratio
}

/// Forward, velocities reversed, back: the distance from where it began.
fn reversal<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    step: f64,
    time: f64,
) -> f64 {
    let forward = run(scene.clone(), step, time);
    let back = State::new(0.0, *forward.positions(), forward.velocities().map(|v| -v));
    let settings = Settings {
        step,
        ..Settings::default()
    };
    let mut simulation = Simulation::resume(Parameters(scene.clone()), settings, back).unwrap();
    simulation.run_until(time).unwrap();
    let error = distance(simulation.positions(), start(scene, step).positions());
    println!("reversal {error:e}");
    error
}

fn assert_second_order(ratio: f64) {
    assert!((3.6..4.4).contains(&ratio), "ratio {ratio}");
}

#[test]
fn flows_follow_the_structure() {
    assert_eq!(start(FourBar, 1e-3).flow(), Flow::Leapfrog);
    assert_eq!(start(Oscillator, 1e-3).flow(), Flow::Leapfrog);
    assert_eq!(start(StiffSpring(1e6), 1e-2).flow(), Flow::Trapezoid);
    assert_eq!(start(StiffSpring(1e2), 1e-2).flow(), Flow::Leapfrog);
    assert_eq!(start(SliderCrankAngles, 1e-3).flow(), Flow::Midpoint);
    assert_eq!(start(StiffPendulum::default(), 1e-2).flow(), Flow::Implicit);
}

#[test]
fn second_order() {
    assert_second_order(order_ratio(SliderCrank, 1e-2, 0.3));
    assert_second_order(order_ratio(FourBar, 1e-2, 0.5));
    assert_second_order(order_ratio(SliderCrankAngles, 1e-2, 0.3));
    assert_second_order(order_ratio(Sleigh::default(), 1e-2, 2.0));
    assert_second_order(order_ratio(DampedSleigh::default(), 1e-2, 2.0));
    assert_second_order(order_ratio(Towing, 1e-2, 2.0));
    assert_second_order(order_ratio(Oscillator, 1e-2, 2.0));
    assert_second_order(order_ratio(Shaken, 1e-2, 2.0));
    assert_second_order(order_ratio(
        StiffPendulum {
            stiffness: 1e3,
            damping: 20.0,
        },
        5e-3,
        0.5,
    ));
    assert_second_order(order_ratio(StiffSpring(1e4), 1e-3, 0.2));
}

#[test]
fn steps_are_reversible() {
    assert!(reversal(SliderCrank, 1e-3, 0.35) < 1e-9);
    assert!(reversal(FourBar, 1e-3, 1.0) < 1e-9);
    assert!(reversal(SliderCrankAngles, 1e-3, 0.35) < 1e-9);
    assert!(reversal(Sleigh::default(), 1e-2, 2.0) < 1e-9);
    assert!(reversal(Towing, 1e-2, 2.0) < 1e-9);
    assert!(reversal(Oscillator, 1e-2, 2.0) < 1e-9);
    assert!(reversal(StiffSpring(1e6), 1e-2, 0.5) < 1e-9);
}

#[test]
fn sleigh_keeps_its_energy_exactly() {
    let report = run(Sleigh::default(), 1e-2, 5.0).report();
    assert!(report.energy_error < 1e-12, "{report:?}");
}

#[test]
fn mixed_rows_keep_energy_and_constraints() {
    let report = run(Towing, 1e-3, 5.0).report();
    assert!(report.energy_error < 1e-4, "{report:?}");
    assert!(
        report.holonomic_error < 1e-10 && report.velocity_error < 1e-10,
        "{report:?}"
    );
}

#[test]
fn slider_crank_in_angles_passes_singular_poses() {
    let report = run(SliderCrankAngles, 1e-3, 10.0).report();
    assert!(report.energy_error < 4e-4, "{report:?}");
    let coarse = run(SliderCrankAngles, 2e-3, 10.0).report();
    assert_second_order(coarse.energy_error / report.energy_error);
    assert!(
        report.holonomic_error < 1e-10 && report.velocity_error < 1e-10,
        "{report:?}"
    );
}

#[test]
fn stiff_spring_takes_large_steps() {
    let report = run(StiffSpring(1e6), 1e-2, 2.0).report();
    assert!(report.iterations < 4 * report.stages, "{report:?}");
    assert!(
        report.holonomic_error < 1e-10 && report.velocity_error < 1e-10,
        "{report:?}"
    );
}

/// Error constants that do not depend on the damper.
#[test]
fn stiff_damper_costs_no_accuracy() {
    for (damping, step, bound) in [(1e3, 1e-2, 2.5e-3), (1e3, 2e-2, 1e-2), (1e5, 2e-2, 1e-2)] {
        let scene = StiffPendulum {
            stiffness: 1e6,
            damping,
        };
        let angles = |run: Run<StiffPendulum, 4, 4, 1>| {
            let q = run.positions();
            [q[1].atan2(q[0]), (q[3] - q[1]).atan2(q[2] - q[0])]
        };
        let exact = angles(run(scene.clone(), 2e-4, 1.0));
        let error = distance(&angles(run(scene, step, 1.0)), &exact);
        println!("c = {damping}, h = {step}: angle error {error:e}");
        assert!(error < bound, "c = {damping}, h = {step}: {error:e}");
    }
}

#[test]
fn the_drive_is_paid_for() {
    let [coarse, fine] = [2e-3, 1e-3].map(|step| run(Shaken, step, 2.0));
    let energy = fine.energy();
    assert!(energy.drive_work.abs() > 0.1, "{energy:?}");
    let ratio = coarse.report().energy_error / fine.report().energy_error;
    assert_second_order(ratio);
    assert!(fine.report().energy_error < 1e-3, "{:?}", fine.report());
}

#[test]
fn damping_is_paid_for() {
    let [coarse, fine] = [1e-2, 5e-3].map(|step| run(DampedSleigh::default(), step, 2.0));
    assert!(fine.energy().nonconservative_work < -0.1);
    assert_second_order(coarse.report().energy_error / fine.report().energy_error);
}
