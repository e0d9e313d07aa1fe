use mbs_runtime::mechanism;

mechanism!(DoublePendulum {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2], coordinates = Joint, budget = 300),
    upper: Body(mass = 1.0_kg, inertia = Sphere(0.1_m)),
    lower: Body(mass = 1.0_kg, inertia = Sphere(0.1_m), at = [1.0_m, 0.0, 0.0]),
    shoulder: Revolute(ground, upper, at = [-0.5, 0.0, 0.0], axis = Y),
    elbow: Revolute(upper, lower, at = [0.5, 0.0, 0.0], axis = Z),
});

fn main() {}
