mbs_runtime::assembly!(Strut {
    world: Planar(),
    valve: Port(Table),
    bob: Particle(mass = 1.0_kg),
    spring: SpringDamper(ground.origin, bob.origin, damping = valve),
});

mbs_runtime::mechanism!(Wrong {
    world: Planar(),
    strut: Assembly(Strut, valve = 3.0_N_s_per_m),
});

fn main() {}
