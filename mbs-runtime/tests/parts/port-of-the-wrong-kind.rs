use mbs_parts::planar::FourBar;

mbs_runtime::mechanism!(Wrong {
    world: Planar(),
    base: Body(mass = 1.0_kg, inertia = 0.1_kg_m2, free = true),
    linkage: Assembly(FourBar, left = base, right = ground.point(0.7_m, 0.0_m)),
});

fn main() {}
