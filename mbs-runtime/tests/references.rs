//! Trajectories and forces against the reference data, where it is there.

use crate::common::planar::{FortyFourBars, FourBar, SliderCrank};
use crate::common::scenes::{Shaken, Sleigh, SliderCrankAngles};
use crate::common::{Hand, Parameters, Scene};
use mbs_runtime::{Settings, Simulation};

/// Rows of a reference file; `None` (the test passes) where the data is not there.
fn reference(name: &str) -> Option<Vec<Vec<f64>>> {
    let path = format!(
        "{}/../../shared/reference/{name}.csv",
        env!("CARGO_MANIFEST_DIR")
    );
    let text = std::fs::read_to_string(path).ok()?;
    let parse = |line: &str| {
        line.split(',')
            .map(|value| value.parse().unwrap())
            .collect()
    };
    Some(text.lines().skip(1).map(parse).collect())
}

/// The largest deviation of a quantity from a column of the reference, up to `until`.
fn deviation<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    step: f64,
    until: f64,
    rows: &[Vec<f64>],
    column: usize,
    quantity: impl Fn(&Simulation<Hand<T, Q, N, R>, Q, N, R>) -> f64,
) -> f64 {
    let settings = Settings {
        step,
        ..Settings::default()
    };
    let mut simulation = Simulation::with_settings(Parameters(scene), settings).unwrap();
    let mut worst: f64 = 0.0;
    for row in rows.iter().take_while(|row| row[0] <= until + 1e-9) {
        simulation.run_until(row[0]).unwrap();
        worst = worst.max((quantity(&simulation) - row[column]).abs());
    }
    worst
}

#[test]
fn slider_crank_follows_the_reference_through_singular_poses() {
    let Some(rows) = reference("slider_crank_singular_gravity") else {
        return;
    };
    let [coarse, fine] = [1e-3, 5e-4].map(|step| {
        deviation(SliderCrank, step, 10.0, &rows, 4, |simulation| {
            simulation.positions()[0]
        })
    });
    println!("slider-crank: {coarse:e} {fine:e}");
    assert!(coarse < 1e-3 && coarse / fine > 3.5, "{coarse:e} {fine:e}");
    let angles = deviation(SliderCrankAngles, 1e-3, 10.0, &rows, 4, |s| {
        s.positions()[0].cos()
    });
    println!("in angles: {angles:e}");
    assert!(angles < 1e-3, "{angles:e}");
}

#[test]
fn reactions_agree_with_the_reference() {
    let Some(rows) = reference("slider_crank_singular_gravity") else {
        return;
    };
    let worst = deviation(SliderCrank, 1e-4, 0.35, &rows, 15, |simulation| {
        let reactions = simulation.reactions().unwrap();
        assert!(reactions.unique);
        reactions.multipliers[2]
    });
    println!("guide force: {worst:e} N");
    assert!(worst < 1e-4, "{worst:e}");
}

#[test]
fn double_four_bar_follows_the_reference() {
    let Some(rows) = reference("a02_four_bar_n2") else {
        return;
    };
    let [coarse, fine] =
        [1e-3, 5e-4].map(|step| deviation(FourBar, step, 10.0, &rows, 3, |s| s.positions()[0]));
    println!("double four-bar: {coarse:e} {fine:e}");
    assert!(coarse < 1e-3 && coarse / fine > 3.5, "{coarse:e} {fine:e}");
}

#[test]
fn forty_four_bars_follow_the_reference() {
    let Some(rows) = reference("a02_four_bar_n40_lim") else {
        return;
    };
    // Unoptimised code copies large values from frame to frame; the stack of a test thread is 2 MiB.
    let run = move || deviation(FortyFourBars, 2.5e-3, 0.4, &rows, 3, |s| s.positions()[0]);
    let thread = std::thread::Builder::new().stack_size(16 << 20);
    let worst = thread.spawn(run).unwrap().join().unwrap();
    println!("forty four-bars: {worst:e}");
    assert!(worst < 1e-4, "{worst:e}");
}

#[test]
fn sleigh_follows_the_closed_form() {
    let Some(rows) = reference("chaplygin_sleigh") else {
        return;
    };
    let guess = ([0.35, 0.0, 0.0], [-1.2, 0.35 * 0.6, 0.6]);
    let sleigh = Sleigh {
        mass: 3.0,
        inertia: 0.8,
        a: 0.35,
        guess,
        drag: 0.0,
    };
    let [coarse, fine] = [1e-2, 5e-3]
        .map(|step| deviation(sleigh.clone(), step, 10.0, &rows, 6, |s| s.positions()[0]));
    println!("sleigh: {coarse:e} {fine:e}");
    assert!(coarse < 1e-3 && coarse / fine > 3.5, "{coarse:e} {fine:e}");
}

/// γ and reactions of a rheonomic row: the multiplier against a difference quotient of the motion.
#[test]
fn reactions_of_a_driven_row_balance_the_motion() {
    let settings = Settings {
        step: 1e-4,
        ..Settings::default()
    };
    let mut simulation = Simulation::with_settings(Parameters(Shaken), settings).unwrap();
    simulation.run_until(0.7 - 1e-4).unwrap();
    let before = *simulation.velocities();
    simulation.step().unwrap();
    let (q, lambda) = (
        *simulation.positions(),
        simulation.reactions().unwrap().multipliers[0],
    );
    simulation.step().unwrap();
    let acceleration = (simulation.velocities()[0] - before[0]) / 2e-4;
    let pivot = 0.3 * (5.0_f64 * 0.7).sin();
    let expected = 2.0 * acceleration / (q[0] - pivot);
    println!("{lambda} {expected}");
    assert!(
        (lambda - expected).abs() < 1e-4 * expected.abs(),
        "{lambda} {expected}"
    );
}
