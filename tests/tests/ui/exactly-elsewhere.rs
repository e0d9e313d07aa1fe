use mbs_runtime::mechanism;

mechanism!(Pendulum {
    world: Planar(),
    rod: Bar(mass = Exactly(1.0_kg), length = 1.0_m),
    pivot: Revolute(ground.origin, rod.a),
});

fn main() {}
