//! The machines among the examples, each against something that physics says of it.

#![allow(dead_code, reason = "the programs' own `main`")]

#[path = "../examples/arm.rs"]
mod arm;
#[path = "../examples/corner.rs"]
mod corner;
#[path = "../examples/excavator.rs"]
mod excavator;
#[path = "../examples/stewart.rs"]
mod stewart;

use mbs_parts::spatial::Leg;
use mbs_runtime::nalgebra::Vector3;
use mbs_runtime::{Simulation, mechanism};

/// e(t) = (e₀ + (ė₀ + 10 e₀) t) exp(−10 t) in each joint; the torques are a millisecond old at most.
#[test]
fn errors_of_the_arm_die_out_as_the_gains_say() {
    let (gap, rate) = (Vector3::new(0.0, -0.1, -0.2), Vector3::new(0.8, 0.6, 1.5));
    let growth: Vector3<f64> = rate + 10.0 * gap;
    let expected = (gap + 0.5 * growth).norm() * f64::exp(-5.0);
    let found = arm::follow(0.5).expect("it runs");
    // Measured: 2.4e-5.
    assert!((found - expected).abs() < 1e-4, "{found}, {expected}");
}

/// Measured: 5e-8 m; the rates of the legs are differences of lengths.
#[test]
fn the_plate_follows_its_program() {
    let platform = stewart::follow(2.0).expect("it runs");
    let ((place, turn), outputs) = (stewart::program(2.0), platform.outputs());
    assert!((outputs.place - place).norm() < 1e-6, "{}", outputs.place);
    assert!((outputs.up - turn * Vector3::z()).norm() < 1e-6);
    assert!(platform.energy().error.abs() < 1e-5);
}

/// At rest the force of a cylinder is the change of the potential energy with its stroke; and the works are in the balance.
#[test]
fn forces_of_the_excavator_are_those_of_the_energy() {
    let start = Simulation::new(excavator::Excavator::default());
    let mut excavator = start.expect("it assembles");
    excavator.run_until(1e-3).expect("it rests");
    let force = excavator.reaction("lift.oil", "force").expect("it has one");
    let change = 2e-4;
    let before = excavator.energy().drive_work;
    excavator.inputs_mut().lift.stroke += change;
    let slope = (excavator.energy().drive_work - before) / change;
    // Measured: 4e-5, of the curvature over the change.
    assert!((force / slope - 1.0).abs() < 1e-4, "{force}, {slope}");
    excavator::pull(&mut excavator, [0.1, 0.1, 0.1]);
    excavator.run_until(1.0).expect("it moves");
    let energy = excavator.energy();
    assert!(
        energy.error.abs() < 1e-3 * energy.drive_work.abs(),
        "{energy:?}"
    );
}

#[test]
fn the_tyre_carries_the_corner_and_the_rack_steers_it() {
    let mut corner = corner::parked().expect("it runs");
    let outputs = corner.outputs();
    // Chassis, rack, arms and upright; measured: 8e-4, as the body still moves.
    let weight = (300.0 + 2.0 + 4.0 + 2.0 + 25.0) * 9.81;
    assert!(
        (outputs.pressing / weight - 1.0).abs() < 2e-3,
        "{}",
        outputs.pressing
    );
    // The lever of the upright is 0.12 m.
    corner.set_input("steering", 0.02).expect("it follows");
    let turned = corner.outputs().toe - outputs.toe;
    assert!((turned - 0.02 / 0.12).abs() < 5e-3, "{turned}");
    corner::drive(&mut corner, 3.3).expect("it runs");
    assert!(corner.energy().error.abs() < 0.2, "{:?}", corner.energy());
}

mechanism!(Jack {
    world: Spatial(gravity = [0.0, 0.0, -10.0_m_per_s2]),
    plate: Body(mass = 10.0_kg, inertia = 1.0_kg_m2, at = [0.0, 0.0, 1.0_m]),
    guide: Prismatic(ground, plate, at = [0.0, 0.0, 1.0], axis = Z),
    leg: Assembly(
        Leg,
        base = ground,
        platform = plate,
        foot = [0.0_m, 0.0_m, 0.0_m],
        head = [0.0_m, 0.0_m, 1.0_m]
    ),
    height: Output(plate.origin.z),
});

/// A leg that stands upright had no axis across it. The plate and the upper tube fall with g.
#[test]
fn a_leg_may_stand_upright() {
    let mut jack = Simulation::new(Jack::default()).expect("it assembles");
    jack.run_until(0.1).expect("it runs");
    let height = jack.outputs().height;
    assert!((height - 0.95).abs() < 1e-9, "{height}");
}
