use mbs_runtime::{Simulation, mechanism};

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    corner: Point([1.0_m, 0.0_m]),
    bar: Bar(mass = 1.0_kg, length = 1.0_m),
    pivot: Revolute(ground.origin, bar.a),
    far: Revolute(corner, bar.b),
});

fn main() {
    let _ = Simulation::new(Wrong::default());
}
