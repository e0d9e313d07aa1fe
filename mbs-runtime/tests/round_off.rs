//! Round-off of long runs is a random walk: it grows with the square root of the number of steps, not with the number.

use mbs_runtime::{Settings, Simulation, mechanism};

mechanism!(Tumbling {
    doc: "A free body with three different moments of inertia.",
    world: Spatial(),
    a: Param(0.11_kg_m2),
    b: Param(0.23_kg_m2),
    c: Param(0.17_kg_m2),
    body: Body(
        mass = 1.0_kg,
        inertia = diag(a, b, c),
        angular_velocity = [3.0_rad_per_s, 5.0_rad_per_s, 4.0_rad_per_s],
        free = true,
    ),
});

mechanism!(Oblique {
    doc: "The same with principal axes that are not those of the body.",
    world: Spatial(),
    body: Body(
        mass = 1.0_kg,
        inertia = [
            [0.11_kg_m2, 0.01_kg_m2, 0.02_kg_m2],
            [0.01_kg_m2, 0.23_kg_m2, 0.015_kg_m2],
            [0.02_kg_m2, 0.015_kg_m2, 0.17_kg_m2]
        ],
        angular_velocity = [3.0_rad_per_s, 5.0_rad_per_s, 4.0_rad_per_s],
        free = true,
    ),
});

mechanism!(Whirling {
    doc: "A double pendulum without gravity, in the angles of its joints.",
    world: Planar(coordinates = Joint),
    length: Param(0.9_m),
    mass: Param(1.1_kg),
    start: Param(0.0),
    upper: Bar(
        mass = mass,
        length = length,
        angle = start,
        rate = 5.0_rad_per_s
    ),
    lower: Bar(mass = mass, length = length, angle = start + 0.5),
    pivot: Revolute(ground.origin, upper.a),
    elbow: Revolute(upper.b, lower.a),
});

/// Steps over which energies are averaged.
const WINDOW: u32 = 2_500;

/// The mean of the kinetic energy over some thousand steps, relative to that of the first ones.
macro_rules! drift {
    ($mechanism:expr, $settings:expr, $steps:expr) => {{
        let mut simulation = Simulation::with_settings($mechanism, $settings).unwrap();
        let first = {
            let mut sum = 0.0;
            for _ in 0..WINDOW {
                simulation.step().unwrap();
                sum += simulation.energy().error;
            }
            sum
        };
        for _ in 0..$steps {
            simulation.step().unwrap();
        }
        let mut sum = -first;
        for _ in 0..WINDOW {
            simulation.step().unwrap();
            sum += simulation.energy().error;
        }
        sum / f64::from(WINDOW) / simulation.energy().kinetic
    }};
}

#[test]
fn free_rotation_keeps_its_energy() {
    let settings = Settings {
        order: 8,
        step: 1e-3,
        ..Settings::default()
    };
    let mut worst = 0.0_f64;
    for number in [0, 5] {
        let part = f64::from(number);
        let body = Tumbling {
            a: 0.11 + 0.0137 * part,
            c: 0.17 + 0.0071 * part,
            ..Tumbling::default()
        };
        let drift = drift!(body, settings, 8_000);
        println!("{number}: {drift:e}");
        worst = worst.max(drift.abs());
    }
    let drift = drift!(Oblique::default(), settings, 8_000);
    println!("oblique: {drift:e}");
    // A random walk of 1.6e5 stages with sixteen roundings of 1e-16 each: 1.6e-13. A bias of 6e-17 a stage gave 1e-11.
    assert!(worst.max(drift.abs()) < 5e-13, "{worst:e}");
}

/// p and v of a stage are converted into each other with constants that are rounded differently.
#[test]
fn a_double_pendulum_in_joint_coordinates_keeps_its_energy() {
    const STEPS: u32 = 8_000;
    let settings = Settings {
        order: 8,
        step: 1e-3,
        ..Settings::default()
    };
    let mut sum = 0.0;
    for number in [0, 1, 2] {
        let start = 0.05 * f64::from(number);
        let pendulum = Whirling {
            start,
            ..Whirling::default()
        };
        let mut simulation = Simulation::with_settings(pendulum, settings).unwrap();
        for _ in 0..STEPS {
            simulation.step().unwrap();
        }
        let error = simulation.energy().error / simulation.energy().kinetic;
        println!("{number}: {error:e}");
        sum += error / 3.0;
    }
    println!("{sum:e}");
    assert!(sum.abs() < 5e-12, "{sum:e}");
}
