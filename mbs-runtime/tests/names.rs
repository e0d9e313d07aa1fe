//! Names of a declaration do not meet those of the module that it stands in.
#![allow(dead_code, non_snake_case, non_upper_case_globals)]

use mbs_runtime::{Simulation, mechanism};

const LOAD: f64 = 1.0;
const load: f64 = 1.0;
struct Slide;

mechanism!(Crane {
    world: Planar(),

    None: Input(0.0_N),
    LOAD: Input(0.0_N),
    load: Input(0.0_N),
    Some: Coordinate(0.0_m),
    Slide: Coordinate(0.1_rad),
    cart: Body(
        mass = 1.0_kg,
        inertia = 1.0_kg_m2,
        frame = Frame([Some, 0.0], Slide)
    ),
    push: Force(cart.origin, value = [None + LOAD, load]),
});

mechanism!(CraneSystem {
    world: Planar(),

    bar: Bar(mass = 1.0_kg, length = 1.0_m),
    pivot: Revolute(ground.origin, bar.a),
});

#[test]
fn names_of_the_module_are_not_patterns() {
    let mut simulation: CraneSimulation = Simulation::new(Crane::default()).unwrap();
    simulation.inputs_mut().LOAD = 1.0;
    assert_eq!(simulation.inputs().LOAD, 1.0);
    assert_eq!(simulation.inputs().None, 0.0);
    let _: CraneSystemSimulation = Simulation::new(CraneSystem::default()).unwrap();
}
