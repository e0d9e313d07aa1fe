use mbs_runtime::mechanism;

mechanism!(Pendulum {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Reference),
    rope: Bar(length = 1.0_m),
    bob: Particle(mass = 1.0_kg),
    pivot: Revolute(ground.origin, rope.a),
    knot: Revolute(rope.b, bob.origin),
});

fn main() {}
