use mbs_runtime::mechanism;

mechanism!(Door {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2], coordinates = Joint),
    height: Param(1.8_m),
    leaf: Body(mass = 20.0_kg, inertia = Cuboid(0.9_m, 0.04_m, 2.0_m), at = [0.45, 0.0, 1.0]),
    lower: Revolute(ground, leaf, at = [0.0, 0.0, 0.2], axis = Z),
    upper: Revolute(ground.point(0.0, 0.0, height), leaf.point(-0.45, 0.0, 0.8), axis = Z),
});

fn main() {}
