//! Nothing means one metre, one kilogram or one second: the same mechanism, written in other units of length, mass and
//! time, takes the same steps with the same iterations, and its dimensionless motion is the same.

use mbs_runtime::{Mechanism, Report, Settings, Simulation, SimulationError, System, mechanism};

mechanism!(Planar {
    world: Planar(gravity = [0.0, -gravity]),
    gravity: Param(9.81_m_per_s2),
    length: Param(1.0_m),
    crank_mass: Param(1.0_kg),
    rod_mass: Param(0.4_kg),
    inertia: Param(0.02_kg_m2),
    stiffness: Param(30.0_N_per_m),
    rate: Param(3.0_rad_per_s),

    crank: Bar(
        mass = crank_mass,
        length = 0.3 * length,
        angle = 60.0_deg,
        rate = rate
    ),
    rod: Body(
        mass = rod_mass,
        inertia = inertia,
        at = [0.6 * length, 0.1 * length],
        angle = -15.0_deg
    ),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.point(-0.4 * length, 0.0)),
    guide: PointOnLine(rod.point(0.6 * length, 0.0), ground.origin, axis = X),
    spring: SpringDamper(
        ground.origin,
        rod.point(0.6 * length, 0.0),
        stiffness = stiffness,
        length = length
    ),
});

mechanism!(Spatial {
    world: Spatial(gravity = [0.0, 0.0, -gravity], coordinates = Reference),
    gravity: Param(9.81_m_per_s2),
    length: Param(1.0_m),
    mass: Param(2.0_kg),
    inertia: Param(0.05_kg_m2),
    rate: Param(8.0_rad_per_s),

    upper: Body(
        mass = mass,
        inertia = diag(inertia, 2.0 * inertia, 1.5 * inertia),
        at = [0.5 * length, 0.0, 0.0],
        angular_velocity = [rate, 0.2 * rate, 0.0],
    ),
    lower: Body(
        mass = 0.5 * mass,
        inertia = diag(0.5 * inertia, inertia, inertia),
        at = [length, 0.5 * length, 0.0],
    ),
    shoulder: Spherical(ground.origin, upper.point(-0.5 * length, 0.0, 0.0)),
    elbow: Revolute(upper, lower, at = [length, 0.0, 0.0], axis = Z),
});

mechanism!(Redundant {
    world: Planar(gravity = [0.0, -gravity]),
    gravity: Param(9.81_m_per_s2),
    length: Param(0.5_m),
    mass: Param(1.0_kg),
    rate: Param(4.0_rad_per_s),

    left: Bar(mass = mass, length = length, angle = 70.0_deg, rate = rate),
    middle: Bar(mass = mass, length = length, angle = 70.0_deg, rate = rate),
    right: Bar(mass = mass, length = length, angle = 70.0_deg, rate = rate),
    coupler: Body(
        mass = 3.0 * mass,
        inertia = mass * length.powi(2),
        at = [length + length * 70.0_deg.cos(), length * 70.0_deg.sin()],
        velocity = [
            -rate * length * 70.0_deg.sin(),
            rate * length * 70.0_deg.cos()
        ],
    ),
    second: Point([length, 0.0_m]),
    third: Point([2.0 * length, 0.0_m]),
    bearing1: Revolute(ground.origin, left.a),
    bearing2: Revolute(second, middle.a),
    bearing3: Revolute(third, right.a),
    pin1: Revolute(left.b, coupler.point(-length, 0.0)),
    pin2: Revolute(middle.b, coupler.origin),
    pin3: Revolute(right.b, coupler.point(length, 0.0)),
});

mechanism!(Singular {
    world: Planar(gravity = [0.0, -gravity]),
    gravity: Param(9.81_m_per_s2),
    length: Param(1.0_m),
    mass: Param(1.0_kg),
    speed: Param(4.0_m_per_s),

    start: Let(45.0_deg),
    turning: Let(speed / (2.0 * length * start.sin())),
    crank: Bar(mass = mass, length = length, angle = start, rate = turning),
    rod: Bar(
        mass = mass,
        length = length,
        angle = -start,
        rate = -turning
    ),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),
});

mechanism!(Nonholonomic {
    world: Spatial(gravity = [0.0, 0.0, -gravity]),
    gravity: Param(9.81_m_per_s2),
    mass: Param(2.5_kg),
    radius: Param(0.4_m),
    turning: Param(1.2_rad_per_s),
    rolling: Param(-5.0_rad_per_s),

    lean: Let(0.2_rad),
    upward: Let([0.0, -sin(lean), cos(lean)]),
    omega: Let([0.0, rolling * cos(lean), turning + rolling * sin(lean)]),
    disk: Body(
        mass = mass,
        inertia = diag(0.25, 0.5, 0.25) * mass * radius.powi(2),
        at = [0.0, 0.0, radius * cos(lean)],
        orientation = turn(X, lean),
        velocity = cross(omega, radius * upward),
        angular_velocity = omega,
    ),
    down: Let(-unit(reject(ground.z, disk.y))),
    contact: Let(disk.origin + radius * down),
    slip: Let(disk.velocity_at(contact)),
    touch: Holonomic(dot(contact, ground.z)),
    no_slip: Nonholonomic([dot(slip, ground.x), dot(slip, ground.y)]),
});

mechanism!(Damped {
    world: Planar(gravity = [0.0, -gravity]),
    gravity: Param(9.81_m_per_s2),
    length: Param(1.0_m),
    mass: Param(1.0_kg),
    stiffness: Param(500.0_N_per_m),
    damping: Param(20.0_N_s_per_m),
    friction: Param(0.05_Nm_s),

    crank: Bar(mass = mass, length = 0.3 * length, angle = 100.0_deg),
    rod: Bar(mass = mass, length = length, angle = -10.0_deg),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),
    spring: SpringDamper(
        ground.origin,
        rod.b,
        stiffness = stiffness,
        damping = damping,
        length = length
    ),
    brake: TorsionSpring(crank, rod, stiffness = 0.0_Nm, damping = friction),
});

mechanism!(FourBar {
    world: Planar(gravity = [0.0, -gravity]),
    gravity: Param(9.81_m_per_s2),
    length: Param(1.0_m),
    coupler_part: Param(1.0),

    crank: Bar(mass = 1.0_kg, length = length, angle = 50.0_deg),
    coupler: Bar(
        mass = 1.0_kg,
        length = 2.0 * coupler_part * length,
        angle = 5.0_deg
    ),
    rocker: Bar(mass = 1.0_kg, length = length, angle = 120.0_deg),
    bearing: Revolute(ground.origin, crank.a),
    far: Point([3.9 * length, 0.0_m]),
    other: Revolute(far, rocker.a),
    left: Revolute(crank.b, coupler.a),
    right: Revolute(rocker.b, coupler.b),
});

/// New units, as multiples of the old ones: a length of 1 m is written as `length`.
#[derive(Debug, Clone, Copy)]
struct Units {
    length: f64,
    mass: f64,
    time: f64,
}

impl Units {
    /// What a quantity of 1 in this SI unit is written as.
    fn factor(&self, unit: &str) -> f64 {
        let (above, below) = unit.split_once('/').unwrap_or((unit, ""));
        self.product(above) / self.product(below.trim_matches(['(', ')']))
    }

    fn product(&self, unit: &str) -> f64 {
        let Units { length, mass, time } = *self;
        unit.split(' ')
            .map(|factor| {
                let base = factor.trim_end_matches(['^', '²', '2', '3']);
                let power = match &factor[base.len()..] {
                    "" => 1,
                    "²" | "^2" => 2,
                    other => panic!("the power {other} of {unit}"),
                };
                let base = match base {
                    "" | "1" | "rad" => 1.0,
                    "m" => length,
                    "kg" => mass,
                    "s" => time,
                    "N" => mass * length / (time * time),
                    other => panic!("the unit {other} of {unit}"),
                };
                base.powi(power)
            })
            .product()
    }
}

/// What is compared: dimensionless motion, and the work for it.
struct Motion {
    states: Vec<f64>,
    report: Report,
}

/// A run in other units.
fn run<M, const Q: usize, const N: usize, const R: usize>(
    units: Units,
    settings: Settings,
    duration: f64,
) -> Motion
where
    M: Mechanism<System: System<Q, N, R>>,
{
    let mut mechanism = M::default();
    for parameter in M::MODEL.parameters {
        let value = parameter.default * units.factor(parameter.unit);
        mechanism.set_parameter(parameter.name, value).unwrap();
    }
    let settings = Settings {
        step: settings.step * units.time,
        ..settings
    };
    let mut simulation = Simulation::with_settings(mechanism, settings).unwrap();
    let mut states = Vec::new();
    for part in 1..=10 {
        let time = 0.1 * f64::from(part) * duration;
        simulation.run_until(time * units.time).unwrap();
        let q = simulation.positions().iter().zip(M::MODEL.coordinates);
        let v = simulation.velocities().iter().zip(M::MODEL.velocities);
        let state = q.chain(v);
        states.extend(state.map(|(value, quantity)| value / units.factor(quantity.unit)));
    }
    Motion {
        states,
        report: simulation.report(),
    }
}

/// Runs in metres, kilograms and seconds, and in units that are powers of four of these: every bit of the dimensionless
/// motion and every number of the report is the same. (Of powers of two square roots would be rounded.)
fn compare<M, const Q: usize, const N: usize, const R: usize>(duration: f64, orders: &[u8])
where
    M: Mechanism<System: System<Q, N, R>>,
{
    let of = |length: i32, mass: i32, time: i32| Units {
        length: 4f64.powi(length),
        mass: 4f64.powi(mass),
        time: 4f64.powi(time),
    };
    let others = [
        of(-10, 0, 0),
        of(12, 0, 0),
        of(0, -20, 0),
        of(0, 10, 0),
        of(0, 0, -5),
        of(0, 0, 4),
        of(-12, -20, -5),
        of(5, 10, 4),
        of(-20, 10, 4),
    ];
    for &order in orders {
        let settings = Settings {
            order,
            ..Settings::default()
        };
        let expected = run::<M, Q, N, R>(of(0, 0, 0), settings, duration);
        for units in others {
            let found = run::<M, Q, N, R>(units, settings, duration);
            for (value, expected) in found.states.iter().zip(&expected.states) {
                assert_eq!(value, expected, "{units:?}, order {order}");
            }
            let counts = |report: &Report| {
                let Report {
                    steps,
                    stages,
                    rejected_steps,
                    placed_steps,
                    iterations,
                    ..
                } = *report;
                [steps, stages, rejected_steps, placed_steps, iterations]
            };
            assert_eq!(counts(&found.report), counts(&expected.report), "{units:?}");
        }
    }
}

#[test]
fn in_the_plane() {
    compare::<Planar, _, _, _>(0.5, &[2, 6]);
}

#[test]
fn in_space() {
    compare::<Spatial, _, _, _>(0.5, &[2, 6]);
}

#[test]
fn with_redundant_rows() {
    compare::<Redundant, _, _, _>(0.5, &[2, 6]);
}

#[test]
fn through_singular_poses() {
    compare::<Singular, _, _, _>(1.0, &[2, 6]);
}

#[test]
fn with_nonholonomic_rows() {
    compare::<Nonholonomic, _, _, _>(0.5, &[2, 6]);
}

#[test]
fn with_dampers() {
    compare::<Damped, _, _, _>(0.5, &[2]);
}

/// A four-bar of this length whose coupler has this part of its length.
fn four_bar(length: f64, coupler_part: f64) -> FourBar {
    FourBar {
        length,
        coupler_part,
        gravity: 9.81 * length,
    }
}

/// From 4 nm to 300,000 km.
fn lengths() -> impl Iterator<Item = f64> {
    (-14..=14)
        .map(|power| 4f64.powi(power))
        .chain([1e-6, 1e-7, 3e-5, 1e7])
}

/// Loops close at any size, or are refused at any size with the same rows.
#[test]
fn assembly_has_the_same_verdict() {
    let settings = Settings::default();
    let refusal = |length: f64, part: f64| {
        let outcome = Simulation::with_settings(four_bar(length, part), settings);
        match outcome.map(|_| ()) {
            Err(SimulationError::Assembly(verdict)) => verdict.worst_rows[0].name,
            other => panic!("{length} m: {other:?}"),
        }
    };
    for length in lengths() {
        let assembled = Simulation::with_settings(four_bar(length, 1.0), settings);
        assembled.unwrap_or_else(|error| panic!("{length} m: {error}"));
        // It is too short by 3 %; all three bars on a line reach 3.8 of 3.9.
        for part in [0.9, 0.94] {
            assert_eq!(refusal(length, part), refusal(1.0, part), "{length} m");
        }
    }
}

/// A state of other rods is not taken for one of these, at any size.
#[test]
fn resumption_has_the_same_verdict() {
    let settings = Settings::default();
    for length in lengths() {
        let simulation = Simulation::with_settings(four_bar(length, 1.0), settings).unwrap();
        let state = simulation.state();
        let resumed = |length| Simulation::resume(four_bar(length, 1.0), settings, state.clone());
        assert!(resumed(length).is_ok(), "{length} m");
        for other in [1.2, 1.0 + 1e-4] {
            let outcome = resumed(other * length).map(|_| ());
            let refused = matches!(outcome, Err(SimulationError::StateRow { .. }));
            assert!(refused, "{length} m: {outcome:?}");
        }
    }
}
