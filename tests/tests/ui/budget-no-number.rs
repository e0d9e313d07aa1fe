use mbs_runtime::mechanism;

mechanism!(Pendulum {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], budget = 1e6),
    rod: Bar(mass = 1.0_kg, length = 1.0_m),
    pin: Revolute(ground.origin, rod.a),
});

fn main() {}
