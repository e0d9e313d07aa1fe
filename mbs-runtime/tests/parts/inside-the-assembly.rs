use mbs_runtime::{assembly, mechanism};

assembly!(Hook {
    world: Planar(),
    top: Port(Point),
    bar: Bar(mass = 1.0_kg, length = 0.3_m, lenght = 0.2_m),
    pin: Revolute(top, bar.a),
    weight: Force(bar.b, value = [0.0, force]),
});

mechanism!(Crane {
    world: Planar(),
    left: Assembly(Hook, top = ground.origin),
    right: Assembly(Hook, top = ground.point(1.0_m, 0.0_m)),
});

fn main() {}
