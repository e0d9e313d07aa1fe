//! Mechanisms with forces that jump or bend: friction that turns, stops, gaps, straight lines between measured points.

use mbs_runtime::{AnySimulation, Settings, Simulation, SimulationError, mechanism, methods};

mechanism!(Block {
    doc: "A block on a spring slides with friction, turns, and sticks.",
    world: Planar(),
    speed: Param(2.0_m_per_s),
    stiffness: Param(2.0_N_per_m),
    kinetic: Param(0.2),
    breakaway: Param(0.4),
    x: Coordinate(0.0_m, rate = speed),
    block: Particle(mass = 1.0_kg, position = [x, 0.0_m]),
    spring: SpringDamper(
        ground.point(-20.0_m, 0.0_m),
        block.origin,
        stiffness = stiffness,
        length = 20.0_m
    ),
    sole: Friction(
        x.rate,
        load = 9.81_N,
        coefficient = kinetic,
        static_coefficient = breakaway,
        stribeck_velocity = 0.05_m_per_s,
        regularization_velocity = 0.1_mm_per_s
    ),
});

mechanism!(Pendulum {
    doc: "A pendulum with friction in its bearing may swing against a stop.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    friction: Param(0.5),
    start: Param(0.0_rad),
    opening: Param(2.0_rad),
    stiffness: Param(1000.0_N_m),
    rod: Bar(mass = 1.0_kg, length = 0.5_m, angle = start),
    pivot: Revolute(ground.origin, rod.a),
    bush: Friction(
        rod.rate,
        load = 1.0_Nm,
        coefficient = friction,
        regularization_velocity = 1e-3_rad_per_s
    ),
    limit: Stop(
        rod.angle,
        lower = -opening,
        stiffness = stiffness,
        onset = 0.1_deg,
        dissipation = 0.2_s
    ),
});

mechanism!(Gap {
    doc: "A force drives a mass to and fro between two stops.",
    world: Planar(),
    force: Param(3.0_N),
    frequency: Param(3.0_rad_per_s),
    speed: Param(0.1_m_per_s),
    stiffness: Param(1e4_N_per_m),
    dissipation: Param(0.1_s_per_m),
    x: Coordinate(0.0_m, rate = speed),
    mass: Particle(mass = 1.0_kg, position = [x, 0.0_m]),
    pull: Force(mass.origin, value = [force * sin(frequency * t), 0.0_N]),
    gap: Stop(
        x,
        lower = -0.1_m,
        upper = 0.1_m,
        stiffness = stiffness,
        onset = 0.1_mm,
        dissipation = dissipation
    ),
});

mechanism!(Ball {
    doc: "A ball bounces on an elastic floor.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    height: Param(1.0_m),
    stiffness: Param(1e5_N_per_m),
    y: Coordinate(height),
    ball: Particle(mass = 1.0_kg, position = [0.0_m, y]),
    floor: Stop(y, lower = 0.0_m, stiffness = stiffness, onset = 0.01_mm),
});

mechanism!(Lines {
    doc: "A mass on a spring whose characteristic is three straight lines.",
    world: Planar(),
    speed: Param(1.0_m_per_s),
    bend: Param(0.1_m),
    soft: Param(-3.0_N),
    stiff: Param(50.0_N),
    characteristic: Table(
        [-0.3_m, -0.1_m, bend, 0.3_m],
        [-30.0_N, soft, 2.0_N, stiff],
        interpolation = Linear
    ),
    x: Coordinate(0.0_m, rate = speed),
    mass: Particle(mass = 1.0_kg, position = [x, 0.0_m]),
    spring: Force(mass.origin, value = [-characteristic(x), 0.0_N]),
});

mechanism!(Crank {
    doc: "A slider-crank with friction on its slider, which turns twice in a revolution.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    rate: Param(10.0_rad_per_s),
    friction: Param(0.3),
    crank: Bar(mass = 1.0_kg, length = 0.2_m, angle = 60.0_deg, rate = rate),
    rod: Bar(mass = 1.0_kg, length = 0.6_m, angle = -16.8_deg),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),
    rub: Friction(
        rod.b.x.rate,
        load = 5.0_N,
        coefficient = friction,
        regularization_velocity = 1.0_mm_per_s
    ),
});

mechanism!(Motor {
    doc: "A motor with a limited torque turns a wheel to a goal.",
    world: Planar(),
    goal: Param(1.0),
    gain: Param(20.0),
    torque: Param(2.0_N_m),
    wheel: Body(mass = 1.0_kg, inertia = 0.1_kg_m2),
    axle: Revolute(ground.origin, wheel.origin),
    wanted: Let(gain * (goal - axle.angle) - 0.5_s * gain * axle.rate),
    motor: Torque(axle, value = torque * max(-1.0, min(1.0, wanted))),
});

/// A mechanism, and the numbers that are drawn for its parameters.
pub struct Kind {
    pub name: &'static str,
    /// The least and the largest number of each parameter; over more than a decade, logarithms are drawn.
    pub ranges: &'static [[f64; 2]],
    /// With numbers for the parameters.
    pub build: fn(&[f64], Settings) -> Result<Box<dyn AnySimulation>, SimulationError>,
}

macro_rules! kind {
    ($name:literal, $mechanism:ident { $($parameter:ident: $least:literal, $most:literal;)+ }) => {
        Kind {
            name: $name,
            ranges: &[$([$least, $most]),+],
            build: |numbers, settings| {
                let mut numbers = numbers.iter().copied();
                let mechanism = $mechanism {
                    $($parameter: numbers.next().unwrap_or($least)),+
                };
                let simulation = Simulation::with_methods(mechanism, settings, methods::Accuracy)?;
                Ok(Box::new(simulation))
            },
        }
    };
}

/// All of them.
pub const KINDS: [Kind; 7] = [
    kind!("block on a spring", Block { speed: 0.3, 4.0; stiffness: 1.0, 100.0; kinetic: 0.05, 0.3; breakaway: 0.3, 0.5; }),
    kind!("pendulum with a stop", Pendulum { friction: 0.05, 1.0; start: -1.0, 1.0; opening: 1.5, 2.0; stiffness: 1e2, 1e5; }),
    kind!("gap", Gap { force: 0.5, 5.0; frequency: 1.0, 10.0; speed: 0.0, 0.2; stiffness: 1e3, 1e6; dissipation: 0.0, 1.0; }),
    kind!("ball", Ball { height: 0.3, 3.0; stiffness: 1e3, 1e6; }),
    kind!("straight lines", Lines { speed: 0.2, 1.5; bend: -0.05, 0.25; soft: -10.0, 0.0; stiff: 5.0, 100.0; }),
    kind!("slider that rubs", Crank { rate: 1.0, 20.0; friction: 0.05, 1.0; }),
    kind!("limited motor", Motor { goal: 0.5, 10.0; gain: 3.0, 300.0; torque: 0.1, 5.0; }),
];
