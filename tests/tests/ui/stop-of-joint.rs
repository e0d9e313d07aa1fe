use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),

    body: Body(mass = 1.0_kg, inertia = 0.1_kg_m2, at = [1.0_m, 0.0, 0.0]),
    hinge: Revolute(ground, body, at = [0.0_m, 0.0, 0.0], axis = Y),
    end: Stop(hinge, upper = 3.0, stiffness = 5.0_Nm, onset = 2.0_deg),
});

fn main() {}
