//! Places of the plane that are given by points of parts: `at = crank.b`.

use mbs_runtime::{Simulation, mechanism};

mechanism!(Chain {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    lean: Param(0.4),
    crank: Bar(mass = 1.0_kg, length = 1.0_m, angle = lean),
    pin: Revolute(ground.origin, crank.a),
    plate: Body(
        mass = 1.0_kg,
        inertia = 0.1_kg_m2,
        at = crank.b,
        angle = 0.3
    ),
    rope: SpringDamper(ground.origin, plate.origin, stiffness = 10.0_N_per_m),
    bob: Particle(mass = 1.0_kg, at = plate.point(0.5_m, 0.0_m)),
    thread: SpringDamper(plate.origin, bob.origin, stiffness = 10.0_N_per_m),
    rod: Bar(mass = 1.0_kg, length = 1.5_m, from = bob.origin, to = post),
    post: Point([2.0_m, 2.0_m]),
    spring: SpringDamper(rod.a, bob.origin, stiffness = 10.0_N_per_m),
    x: Coordinate(0.3_m),
    slider: Particle(mass = 1.0_kg, position = [2.0 * x, 1.0_m]),
    tail: Particle(mass = 1.0_kg, at = slider.origin),
    last: SpringDamper(slider.origin, tail.origin, stiffness = 10.0_N_per_m),
    plate_at: Output(plate.origin),
    bob_at: Output(bob.origin),
    rod_from: Output(rod.a),
    rod_to: Output(rod.b),
    tail_at: Output(tail.origin),
});

/// Along parts that lean on one another, in any order, with parameters of the program.
#[test]
fn a_point_stands_for_where_it_starts() {
    for lean in [0.4, -1.2] {
        let simulation = Simulation::new(Chain { lean }).expect("it assembles");
        let outputs = simulation.outputs();
        let near = |found: [f64; 2], wanted: [f64; 2]| {
            let gap = (found[0] - wanted[0]).hypot(found[1] - wanted[1]);
            assert!(gap < 1e-14, "{found:?}, {wanted:?}");
        };
        let crank = [lean.cos(), lean.sin()];
        let bob = [
            crank[0] + 0.5 * 0.3_f64.cos(),
            crank[1] + 0.5 * 0.3_f64.sin(),
        ];
        near(outputs.plate_at.into(), crank);
        near(outputs.bob_at.into(), bob);
        near(outputs.rod_from.into(), bob);
        near(outputs.tail_at.into(), [0.6, 1.0]);
        let to = [2.0 - bob[0], 2.0 - bob[1]];
        let length = to[0].hypot(to[1]);
        let end = [0, 1].map(|k| bob[k] + 1.5 * to[k] / length);
        near(outputs.rod_to.into(), end);
    }
}

mechanism!(Held {
    doc: "The start of the slider-crank moves the crank; the bob is held to its end.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    crank: Bar(mass = 1.0_kg, length = 1.0_m, angle = 0.5),
    rod: Bar(mass = 1.0_kg, length = 1.3_m, angle = -0.2),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),
    bob: Particle(mass = 0.1_kg, at = Exactly(rod.b)),
    thread: SpringDamper(rod.b, bob.origin, stiffness = 10.0_N_per_m),
    gap: Output(bob.origin - rod.b),
});

/// The place that is held is the one after assembly, not that of the guess.
#[test]
fn a_place_is_held_where_the_point_is() {
    let simulation = Simulation::new(Held {}).expect("it assembles");
    let moved = simulation.assembly().moved;
    assert!(moved > 0.05, "{moved}");
    let gap = simulation.outputs().gap.norm();
    assert!(gap < 1e-12, "{gap:e}");
}
