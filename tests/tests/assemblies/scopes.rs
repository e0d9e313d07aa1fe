//! What names mean in an assembly: in its entries, in what it is given, and in the defaults of its ports.

use mbs_runtime::{Simulation, assembly, mechanism};

assembly!(Truck {
    world: Planar(),
    gauge: Port(Number),
    wheel: Each([-1.0, 1.0], |side| Particle(
        mass = 1.0_kg,
        at = [side * gauge, 0.0_m],
        free = true
    )),
    at: Each(0..2, |i| Output(wheel[i].origin.x)),
});

mechanism!(Wide {
    world: Planar(),
    side: Param(0.7_m),
    truck: Assembly(Truck, gauge = side),
});

#[test]
fn a_value_given_keeps_its_meaning_inside_a_family() {
    let simulation = Simulation::new(Wide::default()).expect("it assembles");
    assert_eq!(simulation.outputs().truck.at, [-0.7, 0.7]);
}

/// Friction that grows with the velocity; the value and the slopes.
fn damping([_, velocity, k]: [f64; 3]) -> (f64, [f64; 3]) {
    (k * velocity, [0.0, k, velocity])
}

assembly!(Brake {
    world: Planar(),
    own: Param(2.0),
    length: Param(value = 2.0_m),
    unit: Port(Number, default = length),
    law: Port(Number, default = unit / 2.0),
    wheel: Body(mass = 1.0_kg, inertia = 1.0_kg_m2, rate = 1.0_rad_per_s),
    axle: Revolute(ground.point(unit, law), wheel.origin),
    brake: TorsionSpring(ground, wheel, law = damping(own)),
    place: Output(wheel.origin),
    slowing: Output(rate(wheel.rate)),
});

assembly!(Pair {
    world: Planar(),
    far: Port(Number, default = 30.0_m),
    one: Assembly(Brake, unit = far),
    two: Each(0..2, |i| Assembly(Brake, law = far, length = i * 5.0_m)),
});

mechanism!(Brakes {
    world: Planar(),
    own: Param(700.0),
    length: Param(100.0_m),
    one: Assembly(Brake, length = 7.0_m),
    pair: Assembly(Pair),
    used: Output(own * length),
});

#[test]
fn an_assembly_has_names_of_its_own() {
    let simulation = Simulation::new(Brakes::default()).expect("it assembles");
    let outputs = simulation.outputs();
    // Arguments of a law are those of the assembly, and so are the defaults of ports.
    assert_eq!(outputs.one.slowing, -2.0);
    assert_eq!(outputs.one.place.as_slice(), [7.0, 3.5]);
    // Ports may have the names of arguments with words.
    assert_eq!(outputs.pair.one.place.as_slice(), [30.0, 15.0]);
    assert_eq!(outputs.pair.two[1].place.as_slice(), [5.0, 30.0]);
}

mod places {
    use mbs_runtime::{Simulation, assembly, mechanism};

    pub mod left {
        mbs_runtime::assembly!(pub(crate) Wheel {
            world: Planar(),
            size: Param(1.0_m),
            rim: Particle(mass = 1.0_kg, at = [size, 0.0_m], free = true),
        });
    }

    pub mod right {
        mbs_runtime::assembly!(pub(crate) Wheel {
            world: Planar(),
            size: Param(1.0_m),
            rim: Particle(mass = 1.0_kg, at = [size, 0.0_m], free = true),
        });
    }

    assembly!(pub(super) Axle {
        world: Planar(),
        wheel: Assembly(crate::assemblies::scopes::places::left::Wheel, size = 2.0_m),
        wheels: Each(0..2, |i| Assembly(
            super::places::right::Wheel,
            size = (3.0 + i) * 1.0_m
        )),
    });

    mechanism!(Cart {
        world: Planar(),
        axle: Assembly(Axle),
        at: Output(axle.wheel.rim.origin.x),
        far: Output(axle.wheels[1].rim.origin.x),
    });

    #[test]
    fn assemblies_of_a_crate_are_found_by_their_paths() {
        let cart = Simulation::new(Cart::default()).expect("it assembles");
        assert_eq!(cart.outputs().far, 4.0);
        assert_eq!(cart.outputs().at, 2.0);
    }
}

#[test]
fn an_assembly_of_a_function() {
    assembly!(Local {
        world: Planar(),
        p: Particle(mass = 1.0_kg, at = [3.0_m, 0.0_m], free = true),
    });
    mechanism!(Here {
        world: Planar(),
        a: Assembly(Local),
        at: Output(a.p.origin.x),
    });
    let simulation = Simulation::new(Here::default()).expect("it assembles");
    assert_eq!(simulation.outputs().at, 3.0);
}

/// What a macro gives on.
macro_rules! made {
    ($visibility:vis $name:ident, $free:expr, $coordinates:expr, $list:expr, $closure:expr, $path:path, $sum:expr, $call:expr) => {
        mechanism!($visibility $name {
            world: Planar(coordinates = $coordinates),
            size: Param($list),
            p: Each(0..3, $closure),
            q: Particle(mass = 1.0_kg, at = [size[1], 2.0 * $sum], free = $free),
            a: Assembly($path, gauge = $sum),
            at: $call,
        });
    };
}

made!(
    pub(crate) Made,
    true,
    Reference,
    [1.0_m, 2.0_m],
    |i| Particle(mass = 1.0_kg, at = [i * 1.0_m, size[0]], free = true),
    self::Truck,
    1.0_m + 2.0_m,
    Output([q.origin.y, a.wheel[1].origin.x])
);

#[test]
fn a_macro_may_write_a_mechanism() {
    let simulation = Simulation::new(Made::default()).expect("it assembles");
    assert_eq!(simulation.outputs().at.as_slice(), [6.0, 3.0]);
}
