use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),

    bob: Particle(mass = 1.0_kg),
    hinge: Revolute(ground.origin, bob, axis = Y),
});

fn main() {}
