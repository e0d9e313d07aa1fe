//! Rows that are affine in a coordinate are eliminated with it; motion, reactions, start and mobility stay the same.

use mbs_macros_core::{Analysis, analyse};
use mbs_runtime::{Mechanism, Settings, Simulation, System, mechanism};

fn simulation<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: M,
    step: f64,
) -> Simulation<S, Q, N, R>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let settings = Settings {
        step,
        ..Settings::default()
    };
    Simulation::with_settings(mechanism, settings).expect("it assembles")
}

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!(
        (found - expected).abs() <= tolerance,
        "{found} instead of {expected}"
    );
}

fn sizes<M: Mechanism>() -> (usize, usize) {
    (M::MODEL.velocities.len(), M::MODEL.rows.len())
}

mechanism!(Guided {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Natural),
    crank: Bar(
        mass = 1.0_kg,
        length = 0.3_m,
        angle = 50.0_deg,
        rate = 4.0_rad_per_s
    ),
    rod: Bar(mass = 2.0_kg, length = 0.7_m, angle = -20.0_deg),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    place: Point([
        0.3_m * cos(50.0_deg) + 0.7_m * cos(20.0_deg),
        0.3_m * sin(50.0_deg) - 0.7_m * sin(20.0_deg)
    ]),
    guide: PointOnLine(rod.b, place, axis = [4.0, 3.0]),
    x: Output(rod.b.x),
    y: Output(rod.b.y),
});

// The same, but with a sine the row is not affine.
mechanism!(Held {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Natural),
    crank: Bar(
        mass = 1.0_kg,
        length = 0.3_m,
        angle = 50.0_deg,
        rate = 4.0_rad_per_s
    ),
    rod: Bar(mass = 2.0_kg, length = 0.7_m, angle = -20.0_deg),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    place: Point([
        0.3_m * cos(50.0_deg) + 0.7_m * cos(20.0_deg),
        0.3_m * sin(50.0_deg) - 0.7_m * sin(20.0_deg)
    ]),
    guide: Holonomic(((0.8 * (rod.b.y - place.y) - 0.6 * (rod.b.x - place.x)) / 1.0_m).sin()),
    x: Output(rod.b.x),
    y: Output(rod.b.y),
});

/// A slider on an inclined line, whose declared rates contradict the row: with and without it, to round-off at every step.
#[test]
fn the_same_motion() {
    assert_eq!((sizes::<Guided>(), sizes::<Held>()), ((3, 2), (4, 3)));
    let mut guided = simulation(Guided::default(), 1e-3);
    let mut held = simulation(Held::default(), 1e-3);
    for step in 0..2000 {
        for output in ["x", "y"] {
            let [a, b] = [guided.output(output), held.output(output)].map(|x| x.expect(output));
            close(a, b, 1e-9);
        }
        if step % 100 == 0 {
            for joint in ["bearing", "pin"] {
                for component in ["fx", "fy"] {
                    let found = guided.reaction(joint, component).expect(joint);
                    let expected = held.reaction(joint, component).expect(joint);
                    close(found, expected, 1e-6 * (1.0 + expected.abs()));
                }
            }
            let lambda = held.reaction("guide", "lambda").expect("it has a row");
            let normal = [("fx", -0.6), ("fy", 0.8)];
            for (component, n) in normal {
                let found = guided
                    .reaction("guide", component)
                    .expect("it is recovered");
                close(found, n * lambda, 1e-6 * (1.0 + lambda.abs()));
            }
        }
        guided.step().expect("it runs");
        held.step().expect("it runs");
    }
}

mechanism!(Sledge {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Reference),
    mass: Param(2.0_kg),
    stiffness: Param(50.0_N_per_m),
    offset: Param(0.2_m),
    sledge: Body(
        mass = mass,
        inertia = 0.3_kg_m2,
        center_of_mass = [offset, 0.0],
        at = [0.1, 0.0]
    ),
    rail: Prismatic(ground.origin, sledge.origin, axis = X),
    spring: SpringDamper(
        ground.point(-1.0, 0.0),
        sledge.origin,
        stiffness = stiffness,
        length = 1.0_m
    ),
    x: Output(sledge.origin.x),
});

/// A body on a rail: one coordinate and no row, an oscillator whose rail carries the weight and its lever.
#[test]
fn a_body_on_a_rail() {
    assert_eq!(sizes::<Sledge>(), (1, 0));
    let mut simulation = simulation(Sledge::default(), 1e-4);
    let omega = (50.0f64 / 2.0).sqrt();
    for _ in 0..10 {
        simulation
            .run_until(simulation.time() + 0.1)
            .expect("it runs");
        let x = 0.1 * (omega * simulation.time()).cos();
        close(simulation.output("x").expect("declared"), x, 1e-6);
        let reaction = |component| simulation.reaction("rail", component).expect("recovered");
        close(reaction("fx"), 0.0, 1e-12);
        close(reaction("fy"), 2.0 * 9.81, 1e-10);
        // The weight acts beside the point of the rail.
        close(reaction("torque"), 0.2 * 2.0 * 9.81, 1e-10);
    }
    let saved =
        "`rail`: sledge.angle, sledge.y follow from its rows, 2 coordinates and as many rows saved";
    assert!(
        Sledge::MODEL.reductions.contains(&saved),
        "{:?}",
        Sledge::MODEL.reductions
    );
}

mechanism!(Train {
    world: Spatial(coordinates = Joint),
    first: Param(-2.0),
    second: Param(-1.5),
    moment: Param(3.0_Nm),
    a: Body(mass = 1.0_kg, inertia = Cylinder(0.1_m, 0.02_m, Z)),
    b: Body(
        mass = 2.0_kg,
        inertia = Cylinder(0.2_m, 0.02_m, Z),
        at = [0.3, 0.0, 0.0]
    ),
    c: Body(
        mass = 3.0_kg,
        inertia = Cylinder(0.3_m, 0.02_m, Z),
        at = [0.8, 0.0, 0.0]
    ),
    shaft_a: Revolute(ground, a, at = [0.0, 0.0, 0.0], axis = Z),
    // declared with exchanged partners: its angle is that of the ground relative to the wheel
    shaft_b: Revolute(b, ground, at = [0.3, 0.0, 0.0], axis = Z),
    shaft_c: Revolute(ground, c, at = [0.8, 0.0, 0.0], axis = Z),
    mesh: Gear(shaft_a, shaft_b, ratio = first),
    next_mesh: Gear(shaft_b, shaft_c, ratio = second),
    motor: Torque(shaft_a, value = moment),
    angle: Output(shaft_a.angle),
    last: Output(shaft_c.angle),
    middle: Output(shaft_b.angle),
});

mechanism!(TrainOfBodies {
    world: Spatial(coordinates = Reference),
    moment: Param(3.0_Nm),
    a: Body(mass = 1.0_kg, inertia = Cylinder(0.1_m, 0.02_m, Z)),
    b: Body(
        mass = 2.0_kg,
        inertia = Cylinder(0.2_m, 0.02_m, Z),
        at = [0.3, 0.0, 0.0]
    ),
    c: Body(
        mass = 3.0_kg,
        inertia = Cylinder(0.3_m, 0.02_m, Z),
        at = [0.8, 0.0, 0.0]
    ),
    shaft_a: Revolute(ground, a, at = [0.0, 0.0, 0.0], axis = Z),
    shaft_b: Revolute(b, ground, at = [0.3, 0.0, 0.0], axis = Z),
    shaft_c: Revolute(ground, c, at = [0.8, 0.0, 0.0], axis = Z),
    mesh: Gear(shaft_a, shaft_b, ratio = -2.0),
    next_mesh: Gear(shaft_b, shaft_c, ratio = -1.5),
    motor: Torque(shaft_a, value = moment),
    angle: Output(shaft_a.angle),
});

/// Three wheels, one degree of freedom, no row, compared with Newton's equations over many turns.
#[test]
fn a_gear_train() {
    assert_eq!(sizes::<Train>(), (1, 0));
    assert_eq!(
        Train::MODEL.coordinates.len(),
        1,
        "nothing has to be counted"
    );
    let inertia = |mass: f64, radius: f64| 0.5 * mass * radius * radius;
    let (a, b, c) = (inertia(1.0, 0.1), inertia(2.0, 0.2), inertia(3.0, 0.3));
    let alpha = 3.0 / (a + 4.0 * b + 9.0 * c);
    let mut train = simulation(Train::default(), 1e-3);
    train.run_until(5.0).expect("it runs");
    let output = |name| train.output(name).expect("declared");
    let angle = 0.5 * alpha * 25.0;
    assert!(angle > 20.0, "a few turns");
    close(output("angle"), angle, 1e-9 * angle);
    close(output("middle"), -2.0 * angle, 1e-9 * angle);
    close(output("last"), 3.0 * angle, 1e-9 * angle);
    // The torque of each mesh accelerates the wheels behind it.
    let torque = |joint| train.reaction(joint, "torque").expect("recovered");
    close(torque("next_mesh"), c * 3.0 * alpha, 1e-10);
    let reversed = -b * 2.0 * alpha;
    close(torque("mesh"), reversed - 1.5 * c * 3.0 * alpha, 1e-10);

    let mut bodies = simulation(TrainOfBodies::default(), 1e-3);
    bodies.run_until(1.0).expect("it runs");
    for joint in ["mesh", "next_mesh"] {
        let expected = bodies.reaction(joint, "torque").expect("it has a row");
        close(torque(joint), expected, 1e-6);
    }
}

mechanism!(Wheels {
    world: Planar(coordinates = Reference),
    ratio: Param(3.0),
    a: Body(mass = 1.0_kg, inertia = 0.5_kg_m2, at = [0.0, 0.0]),
    b: Body(
        mass = 1.0_kg,
        inertia = 0.2_kg_m2,
        at = [1.0, 0.0],
        rate = 10.0_rad_per_s
    ),
    p: Revolute(ground.origin, a.origin),
    q: Revolute(ground.point(1.0, 0.0), b.origin),
    mesh: Gear(a, b, ratio = ratio, offset = 0.7),
    rate: Output(a.rate),
    gap: Output(b.angle - ratio * a.angle),
    angle: Output(a.angle),
});

/// The guess of an eliminated coordinate is used, too: the start has the least change of all guesses, weighted by mass.
#[test]
fn the_same_start() {
    assert_eq!(sizes::<Wheels>(), (1, 0));
    for ratio in [3.0, -0.5, 0.0] {
        let start = simulation(Wheels { ratio }, 1e-3);
        let output = |name| start.output(name).expect("declared");
        // min 0.5 ω² + 0.2 (ratio ω − 10)², min 0.5 θ² + 0.2 (ratio θ + 0.7)²
        let weight = 0.5 + 0.2 * ratio * ratio;
        close(output("rate"), 0.2 * ratio * 10.0 / weight, 1e-13);
        close(output("angle"), -0.2 * ratio * 0.7 / weight, 1e-13);
        close(output("gap"), 0.7, 1e-14);
    }
}

mechanism!(Coupled {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    turn: Coordinate(0.3),
    swing: Coordinate(0.4, rate = 1.0),
    ball: Particle(mass = 2.0_kg, position = 0.7_m * [sin(turn), -cos(turn)]),
    other: Particle(
        mass = 1.0_kg,
        position = [sin(turn), -cos(turn)] * 0.7_m + [sin(swing), -cos(swing)] * 0.5_m
    ),
    link: Coupling(turn, swing, ratio = 2.0, offset = -0.2),
    x: Output(other.origin.x),
});

// The same in the remaining coordinate.
mechanism!(Single {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    turn: Coordinate(0.3, rate = 0.5),
    ball: Particle(mass = 2.0_kg, position = 0.7_m * [sin(turn), -cos(turn)]),
    other: Particle(
        mass = 1.0_kg,
        position = [sin(turn), -cos(turn)] * 0.7_m
            + [sin(2.0 * turn - 0.2), -cos(2.0 * turn - 0.2)] * 0.5_m
    ),
    x: Output(other.origin.x),
});

mechanism!(Loose {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    turn: Coordinate(0.3, rate = 0.5),
    swing: Coordinate(0.4, rate = 1.0),
    ball: Particle(mass = 2.0_kg, position = 0.7_m * [sin(turn), -cos(turn)]),
    other: Particle(
        mass = 1.0_kg,
        position = [sin(turn), -cos(turn)] * 0.7_m + [sin(swing), -cos(swing)] * 0.5_m
    ),
    link: Holonomic((swing - 2.0 * turn + 0.2).sin()),
    x: Output(other.origin.x),
});

/// If M varies and the guesses do not satisfy the row, the row stays.
#[test]
fn coordinates_by_hand() {
    assert_eq!(sizes::<Coupled>(), (2, 1), "the rates contradict it");
    assert_eq!(sizes::<Loose>(), (2, 1));
    mechanism!(Fitting {
        world: Planar(gravity = [0.0, -9.81_m_per_s2]),
        turn: Coordinate(0.3, rate = 0.5),
        swing: Coordinate(0.4, rate = 1.0),
        ball: Particle(mass = 2.0_kg, position = 0.7_m * [sin(turn), -cos(turn)]),
        other: Particle(
            mass = 1.0_kg,
            position = [sin(turn), -cos(turn)] * 0.7_m + [sin(swing), -cos(swing)] * 0.5_m
        ),
        link: Coupling(turn, swing, ratio = 2.0, offset = -0.2),
        x: Output(other.origin.x),
    });
    assert_eq!(sizes::<Fitting>(), (1, 0));
    let mut fitting = simulation(Fitting::default(), 1e-3);
    let mut single = simulation(Single::default(), 1e-3);
    let mut loose = simulation(Loose::default(), 1e-4);
    // The multiplier of the coupling, with the terms of a mass matrix that varies.
    let coupling = fitting.reaction("link", "lambda").expect("recovered");
    let row = loose.reaction("link", "lambda").expect("it has a row");
    close(coupling, row, 1e-10 * row.abs());
    for _ in 0..5 {
        let time = fitting.time() + 0.2;
        fitting.run_until(time).expect("it runs");
        single.run_until(time).expect("it runs");
        loose.run_until(time).expect("it runs");
        let x = fitting.output("x").expect("declared");
        close(x, single.output("x").expect("declared"), 1e-9);
        let coupling = fitting.reaction("link", "lambda").expect("recovered");
        let row = loose.reaction("link", "lambda").expect("it has a row");
        close(coupling, row, 1e-3 * (1.0 + row.abs()));
    }
}

fn tried(entries: &str) -> Result<Analysis, Vec<String>> {
    let text = format!("Tried {{ world: {entries} }}");
    let (_, outcome) = analyse(text.parse().expect("these are tokens"));
    outcome.map_err(|failure| failure.messages().into_iter().map(|(m, _)| m).collect())
}

const SLIDER: &str = "Planar(coordinates = Natural),
    crank: Bar(mass = 1.0_kg, length = 1.0_m, angle = 0.7), rod: Bar(mass = 1.0_kg, length = 2.0_m),
    bearing: Revolute(ground.origin, crank.a), pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),";

fn count(analysis: &Analysis) -> (usize, usize) {
    let system = &analysis.derived.system;
    (system.size, system.rows.len())
}

/// Rows that are equivalent or contradictory are reported as without elimination.
#[test]
fn redundant_rows_stay() {
    let plain = tried(SLIDER).expect("it is right");
    assert_eq!(count(&plain), (3, 2));
    let mobility = plain.mobility.expect("it assembles");
    assert_eq!((mobility.rank, mobility.mobility), (2, 1));

    let twice = format!("{SLIDER} rail: PointOnLine(rod.b, ground.point(1.0, 0.0), axis = X),");
    let twice = tried(&twice).expect("redundancy is no error");
    assert_eq!(count(&twice), (4, 4));
    let mobility = twice.mobility.expect("it assembles");
    assert_eq!(mobility.mobility, 1);
    assert_eq!(mobility.undetermined, ["guide", "rail"]);
    assert_eq!(mobility.redundant.len(), 1);
    assert_eq!(mobility.redundant[0].follows_from, ["guide"]);

    let contrary = format!("{SLIDER} rail: PointOnLine(rod.b, ground.point(0.0, 0.4), axis = X),");
    let messages = tried(&contrary).expect_err("these lines are parallel");
    assert!(
        messages.len() == 1
            && messages[0].contains("`guide` by")
            && messages[0].contains("`rail` by"),
        "{messages:?}"
    );

    // Parallel cranks, geared: the gear follows from the bars, and shares their load.
    let parallel = "Planar(coordinates = Reference),
        left: Bar(mass = 1.0_kg, length = 1.0_m, angle = 1.0), right: Bar(mass = 1.0_kg, length = 1.0_m, angle = 1.0),
        beam: Bar(mass = 1.0_kg, length = 2.0_m), a: Revolute(ground.origin, left.a), b: Revolute(ground.point(2.0, 0.0), right.a),
        c: Revolute(left.b, beam.a), d: Revolute(right.b, beam.b), gear: Gear(left, right, ratio = 1.0),";
    let mobility = tried(parallel).expect("redundancy is no error").mobility;
    let mobility = mobility.expect("it assembles");
    assert_eq!((mobility.mobility, mobility.redundant.len()), (1, 1));
    assert_eq!(mobility.redundant[0].entry, "gear");
    assert!(mobility.undetermined.contains(&"gear".to_owned()));
    let denied = format!("deny: Redundant(), world: {parallel}");
    let (_, outcome) = analyse(format!("Tried {{ {denied} }}").parse().expect("tokens"));
    let messages = outcome.map(|_| ()).expect_err("it is denied").messages();
    assert!(
        messages[0].0.contains("the row of `gear` follows"),
        "{messages:?}"
    );
}

/// A body without mass that only transmits forces is eliminated completely.
#[test]
fn massless_bodies_vanish() {
    let slider = "Planar(coordinates = Natural), crank: Bar(mass = 1.0_kg, length = 1.0_m, angle = 0.7),
        rod: Bar(mass = 1.0_kg, length = 2.0_m), slider: Body(mass = 0.0_kg, inertia = 0.0_kg_m2),
        bearing: Revolute(ground.origin, crank.a), pin: Revolute(crank.b, rod.a), gudgeon: Revolute(rod.b, slider.origin),
        rail: Prismatic(ground.origin, slider.origin, axis = X),";
    let analysis = tried(slider).expect("it is right");
    assert_eq!(count(&analysis), (3, 2));
    let mobility = analysis.mobility.expect("it assembles");
    assert_eq!((mobility.rank, mobility.mobility), (2, 1));
    // If no row holds its angle, it is an error, as before.
    let loose = slider.replace(
        "rail: Prismatic(ground.origin, slider.origin",
        "rail: PointOnLine(slider.origin, ground.origin",
    );
    let messages = tried(&loose).expect_err("it turns without inertia");
    assert!(messages[0].contains("`slider`"), "{messages:?}");
}

/// Only numbers are divisors; rows with time or inputs are not eliminated; parts that cannot move keep their rows.
#[test]
fn rows_that_stay() {
    // The direction of the line is a parameter: either of its components may be zero.
    let tilted = "Planar(), tilt: Param(0.3), bead: Particle(mass = 1.0_kg),
        wire: PointOnLine(bead.origin, ground.origin, axis = [cos(tilt), sin(tilt)]),";
    assert_eq!(count(&tried(tilted).expect("it is right")), (2, 1));
    let straight = "Planar(), bead: Particle(mass = 1.0_kg), wire: PointOnLine(bead.origin, ground.origin, axis = [2.0, 1.0]),";
    assert_eq!(count(&tried(straight).expect("it is right")), (1, 0));
    let driven = "Planar(), bead: Particle(mass = 1.0_kg), motor: Drive(bead.origin.x, value = 1.0_m_per_s * t),";
    assert_eq!(count(&tried(driven).expect("it is right")), (2, 1));
    let pinned = "Planar(), bead: Particle(mass = 1.0_kg), x: Holonomic(bead.origin.x - 1.0_m), y: Holonomic(bead.origin.y),";
    assert_eq!(count(&tried(pinned).expect("it is right")), (2, 2));
    // The two couplings already fix the distance of the particles: the row of the rope is redundant.
    let vacuous = "Planar(), bead: Particle(mass = 1.0_kg), other: Particle(mass = 1.0_kg), rope: Distance(bead.origin, other.origin, length = 1.0_m),
        x: Coupling(bead.origin.x, other.origin.x, ratio = 1.0), y: Coupling(bead.origin.y, other.origin.y, ratio = 1.0, offset = 1.0_m),";
    let vacuous = tried(vacuous).expect("redundancy is no error");
    assert_eq!(count(&vacuous), (4, 3));
    assert_eq!(vacuous.mobility.expect("it assembles").rank, 2);
}
