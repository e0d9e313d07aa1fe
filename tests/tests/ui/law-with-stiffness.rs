use mbs_runtime::mechanism;

fn tension(x: [f64; 2]) -> (f64, [f64; 2]) {
    (x[0], [1.0, 0.0])
}

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    bar: Bar(mass = 1.0_kg, length = 1.0_m),
    spring: SpringDamper(
        ground.origin,
        bar.a,
        stiffness = 1.0_N_per_m,
        law = tension
    ),
});

fn main() {}
