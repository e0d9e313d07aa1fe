use mbs_runtime::mechanism;

mechanism!(Pendulum {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    bar: Bar(mass = 1.0_kg, length = 1.0_m, coordinates = Natural),
    pivot: Revolute(ground.origin, bar.a),
    spring: TorsionSpring(ground, bar, stiffness = 1.0_Nm),
});

fn main() {}
