use mbs_runtime::nalgebra::Vector2;
use mbs_runtime::{Simulation, mechanism};

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    lever: Param(1.0_m),
    bar: Bar(mass = 1.0_kg, length = levre),
    pivot: Revolute(ground.origin, bar.a),
    half: Let(0.5 * (bar.a + bar.b)),
    tip: Output(bar.b),
    height: Output(bar.b.y),
    middle: Output(half - ground.origin),
    along: Output(bar.x),
    charge: State(rate = bar.rate),
});

/// Of a declaration that is wrong, its structs are there all the same: nothing is said about their use.
fn main() {
    let wrong = Wrong {
        lever: 2.0,
        ..Wrong::default()
    };
    println!("{}", wrong.lever);
    let simulation: WrongSimulation = Simulation::new(wrong).unwrap();
    let WrongOutputs { tip, height, middle, along, charge } = simulation.outputs();
    let mean: Vector2<f64> = 0.5 * (tip + middle);
    println!("{} {}", mean.x + height + charge, along.norm());
    println!("{} {}", simulation.positions().x, simulation.velocities()[2]);
}
