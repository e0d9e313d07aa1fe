use mbs_runtime::mechanism;

mechanism!(Pendulum {
    world: Planar(),
    rod: Bar(mass = 1.0_kg, length = 1.0_m, angle = 0.2 + Exactly(0.4_rad)),
    pivot: Revolute(ground.origin, rod.a),
});

fn main() {}
