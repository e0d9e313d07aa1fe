use mbs_runtime::{Simulation, mechanism};

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    lever: Param(1.0_m),
    bar: Bar(mass = 1.0_s, length = lever),
    pivot: Revolute(ground.orign, bar.a),
    out: Output(bar.b),
});

fn main() {
    let _ = Simulation::new(Wrong { lever: 2.0 });
}
