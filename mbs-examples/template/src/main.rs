//! A mechanism of your own: declared, recorded, and saved as a table, diagrams and an animation.

use mbs_runtime::{Mechanism, Simulation, mechanism};

mechanism!(FourBar {
    doc: "A four-bar linkage whose crank is driven by a motor.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    /// Distance of the two bearings.
    base: Param(0.8_m),
    motor: Input(2.0_N_m),

    crank: Bar(mass = 0.5_kg, length = 0.2_m, angle = 90.0_deg),
    coupler: Bar(mass = 1.0_kg, length = 0.7_m, angle = 20.0_deg),
    rocker: Bar(mass = 1.0_kg, length = 0.5_m, angle = 110.0_deg),

    crank_bearing: Revolute(ground.origin, crank.a),
    crank_pin: Revolute(crank.b, coupler.a),
    rocker_bearing: Revolute(ground.point(base, 0.0_m), rocker.a),
    rocker_pin: Revolute(coupler.b, rocker.b),

    drive: Torque(on = crank, value = motor - 0.1_N_m_s * crank.rate),

    rocker_angle: Output(rocker.angle),
    crank_rate: Output(crank.rate),
});

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("{}", FourBar::MODEL.explain());

    // Position errors of about 1e-6 of the size of the mechanism: method, order and steps follow from that.
    let mut simulation = Simulation::with_accuracy(FourBar::default(), 1e-6)?;
    let recording = simulation.record(3.0).every(0.01).progress_bar().run()?;
    recording.save("out/four-bar")?;

    let report = simulation.report();
    println!("out/four-bar has motion.html, trajectory.csv and diagrams");
    println!("energy error {:.1e} J", report.energy_error);
    println!(
        "force in the rocker's bearing: {:.2} N upwards",
        simulation.reaction("rocker_bearing", "fy")?
    );
    Ok(())
}
