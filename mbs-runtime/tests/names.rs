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

/// The module has names of the generated code, and none of the standard prelude.
mod bare {
    #![no_implicit_prelude]

    const MODEL: f64 = 0.5;

    pub trait Turned {
        fn into(self) -> f64;
    }
    impl<T> Turned for T {
        fn into(self) -> f64 {
            0.0
        }
    }

    ::mbs_runtime::mechanism!(pub Top {
        world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
        length: Param(MODEL, nominal = 1.0_m),
        push: Input(0.0_N),
        top: Body(mass = 1.0_kg, inertia = 0.1_kg_m2),
        tip: Spherical(ground.origin, top.origin),
        pull: Force(top.origin, value = [push, 0.0, 0.0]),
        place: Output(top.point(length, 0.0, 0.0)),
    });
}

#[test]
fn generated_code_brings_its_own_names() {
    assert_eq!(bare::Top::default().length, 0.5);
    assert!(Simulation::new(bare::Top::default()).is_ok());
}

macro_rules! leg {
    () => {
        ::mbs_runtime::assembly!(pub Leg {
            world: Planar(),
            hip: Port(Point),
            bar: Bar(mass = 1.0_kg, length = 1.0_m),
            pin: Revolute(hip, bar.a),
        });
    };
}
mod left {
    leg!();
}
mod right {
    leg!();
}

mechanism!(Walker {
    world: Planar(),
    first: Assembly(left::Leg, hip = ground.point(0.0, 0.0)),
    second: Assembly(right::Leg, hip = ground.point(1.0_m, 0.0)),
});

#[test]
fn a_macro_may_declare_an_assembly_in_several_modules() {
    assert!(Simulation::new(Walker::default()).is_ok());
}
