//! An excavator in the plane: boom, stick and bucket on three cylinders, whose strokes follow a program of levers.
//!
//! `cargo run --release -p mbs-parts --features large --example excavator`

use mbs_parts::planar::Cylinder;
use mbs_runtime::{Simulation, SimulationError, mechanism};

mechanism!(Excavator {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    boom: Body(
        mass = 900.0_kg,
        inertia = 1800.0_kg_m2,
        center_of_mass = [2.0, 0.3],
        angle = 0.7
    ),
    stick: Body(
        mass = 400.0_kg,
        inertia = 250.0_kg_m2,
        center_of_mass = [0.6, 0.1],
        angle = -1.2
    ),
    bucket: Body(
        mass = 350.0_kg,
        inertia = 90.0_kg_m2,
        center_of_mass = [0.5, 0.1],
        angle = -2.0
    ),
    swivel: Revolute(ground.origin, boom.origin),
    elbow: Revolute(boom.point(4.0, 0.0), stick.origin),
    wrist: Revolute(stick.point(2.0, 0.0), bucket.origin),
    lift: Assembly(
        Cylinder,
        foot = ground.point(0.6, -0.4),
        head = boom.point(1.8, 0.4),
        angle = 1.3,
        closed = 1.9
    ),
    crowd: Assembly(
        Cylinder,
        foot = boom.point(1.8, 0.6),
        head = stick.point(-0.6, 0.3),
        angle = 0.65,
        closed = 2.7
    ),
    curl: Assembly(
        Cylinder,
        foot = stick.point(0.3, 0.4),
        head = bucket.point(-0.2, 0.35),
        angle = -1.2,
        closed = 1.8
    ),
    teeth: Output(bucket.point(1.2, 0.0)),
});

/// Moves the levers of lift, crowd and curl from now on: speeds, m/s.
pub fn pull(excavator: &mut ExcavatorSimulation, speeds: [f64; 3]) {
    let now = excavator.time();
    let inputs = &mut *excavator.inputs_mut();
    let cylinders = [&mut inputs.lift, &mut inputs.crowd, &mut inputs.curl];
    for (cylinder, speed) in cylinders.into_iter().zip(speeds) {
        cylinder.stroke += cylinder.speed * (now - cylinder.set_at);
        (cylinder.speed, cylinder.set_at) = (speed, now);
    }
}

fn main() -> Result<(), SimulationError> {
    let mut excavator = Simulation::new(Excavator::default())?;
    for speeds in [[-0.1, 0.1, 0.0], [0.1, -0.1, 0.1], [0.2, -0.1, 0.1]] {
        pull(&mut excavator, speeds);
        excavator.run_until(excavator.time() + 1.0)?;
        let force = 1e-3 * excavator.reaction("lift.oil", "force")?;
        let teeth = excavator.outputs().teeth;
        println!(
            "teeth at {:.2}, {:.2} m; boom {force:.1} kN",
            teeth.x, teeth.y
        );
    }
    Ok(())
}
