//! Motions that rows of time determine: works, and positions behind driven rates.

use mbs_runtime::{Simulation, mechanism};

mechanism!(Yoke {
    world: Planar(),
    frequency: Param(10.0_rad_per_s),
    shuttle: Particle(mass = 1.0_kg, at = [1.0_m, 0.0]),
    rail: PointOnLine(shuttle.origin, ground.origin, axis = X),
    drive: Drive(rail.stroke, value = 1.0_m * cos(frequency * t)),
    friction: Friction(
        rail.speed,
        load = 10.0_N,
        coefficient = 0.5,
        regularization_velocity = 1.0_mm_per_s
    ),
});

mechanism!(SoftStart {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    speed: Param(20.0_rad_per_s),
    ramp: Param(0.02_s),
    crank: Bar(mass = 0.36_kg, length = 0.15_m),
    rod: Bar(mass = 0.15_kg, length = 0.40_m),
    ram: Particle(mass = 2.0_kg),
    foot: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    wrist: Revolute(rod.b, ram.origin),
    guide: PointOnLine(ram.origin, ground.origin, axis = X),
    motor: Drive(
        crank.angle,
        value = 0.5 * speed / ramp * min(t, ramp).powi(2) + speed * max(t - ramp, 0.0_s)
    ),
});

mechanism!(DrivenRate {
    world: Planar(coordinates = Natural),
    crank: Bar(mass = 1.0_kg, length = 0.1_m, rate = 30.0_rad_per_s),
    pin: Revolute(ground.origin, crank.a),
    motor: Drive(crank.rate, value = 30.0_rad_per_s),
    angle: Output(crank.angle),
});

/// −5 N ∫ |v| tanh(|v|/ε) dt, with v = 10 m/s · sin(10/s · t) and ε = 1 mm/s, by the midpoint rule.
fn work_of_friction(duration: f64) -> f64 {
    let parts = 400_000;
    let length = duration / f64::from(parts);
    let power = |i: i32| {
        let speed = 10.0 * (10.0 * length * (f64::from(i) + 0.5)).sin().abs();
        -5.0 * speed * (speed / 1e-3).tanh()
    };
    (0..parts).map(power).sum::<f64>() * length
}

/// A drive gives what friction takes in the same stage, so that the balance does not show the error of either.
#[test]
fn friction_under_a_drive_has_its_work() {
    let wanted = work_of_friction(2.0);
    for accuracy in [1e-3, 1e-5] {
        let mut simulation = Simulation::with_accuracy(Yoke::default(), accuracy).unwrap();
        simulation.run_until(2.0).unwrap();
        let work = simulation.energy().nonconservative_work;
        let off = (work / wanted - 1.0).abs();
        assert!(off < 10.0 * accuracy, "{accuracy}: {work} J of {wanted} J");
    }
}

#[test]
fn the_work_of_a_drive_whose_acceleration_jumps_has_the_accuracy() {
    for accuracy in [1e-3, 1e-6, 1e-9] {
        let mut simulation = Simulation::with_accuracy(SoftStart::default(), accuracy).unwrap();
        simulation.run_until(0.04).unwrap();
        let energy = simulation.energy();
        let off = (energy.error / energy.kinetic).abs();
        assert!(off < 10.0 * accuracy, "{accuracy}: {off}");
    }
}

/// Rows of velocities have the rank of the velocities, and leave the positions to the steps.
#[test]
fn positions_behind_driven_rates_have_the_accuracy() {
    for accuracy in [1e-3, 1e-6, 1e-8] {
        let mut simulation = Simulation::with_accuracy(DrivenRate::default(), accuracy).unwrap();
        simulation.run_until(5.0).unwrap();
        let angle = simulation.output("angle").unwrap();
        assert!((angle - 150.0).abs() < accuracy, "{accuracy}: {angle}");
    }
}
