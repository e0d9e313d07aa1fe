use mbs_runtime::{assembly, mechanism};

assembly!(Hook {
    world: Planar(),
    top: Port(Point),
    bar: Bar(mass = 1.0_kg, length = 0.3_kg),
    pin: Revolute(top, bar.a),
    weight: Output(1.0_kg + 9.81_N),
});

mechanism!(Crane {
    world: Planar(),
    left: Assembly(Hook, top = ground.origin),
    right: Assembly(Hook, top = ground.point(1.0_m, 0.0_m)),
});

fn main() {}
