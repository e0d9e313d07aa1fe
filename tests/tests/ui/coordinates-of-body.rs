use mbs_runtime::mechanism;

mechanism!(Pendulum {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    body: Body(mass = 1.0_kg, inertia = 1.0_kg_m2, coordinates = Natural),
    pivot: Revolute(ground.origin, body.origin),
});

fn main() {}
