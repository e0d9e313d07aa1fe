//! Bushings that are turned by about half a turn.

use mbs_runtime::{Settings, Simulation, mechanism};
use std::f64::consts::PI;

mechanism!(Turned {
    world: Spatial(coordinates = Joint),
    rotor: Body(mass = 1.0_kg, inertia = 0.1_kg_m2),
    hinge: Revolute(ground, rotor, at = [0.0, 0.0, 0.0], axis = Z),
    mount: Bushing(
        ground,
        rotor,
        at = [0.0, 0.0, 0.0],
        torsion_stiffness = 1.0_Nm
    ),
    drive: Drive(
        hinge.angle,
        value = 0.5 * pi * (1.0 - cos(1.0_rad_per_s * t))
    ),
});

/// V = 2 k sin²(ψ/2).
#[test]
fn the_energy_at_half_a_turn_is_that_of_the_law() {
    for settings in [Settings::default(), Settings::accuracy(1e-6)] {
        let mut simulation = Simulation::with_settings(Turned::default(), settings).unwrap();
        for time in [1.0, 2.0, PI - 2e-3, PI - 1e-4, PI, 4.0] {
            simulation.run_until(time).unwrap();
            let turn = 0.5 * PI * (1.0 - time.cos());
            let expected = 2.0 * (0.5 * turn).sin().powi(2);
            let energy = simulation.energy().potential;
            assert!(
                (energy - expected).abs() < 1e-9,
                "{time}: {energy} for {expected}"
            );
        }
    }
}

mechanism!(Released {
    world: Spatial(coordinates = Reference),
    rotor: Body(mass = 1.0_kg, inertia = 0.1_kg_m2),
    hinge: Revolute(ground, rotor, at = [0.0, 0.0, 0.0], axis = Z),
    mount: Bushing(
        ground,
        rotor,
        at = [0.0, 0.0, 0.0],
        torsion_stiffness = 1.0_Nm
    ),
    angle: Output(hinge.angle),
});

/// The angle after 3 s from rest at half a turn less `short`, of α = −10 sin a, by RK4.
fn pendulum(short: f64) -> f64 {
    let (mut angle, mut rate, h) = (PI - short, 0.0, 1e-4);
    let acceleration = |angle: f64| -10.0 * angle.sin();
    for _ in 0..30_000 {
        let (a1, v1) = (acceleration(angle), rate);
        let (a2, v2) = (acceleration(angle + 0.5 * h * v1), rate + 0.5 * h * a1);
        let (a3, v3) = (acceleration(angle + 0.5 * h * v2), rate + 0.5 * h * a2);
        let (a4, v4) = (acceleration(angle + h * v3), rate + h * a3);
        angle += h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
        rate += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    }
    angle
}

#[test]
fn a_body_falls_from_half_a_turn() {
    for short in [1e-3, 1e-4, 1e-5] {
        let mut simulation = Simulation::start(Released::default())
            .settings(Settings::accuracy(1e-7))
            .hold("angle", PI - short)
            .begin()
            .unwrap();
        simulation.run_until(3.0).unwrap();
        let (angle, expected) = (simulation.output("angle").unwrap(), pendulum(short));
        assert!(
            (angle - expected).abs() < 1e-4,
            "{short}: {angle} for {expected}"
        );
    }
}

mechanism!(Coupled {
    world: Spatial(coordinates = Joint),
    rotor: Body(mass = 2.0_kg, inertia = 0.1_kg_m2),
    slide: Cylindrical(ground, rotor, at = [0.0, 0.0, 0.0], axis = Z),
    mount: Bushing(
        ground,
        rotor,
        at = [0.0, 0.0, 0.0],
        stiffness = 100.0_N_per_m,
        torsion_stiffness = 1.0_Nm,
        cross_stiffness = 1.0_N
    ),
    turn: Output(slide.angle),
    shift: Output(slide.stroke),
    turning: Output(rotor.angular_acceleration.z),
    rising: Output(rotor.acceleration.z),
});

/// V = ½ 100 s² + 2 sin²(ψ/2) + s sin ψ.
#[test]
fn the_coupling_of_displacement_and_turning_has_its_law_at_every_angle() {
    for turn in [-2.0, 0.3, 2.0, 3.0, PI - 1e-7, PI, 3.3] {
        let shift = 0.05;
        let simulation = Simulation::start(Coupled::default())
            .hold("turn", turn)
            .hold("shift", shift)
            .begin()
            .unwrap();
        let expected = [
            -(turn.sin() + shift * turn.cos()) / 0.1,
            -(100.0 * shift + turn.sin()) / 2.0,
        ];
        for (value, expected) in simulation.output_values()[2..].iter().zip(expected) {
            assert!(
                (value - expected).abs() < 1e-9,
                "{turn}: {value} for {expected}"
            );
        }
    }
}
