//! A body of which one point alone is drawn has a mark that shows how it turns.

use mbs_runtime::{Simulation, mechanism};

mechanism!(Rotors {
    doc: "A disc on its axle, an arm with its mass beside the axle, and a slider that is drawn to its spring.",
    world: Planar(),
    mass: Param(2.0_kg),
    disc: Body(mass = mass, inertia = 0.18_kg_m2),
    axle: Revolute(ground.origin, disc.origin),
    arm: Body(
        mass = 1.0_kg,
        inertia = 0.1_kg_m2,
        center_of_mass = [0.0_m, 0.4_m]
    ),
    pivot: Revolute(ground.point(1.0_m, 0.0_m), arm.origin),
    slider: Body(mass = 1.0_kg, inertia = 0.1_kg_m2),
    rail: Prismatic(ground.point(0.0_m, 2.0_m), slider.origin, axis = X),
    spring: SpringDamper(
        ground.point(0.0_m, 3.0_m),
        slider.point(0.5_m, 0.0_m),
        stiffness = 1.0_N_per_m
    ),
    disc_angle: Output(disc.angle),
    arm_angle: Output(arm.angle),
});

#[test]
fn the_mark_turns_with_the_body() {
    let simulation = Simulation::start(Rotors { mass: 0.5 })
        .hold("disc_angle", 0.3)
        .hold("arm_angle", 0.3)
        .begin()
        .expect("it assembles");
    let (model, points) = (simulation.model(), simulation.points());
    let lines = |part: &str| {
        let own = model.segments.iter().filter(|segment| segment.part == part);
        let ends = own.map(|line| [line.from, line.to].map(|k| (model.points[k], points[k])));
        ends.collect::<Vec<_>>()
    };
    let near = |found: [f64; 3], wanted: [f64; 2]| {
        (found[0] - wanted[0]).hypot(found[1] - wanted[1]) < 1e-14
    };
    let [[from, to]] = lines("disc")[..] else {
        panic!("one line of the disc")
    };
    assert_eq!((from.0, to.0), ("disc.origin", "disc.mark"));
    // The radius of gyration of 0.18 kg m² and 0.5 kg is 0.6 m.
    assert!(near(to.1, [0.6 * 0.3_f64.cos(), 0.6 * 0.3_f64.sin()]));
    let [[_, to]] = lines("arm")[..] else {
        panic!("one line of the arm")
    };
    // The centre of mass.
    assert!(near(to.1, [1.0 - 0.4 * 0.3_f64.sin(), 0.4 * 0.3_f64.cos()]));
    let [[_, to]] = lines("slider")[..] else {
        panic!("one line of the slider")
    };
    assert!(!to.0.ends_with(".mark"));
    assert_eq!(model.marks, 2);
    assert!(
        model.points[model.points.len() - 2..]
            .iter()
            .all(|name| name.ends_with(".mark"))
    );
}
