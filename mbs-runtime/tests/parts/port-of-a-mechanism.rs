mbs_runtime::mechanism!(Wrong {
    world: Planar(),
    top: Port(Point),
    bar: Bar(mass = 1.0_kg, length = 0.3_m),
    pin: Revolute(top, bar.a),
});

fn main() {}
