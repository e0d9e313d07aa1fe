use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    mass: Param(1.0_kg),
    out: Output(mass),
});

fn main() {}
