use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    wanted: Input(unit = rad),
    fast: Input(unit = m_per_s),
    bar: Bar(mass = 1.0_kg, length = 1.0_m),
    pivot: Revolute(ground.origin, bar.a),
    turn: Drive(bar.angle, value = wanted, rate = fast, since = 0.0_s),
});

fn main() {}
