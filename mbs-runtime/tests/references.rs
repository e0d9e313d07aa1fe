//! Trajectories and forces against the reference data.

use crate::common::planar::{FortyFourBars, FourBar, SliderCrank};
use crate::common::scenes::{Shaken, Sleigh, SliderCrankAngles};
use crate::common::{Hand, Parameters, Scene};
use mbs_runtime::{Settings, Simulation};

/// The instants and a column of a table in `tests/reference` of the repository; a missing table or column is a failure.
fn reference(name: &str, column: &str) -> Vec<[f64; 2]> {
    let path = format!(
        "{}/../tests/reference/{name}.csv",
        env!("CARGO_MANIFEST_DIR")
    );
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let header = lines.next().expect("a header");
    let [time, value] = ["time_s", column].map(|wanted| {
        let index = header.iter().position(|other| *other == wanted);
        index.unwrap_or_else(|| panic!("no column `{wanted}` in {header:?}"))
    });
    let row = |cells: Vec<&str>| [time, value].map(|index| cells[index].parse().expect("a number"));
    lines.map(row).collect()
}

/// The largest deviation of a quantity from its reference, up to `until`.
fn deviation<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    step: f64,
    until: f64,
    reference: &[[f64; 2]],
    quantity: impl Fn(&Simulation<Hand<T, Q, N, R>, Q, N, R>) -> f64,
) -> f64 {
    let settings = Settings {
        step,
        ..Settings::default()
    };
    let mut simulation = Simulation::with_settings(Parameters(scene), settings).unwrap();
    let mut worst: f64 = 0.0;
    let mut compared = 0;
    for [time, value] in reference.iter().take_while(|row| row[0] <= until + 1e-9) {
        simulation.run_until(*time).unwrap();
        worst = worst.max((quantity(&simulation) - value).abs());
        compared += 1;
    }
    assert!(compared > 2, "only {compared} values were compared");
    worst
}

#[test]
fn slider_crank_follows_the_reference_through_singular_poses() {
    let pin = reference("slider_crank_singular_gravity", "p1x_m");
    let [coarse, fine] = [1e-3, 5e-4].map(|step| {
        deviation(SliderCrank, step, 10.0, &pin, |simulation| {
            simulation.positions()[0]
        })
    });
    println!("slider-crank: {coarse:e} {fine:e}");
    assert!(coarse < 1e-3 && coarse / fine > 3.5, "{coarse:e} {fine:e}");
    let angles = deviation(SliderCrankAngles, 1e-3, 10.0, &pin, |s| {
        s.positions()[0].cos()
    });
    println!("in angles: {angles:e}");
    assert!(angles < 1e-3, "{angles:e}");
}

#[test]
fn reactions_agree_with_the_reference() {
    let force = reference("slider_crank_singular_gravity", "guide_on_slider_fy_N");
    let worst = deviation(SliderCrank, 1e-4, 0.35, &force, |simulation| {
        let reactions = simulation.reactions().unwrap();
        assert!(reactions.unique);
        reactions.multipliers[2]
    });
    println!("guide force: {worst:e} N");
    assert!(worst < 1e-4, "{worst:e}");
}

#[test]
fn double_four_bar_follows_the_reference() {
    let bar = reference("a02_four_bar_n2", "b0x_m");
    let [coarse, fine] =
        [1e-3, 5e-4].map(|step| deviation(FourBar, step, 10.0, &bar, |s| s.positions()[0]));
    println!("double four-bar: {coarse:e} {fine:e}");
    assert!(coarse < 1e-3 && coarse / fine > 3.5, "{coarse:e} {fine:e}");
}

#[test]
fn forty_four_bars_follow_the_reference() {
    let bar = reference("a02_four_bar_n40_lim", "b0x_m");
    // Unoptimised code copies large values from frame to frame; the stack of a test thread is 2 MiB.
    let run = move || deviation(FortyFourBars, 2.5e-3, 0.4, &bar, |s| s.positions()[0]);
    let thread = std::thread::Builder::new().stack_size(16 << 20);
    let worst = thread.spawn(run).unwrap().join().unwrap();
    println!("forty four-bars: {worst:e}");
    assert!(worst < 1e-4, "{worst:e}");
}

#[test]
fn sleigh_follows_the_closed_form() {
    let edge = reference("chaplygin_sleigh", "edge_x_m");
    let guess = ([0.35, 0.0, 0.0], [-1.2, 0.35 * 0.6, 0.6]);
    let sleigh = Sleigh {
        mass: 3.0,
        inertia: 0.8,
        a: 0.35,
        guess,
        drag: 0.0,
    };
    let [coarse, fine] = [1e-2, 5e-3].map(|step| {
        deviation(sleigh.clone(), step, 10.0, &edge, |s| {
            s.positions()[0] - sleigh.a * s.positions()[2].cos()
        })
    });
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
