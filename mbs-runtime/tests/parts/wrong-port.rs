mbs_runtime::assembly!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    top: Port(Place),
    side: Port(),
    top: Port(Point, default = 1.0, value = 2.0),
    deny: Redundant(),
    bar: Bra(mass = 1.0_kg, length = 0.3_m),
});

fn main() {}
