use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Spatial(),

    load: Param(1.0),
    body: Body(mass = 1.0_kg, inertia = 0.1_kg_m2 * law(density, load)),
    pivot: Revolute(ground, body, at = [0.0, 0.0, 0.0], axis = X),
});

fn main() {}
