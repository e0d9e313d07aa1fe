//! Stops against closed forms and fine integrations.

use mbs_runtime::{Settings, Simulation, mechanism};

mechanism!(Bumper {
    doc: "A mass flies into a stop, and one in the other direction; a third meets a stop that dissipates.",
    world: Planar(),
    stiffness: Param(2000.0_N_per_m),
    onset: Param(5.0_mm),
    dissipation: Param(0.4_s_per_m),
    x: Coordinate(0.0_m, rate = 1.0_m_per_s),
    y: Coordinate(0.0_m, rate = -1.0_m_per_s),
    z: Coordinate(0.0_m, rate = 1.0_m_per_s),
    first: Particle(mass = 0.5_kg, position = [x, 0.0_m]),
    second: Particle(mass = 0.5_kg, position = [y, 1.0_m]),
    third: Particle(mass = 0.5_kg, position = [z, 2.0_m]),
    above: Stop(x, upper = 0.1_m, stiffness = stiffness, onset = onset),
    below: Stop(
        y,
        lower = -0.1_m,
        upper = 0.3_m,
        stiffness = stiffness,
        onset = onset
    ),
    damped: Stop(
        z,
        upper = 0.1_m,
        stiffness = stiffness,
        onset = onset,
        dissipation = dissipation
    ),
    right: Output(x),
    left: Output(y),
    slow: Output(z),
    speed: Output(x.rate),
    slow_speed: Output(z.rate),
    turned: Event(x.rate),
});

fn bumper(step: f64) -> Simulation<BumperEquations, 3, 3, 0> {
    let settings = Settings {
        step,
        ..Settings::default()
    };
    Simulation::with_settings(Bumper::default(), settings).expect("it assembles")
}

/// Where the mass turns, the energy k/(6δ) (d³ − (d − δ)³) is its kinetic energy; it leaves as fast as it came.
#[test]
fn the_depth_is_that_of_the_energy() {
    let mut simulation = bumper(1e-5);
    simulation.run_to_event("turned", 1.0).expect("it turns");
    let (k, onset, energy) = (2000.0, 0.005, 0.25);
    let depth = simulation.outputs().right - 0.1;
    let stored = k / (6.0 * onset) * (depth.powi(3) - (depth - onset).powi(3));
    assert!(depth > onset);
    assert!((stored - energy).abs() < 1e-7, "{stored}");
    // The same as of a constant stiffness, but for the part of the onset.
    let straight = k * (depth * depth - depth * onset + onset * onset / 3.0) / 2.0;
    assert!((stored - straight).abs() < 1e-12);
    simulation.run_until(0.3).expect("it runs");
    let outputs = simulation.outputs();
    assert!((outputs.speed + 1.0).abs() < 1e-7, "{}", outputs.speed);
    assert!((outputs.right + outputs.left).abs() < 1e-12);
}

/// k/(2δ) (d² − (d − δ)²) (1 + c ḋ), where each factor counts while it is positive.
fn push(x: f64, speed: f64) -> f64 {
    let square = |depth: f64| depth.max(0.0).powi(2);
    let elastic = 2000.0 / 0.01 * (square(x - 0.1) - square(x - 0.105));
    elastic * (1.0 + 0.4 * speed).max(0.0)
}

#[test]
fn dissipation_is_that_of_hunt_and_crossley() {
    let mut simulation = bumper(1e-5);
    simulation.run_until(0.25).expect("it runs");
    let (mut x, mut v, h) = (0.0, 1.0, 1e-6);
    for _ in 0..250_000 {
        // Midpoint rule.
        let half = v - 0.5 * h * push(x, v) / 0.5;
        let middle = x + 0.5 * h * v;
        v -= h * push(middle, half) / 0.5;
        x += h * half;
    }
    let outputs = simulation.outputs();
    assert!((outputs.slow - x).abs() < 1e-7, "{} and {x}", outputs.slow);
    assert!((outputs.slow_speed - v).abs() < 1e-7, "{v}");
    // The coefficient of restitution is near 1 − 2/3 c v.
    assert!((-v - (1.0 - 2.0 / 3.0 * 0.4)).abs() < 0.06, "{v}");
    let energy = simulation.energy();
    let lost = 0.25 * (1.0 - v * v);
    assert!((energy.nonconservative_work + lost).abs() < 1e-6);
    assert!(energy.error.abs() < 1e-6, "{:e}", energy.error);
}

/// However much is dissipated, a stop does not pull what leaves it.
#[test]
fn it_does_not_pull() {
    let mechanism = Bumper {
        dissipation: 100.0,
        ..Bumper::default()
    };
    let settings = Settings {
        step: 1e-5,
        ..Settings::default()
    };
    let mut simulation = Simulation::with_settings(mechanism, settings).expect("it assembles");
    let mut slowest: f64 = 1.0;
    for step in 0..300 {
        simulation
            .run_until(1e-3 * f64::from(step))
            .expect("it runs");
        let speed = simulation.outputs().slow_speed;
        // Once it is on its way back it is not slowed down.
        assert!(speed < slowest + 1e-9, "{speed} after {slowest}");
        slowest = slowest.min(speed);
    }
    assert!((-0.02..0.0).contains(&slowest), "{slowest}");
}

mechanism!(Clapper {
    doc: "A pendulum between stops, in the plane.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    bar: Bar(
        mass = 1.0_kg,
        length = 0.5_m,
        angle = -90.0_deg,
        rate = 4.0_rad_per_s
    ),
    pivot: Revolute(ground.origin, bar.a),
    bell: Stop(
        bar.angle,
        lower = -100.0_deg,
        upper = -80.0_deg,
        stiffness = 50.0_N_m,
        onset = 3.0_deg,
        dissipation = 0.05_s
    ),
    angle: Output(bar.angle),
});

mechanism!(ClapperInSpace {
    doc: "The same in space; the angle of the joint is 0 in the home pose.",
    world: Spatial(gravity = [0.0, -9.81_m_per_s2, 0.0]),
    bar: Body(
        mass = 1.0_kg,
        inertia = diag(1.0, 1.0, 1.0 / 48.0),
        center_of_mass = [0.0, -0.25, 0.0],
        angular_velocity = [0.0, 0.0, 4.0],
        velocity = [0.0, 0.0, 0.0]
    ),
    pivot: Revolute(ground, bar, at = [0.0, 0.0, 0.0], axis = Z),
    bell: Stop(
        pivot.angle,
        lower = -10.0_deg,
        upper = 10.0_deg,
        stiffness = 50.0_N_m,
        onset = 3.0_deg,
        dissipation = 0.05_s
    ),
    angle: Output(pivot.angle),
});

#[test]
fn an_angle_has_the_same_stops_in_the_plane_and_in_space() {
    let settings = Settings {
        step: 1e-4,
        ..Settings::default()
    };
    let mut planar = Simulation::with_settings(Clapper::default(), settings).expect("it assembles");
    let mut spatial =
        Simulation::with_settings(ClapperInSpace::default(), settings).expect("it assembles");
    let mut most: f64 = 0.0;
    for step in 1..20 {
        let time = 0.05 * f64::from(step);
        planar.run_until(time).expect("it runs");
        spatial.run_until(time).expect("it runs");
        let angle = planar.outputs().angle + std::f64::consts::FRAC_PI_2;
        assert!((angle - spatial.outputs().angle).abs() < 1e-6, "at {time}");
        most = most.max(angle.abs());
    }
    assert!(most > 0.2 && most < 0.9, "{most}");
    assert!(planar.energy().error.abs() < 1e-5);
    assert!(planar.energy().nonconservative_work < -0.1);
}
