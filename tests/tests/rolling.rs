//! Rolling wheels and disks.

use mbs_runtime::Simulation;
use mbs_tests::fixtures::{Disks, Incline};

/// A cylinder, m r²/2, has two thirds of the acceleration without rolling.
#[test]
fn a_cylinder_rolls_down() {
    let mut simulation = Simulation::new(Incline::default()).expect("it assembles");
    simulation.run_until(1.0).expect("it runs");
    let way = 0.5 * 2.0 / 3.0 * 10.0 * f64::sin(0.6);
    let outputs = simulation.outputs();
    assert!((outputs.way - way).abs() < 1e-9, "{}", outputs.way);
    assert!((0.3 * outputs.turned - way).abs() < 1e-9);
    // The weight across the slope, and a third of that along it.
    let [across, along] = [20.0 * f64::cos(0.6), 20.0 / 3.0 * f64::sin(0.6)];
    let force = |component| {
        let force = simulation.reaction("rolls", component);
        force.expect("it has one")
    };
    let expected = [
        -across * f64::sin(0.6) + along * f64::cos(0.6),
        across * f64::cos(0.6) + along * f64::sin(0.6),
    ];
    assert!((force("fx") - expected[0]).abs() < 1e-9);
    assert!((force("fy") - expected[1]).abs() < 1e-9);
}

/// One line and the conditions by hand give the same motion.
#[test]
fn one_line_is_what_the_conditions_are() {
    let mut simulation = Simulation::new(Disks::default()).expect("it assembles");
    simulation.run_until(0.5).expect("it runs");
    let outputs = simulation.outputs();
    assert!(outputs.center.norm() > 0.8, "{}", outputs.center);
    assert!(outputs.gap.norm() < 1e-12, "{}", outputs.gap);
    assert!(simulation.energy().error.abs() < 1e-4);
}
