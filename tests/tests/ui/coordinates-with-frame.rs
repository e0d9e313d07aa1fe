use mbs_runtime::mechanism;

mechanism!(Pendulum {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    turn: Coordinate(0.1_rad),
    bar: Bar(mass = 1.0_kg, length = 1.0_m, frame = Frame([0.0, 0.0], turn), coordinates = Joint),
});

fn main() {}
