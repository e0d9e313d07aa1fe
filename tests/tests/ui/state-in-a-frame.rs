use mbs_runtime::{Simulation, mechanism};

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    charge: State(rate = 1.0_rad_per_s),
    slide: Coordinate(0.0_m),
    cart: Body(mass = 1.0_kg, inertia = 1.0_kg_m2, frame = Frame([slide, 0.0_m], charge)),
});

fn main() {
    let _ = Simulation::new(Wrong::default());
}
