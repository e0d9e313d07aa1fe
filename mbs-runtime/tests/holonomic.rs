//! Constant mass, holonomic rows: energy, order, reversal, drift, references.

mod common;

use common::planar::{FourBar, SliderCrank};
use common::{Hand, Parameters, Scene};
use mbs_runtime::{Settings, Simulation};

fn run<T: Scene<N, R>, const N: usize, const R: usize>(
    scene: T,
    step: f64,
    time: f64,
) -> Simulation<Hand<T, N, R>, N, R> {
    let settings = Settings {
        step,
        ..Settings::default()
    };
    let mut simulation = Simulation::with_settings(Parameters(scene), settings).unwrap();
    simulation.run_until(time).unwrap();
    println!("h = {step}: {:?}", simulation.report());
    simulation
}

#[test]
fn slider_crank_keeps_its_energy_through_singular_poses() {
    let report = run(SliderCrank, 1e-3, 10.0).report();
    assert!(report.energy_error < 3e-4, "{report:?}");
    assert!(
        report.holonomic_error < 1e-12 && report.velocity_error < 1e-10,
        "{report:?}"
    );
}

#[test]
fn double_four_bar_keeps_its_energy_through_singular_poses() {
    let fine = run(FourBar, 1e-3, 10.0).report();
    assert!(fine.energy_error < 6e-4, "{fine:?}");
    assert!(
        fine.holonomic_error < 1e-12 && fine.velocity_error < 1e-10,
        "{fine:?}"
    );
    let coarse = run(FourBar, 1e-2, 10.0).report();
    assert!(coarse.energy_error < 6e-2, "{coarse:?}");
}
