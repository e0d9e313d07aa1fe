use mbs_runtime::mechanism;

mechanism!(Pendulum {
    world: Planar(),
    rod: Bar(mass = 1.0_kg, length = 1.0_m, angle = Exactly(0.4_m)),
    pivot: Revolute(ground.origin, rod.a),
});

fn main() {}
