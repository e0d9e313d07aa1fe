//! A corner of a car: a double wishbone on a chassis that heaves, a tyre on a road that the program moves, and a rack
//! that it steers.
//!
//! `cargo run --release -p mbs-parts --features large --example corner`

use mbs_parts::spatial::DoubleWishbone;
use mbs_runtime::{Simulation, SimulationError, mechanism};

/// The load of a tyre, N, from the height of its centre, m, its rate, radius, m, stiffness, N/m, and damping, N s/m.
fn tyre([height, rate, radius, stiffness, damping]: [f64; 5]) -> (f64, [f64; 5]) {
    let pressed = radius - height;
    let load = stiffness * pressed - damping * rate;
    match pressed > 0.0 && load > 0.0 {
        true => (load, [-stiffness, -damping, stiffness, pressed, -rate]),
        // In the air.
        false => (0.0, [0.0; 5]),
    }
}

mechanism!(Corner {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    radius: Param(0.3_m),
    tyre_stiffness: Param(200e3_N_per_m),
    tyre_damping: Param(500.0_N_s_per_m),
    road: Input(0.0_m),
    climb: Input(0.0_m_per_s),
    set_at: Input(0.0_s),
    steering: Input(0.0_m),
    chassis: Body(
        mass = 300.0_kg,
        inertia = Cuboid(1.0_m, 1.0_m, 0.4_m),
        at = [0.0_m, 0.0, 0.5]
    ),
    heave: Prismatic(ground, chassis, at = chassis.origin, axis = Z),
    rack: Body(
        mass = 2.0_kg,
        inertia = Cylinder(0.01_m, 0.5_m, Y),
        at = [-0.12_m, 0.35, 0.3]
    ),
    housing: Prismatic(chassis, rack, at = rack.origin, axis = Y),
    steer: Drive(housing.stroke, value = steering),
    front: Assembly(
        DoubleWishbone,
        chassis = chassis,
        at = [0.0_m, 0.75, 0.3],
        mount = chassis.point(0.0_m, 0.5, 0.2),
        rack = rack.origin,
        free_length = 0.68_m
    ),
    load: Let(law(
        tyre,
        front.upright.origin.z - road - climb * (t - set_at),
        front.upright.velocity.z - climb,
        radius,
        tyre_stiffness,
        tyre_damping
    )),
    contact: Force(front.upright.origin, value = load * ground.z),
    ride: Output(heave.stroke),
    travel: Output(front.upright.origin.z - chassis.origin.z),
    toe: Output(front.upright.y.x),
    camber: Output(front.upright.y.z),
    pressing: Output(load),
});

/// At rest on the road.
pub fn parked() -> Result<CornerSimulation, SimulationError> {
    let start = Simulation::start(Corner::default()).hold("ride", -0.03);
    let mut corner = start.begin()?;
    corner.run_until(3.0)?;
    Ok(corner)
}

/// On a road with a bump at 3 s, 5 cm high and 0.2 s long, set each millisecond.
pub fn drive(corner: &mut CornerSimulation, until: f64) -> Result<(), SimulationError> {
    let pulse = std::f64::consts::TAU / 0.2;
    while corner.time() < until {
        let t = corner.time();
        let phase = pulse * (t - 3.0).min(0.2);
        let mut inputs = corner.inputs_mut();
        inputs.road = 0.025 * (1.0 - phase.cos());
        inputs.climb = 0.025 * pulse * phase.sin();
        inputs.set_at = t;
        drop(inputs);
        corner.run_until(t + 1e-3)?;
    }
    Ok(())
}

fn main() -> Result<(), SimulationError> {
    let mut corner = parked()?;
    println!("  t, s  ride, mm  travel, mm  camber, °  load, N");
    for tenth in 31..=40 {
        drive(&mut corner, 0.1 * f64::from(tenth))?;
        let outputs = corner.outputs();
        let [ride, travel] = [outputs.ride, outputs.travel].map(|length| 1e3 * length);
        let camber = outputs.camber.asin().to_degrees();
        println!(
            "{:>6.1}  {ride:>8.1}  {travel:>10.1}  {camber:>9.2}  {:>7.0}",
            corner.time(),
            outputs.pressing
        );
    }
    Ok(())
}
