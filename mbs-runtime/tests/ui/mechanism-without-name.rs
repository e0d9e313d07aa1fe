use mbs_runtime::mechanism;

mechanism!({
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
});

fn main() {}
