//! Angles of joints that are no coordinates, in steps in which bodies turn many times.

use mbs_runtime::{Settings, Simulation, mechanism};

mechanism!(Shaft {
    world: Spatial(),
    spin: Param(20.0_rad_per_s),
    rotor: Body(
        mass = 1.0_kg,
        inertia = 1.0_kg_m2,
        angular_velocity = [0.0, 0.0, spin]
    ),
    near: Revolute(ground, rotor, at = [0.0, 0.0, 0.0], axis = Z),
    far: Revolute(ground, rotor, at = [0.0, 0.0, 0.5_m], axis = Z),
    coordinate: Output(near.angle),
    counted: Output(far.angle),
    passed: Event(far.angle - 15.0),
});

mechanism!(Wheel {
    world: Spatial(coordinates = Reference),
    rotor: Body(
        mass = 1.0_kg,
        inertia = 1.0_kg_m2,
        angular_velocity = [0.0, 0.0, 400.0_rad_per_s]
    ),
    bearing: Revolute(ground, rotor, at = [0.0, 0.0, 0.0], axis = Z),
    angle: Output(bearing.angle),
});

#[test]
fn long_steps_count_every_turn() {
    for accuracy in [1e-1, 1e-3, 1e-6] {
        for spin in [20.0, -400.0] {
            let shaft = Shaft { spin };
            let mut simulation = Simulation::with_accuracy(shaft, accuracy).unwrap();
            simulation.run_until(2.0).unwrap();
            for angle in ["coordinate", "counted"] {
                let angle = simulation.output(angle).unwrap();
                assert!((angle - 2.0 * spin).abs() < 1e-6, "{accuracy}: {angle}");
            }
        }
    }
}

#[test]
fn events_of_counted_angles_are_found_in_long_steps() {
    let mut simulation = Simulation::with_accuracy(Shaft::default(), 1e-3).unwrap();
    let time = simulation.run_to_event("passed", 2.0).unwrap();
    assert!((time.unwrap() - 0.75).abs() < 1e-9, "{time:?}");
}

#[test]
fn given_steps_of_more_than_half_a_turn_count() {
    for (order, step) in [(2, 5e-3), (2, 1e-2), (2, 0.1), (8, 0.1)] {
        let settings = Settings {
            step,
            order,
            ..Settings::default()
        };
        let mut simulation = Simulation::with_settings(Wheel::default(), settings).unwrap();
        simulation.run_until(0.5).unwrap();
        let angle = simulation.output("angle").unwrap();
        assert!((angle - 200.0).abs() < 1e-6, "{order}, {step}: {angle}");
    }
}

mechanism!(Top {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    top: Body(
        mass = 15.0_kg,
        inertia = diag(0.234375_kg_m2, 0.46875_kg_m2, 0.234375_kg_m2),
        center_of_mass = [0.0, 1.0_m, 0.0],
        angular_velocity = [0.0, 150.0_rad_per_s, -4.61538_rad_per_s],
    ),
    pivot: Spherical(ground.origin, top.origin),
});

/// Errors are relative to the way, which orientations alone do not show.
#[test]
fn the_way_of_a_pair_counts_every_turn() {
    let mut simulation = Simulation::with_accuracy(Top::default(), 1e-3).unwrap();
    simulation.run_until(2.0).unwrap();
    let report = simulation.report();
    assert_eq!(report.rejected_steps, 0);
    assert!(report.steps < 12, "{}", report.steps);
}
