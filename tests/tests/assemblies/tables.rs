//! Tables of assemblies, and tables given to them.

use mbs_runtime::{Mechanism, Simulation, assembly, mechanism};

assembly!(Strut {
    doc: "A mass on a measured spring and damper.",
    world: Planar(),
    foot: Port(Point),
    valve: Port(Table),
    coil: Table([-0.2_m, 0.0_m, 0.3_m], [-30.0_N, 0.0_N, 20.0_N]),
    wind: Each(0..2, |i| Table(
        [0.0_s, 1.0_s, 2.0_s],
        [0.0_N, 1.0_N + i * 1.0_N, 0.5_N]
    )),
    bob: Particle(mass = 1.0_kg, at = [0.2_m, -0.6_m]),
    spring: SpringDamper(
        foot,
        bob.origin,
        law = coil,
        damping = valve,
        length = 0.5_m
    ),
    gust: Each(0..2, |i| Force(
        bob.origin,
        value = [wind[i](t) + 0.1 * coil(bob.origin.x), 0.0]
    )),
    drag: Force(bob.origin, value = [0.0, -valve(bob.velocity.y)]),
});

mechanism!(Two {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    oil: Table(
        [-1.0_m_per_s, 0.0_m_per_s, 2.0_m_per_s],
        [-0.4_N, 0.0_N, 0.3_N]
    ),
    strut: Each(0..2, |i| Assembly(
        Strut,
        foot = ground.point(1.0_m * i, 0.0_m),
        valve = oil
    )),
    force: Output(strut[1].coil(strut[0].bob.origin.x)),
    gust: Output(strut[0].wind[1](t)),
});

mechanism!(One {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    oil: Table(
        [-1.0_m_per_s, 0.0_m_per_s, 2.0_m_per_s],
        [-0.4_N, 0.0_N, 0.3_N]
    ),
    coil: Table([-0.2_m, 0.0_m, 0.3_m], [-30.0_N, 0.0_N, 20.0_N]),
    weak: Table([0.0_s, 1.0_s, 2.0_s], [0.0_N, 1.0_N, 0.5_N]),
    strong: Table([0.0_s, 1.0_s, 2.0_s], [0.0_N, 2.0_N, 0.5_N]),
    bob: Particle(mass = 1.0_kg, at = [0.2_m, -0.6_m]),
    spring: SpringDamper(
        ground.origin,
        bob.origin,
        law = coil,
        damping = oil,
        length = 0.5_m
    ),
    gust: Force(
        bob.origin,
        value = [weak(t) + strong(t) + 0.2 * coil(bob.origin.x), 0.0]
    ),
    drag: Force(bob.origin, value = [0.0, -oil(bob.velocity.y)]),
    force: Output(coil(bob.origin.x)),
    gusts: Output(strong(t)),
});

#[test]
fn tables_of_an_assembly_are_those_of_a_mechanism() {
    let mut two = Simulation::new(Two::default()).expect("it assembles");
    let mut one = Simulation::new(One {}).expect("it assembles");
    two.run_until(1.7).expect("it runs");
    one.run_until(1.7).expect("it runs");
    let (two, one) = (two.outputs(), one.outputs());
    assert!((two.force - one.force).abs() < 1e-9);
    assert!((two.gust - one.gusts).abs() < 1e-14);
    assert_eq!(Two::MODEL.parts[1].name, "strut[1].bob");
}
