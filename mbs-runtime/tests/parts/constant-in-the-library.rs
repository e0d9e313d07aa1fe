use mbs_parts::spatial::Leg;

// A leg has a direction.
mbs_runtime::mechanism!(Wrong {
    world: Spatial(),
    plate: Body(mass = 1.0_kg, inertia = 0.1_kg_m2, at = [0.0_m, 0.0, 1.0]),
    leg: Assembly(
        Leg,
        base = ground,
        platform = plate,
        foot = [0.0_m, 0.0, 0.0],
        head = [0.0_m, 0.0, 0.0]
    ),
});

fn main() {}
