//! Orders 6 and 8 have their slopes on scenes of every sort: varying rows, varying masses, nonholonomic rows, redundant
//! rows.

use mbs_examples::scene::Scene;
use mbs_examples::scenes::{
    bricard, chaplygin_sleigh, double_four_bar, flyball_governor, pendulum, slider_crank,
};
use mbs_runtime::Settings;

/// q after `time`, in this number of steps.
fn run(scene: &Scene, order: u8, time: f64, steps: u32) -> Vec<f64> {
    let settings = Settings {
        order,
        step: time / f64::from(steps),
        // Steps of one length, up to the first singular pose.
        placement: false,
        ..Settings::default()
    };
    let mut simulation = (scene.build)(&[], settings).expect(scene.name);
    simulation.run_until(time).expect(scene.name);
    assert_eq!(simulation.report().steps, u64::from(steps));
    simulation.coordinates()
}

/// The error falls by 2^order when the steps are halved.
fn slope(scene: &Scene, order: u8, time: f64, steps: u32) {
    let exact = run(scene, 8, time, 12 * steps);
    let error = |steps: u32| {
        let end = run(scene, order, time, steps);
        let errors = end.iter().zip(&exact).map(|(a, b)| (a - b).abs());
        errors.fold(0.0, f64::max)
    };
    let (coarse, fine) = (error(steps), error(2 * steps));
    let slope = (coarse / fine).log2();
    println!(
        "{} order {order}: {coarse:.1e}, {fine:.1e}, slope {slope:.2}",
        scene.name
    );
    let wanted = f64::from(order);
    assert!(fine > 3e-14, "round-off: {fine:e}");
    assert!(
        (slope - wanted).abs() < 0.1 * wanted,
        "{} order {order}: {slope}",
        scene.name
    );
}

#[test]
fn a_bar() {
    slope(&pendulum::SCENE, 6, 3.0, 40);
    slope(&pendulum::SCENE, 8, 3.0, 40);
}

#[test]
fn a_slider_crank() {
    slope(&slider_crank::SCENE, 6, 0.35, 12);
    slope(&slider_crank::SCENE, 8, 0.35, 5);
}

#[test]
fn two_loops() {
    slope(&double_four_bar::SCENE, 6, 0.65, 14);
    slope(&double_four_bar::SCENE, 8, 0.65, 12);
}

#[test]
fn a_redundant_loop() {
    slope(&bricard::SCENE, 6, 3.0, 24);
    slope(&bricard::SCENE, 8, 3.0, 20);
}

#[test]
fn a_nonholonomic_row() {
    slope(&chaplygin_sleigh::SCENE, 6, 4.0, 16);
    slope(&chaplygin_sleigh::SCENE, 8, 4.0, 16);
}

/// Its dampers brake the slider in 38 µs; at order 2 the error of this step is 0.25.
#[test]
fn stiff_dampers_take_long_steps() {
    let scene = &flyball_governor::SCENE;
    let exact = run(scene, 8, 10.0, 1000);
    for (order, bound) in [(4, 1e-3), (6, 1e-5), (8, 1e-5)] {
        let end = run(scene, order, 10.0, 100);
        let errors = end.iter().zip(&exact).map(|(a, b)| (a - b).abs());
        let error = errors.fold(0.0, f64::max);
        println!("order {order}: {error:.1e}");
        assert!(error < bound, "order {order}: {error:e}");
    }
}
