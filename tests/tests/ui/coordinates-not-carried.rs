use mbs_runtime::mechanism;

mechanism!(Bead {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    bead: Body(mass = 1.0_kg, inertia = 1.0_kg_m2, coordinates = Joint),
    wire: PointOnLine(bead.origin, ground.origin, axis = X),
});

fn main() {}
