//! A slider-crank that a speed controller drives, as the program of a microcontroller runs it: a thousand steps of a
//! millisecond.

#![no_std]

use core::fmt;
use mbs_runtime::{FixedStepSimulation, Settings, SimulationError, mechanism};

mechanism!(SliderCrank {
    doc: "A crank that a motor turns, and a rod that slides.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    motor_torque: Input(unit = Nm),

    crank: Bar(
        mass = 1.0_kg,
        length = 0.15_m,
        angle = 60.0_deg,
        rate = 10.0_rad_per_s
    ),
    rod: Bar(mass = 0.5_kg, length = 0.4_m, angle = -20.0_deg),

    main_bearing: Revolute(ground.origin, crank.a),
    crank_pin: Revolute(crank.b, rod.a),
    liner: PointOnLine(rod.b, ground.origin, axis = X),

    motor: Torque(on = crank, value = motor_torque),
    gas: Force(
        on = rod.b,
        value = [-20.0_N * (1.0 + sin(rod.b.x / 0.1_m)), 0.0]
    ),

    stroke: Output(rod.b.x),
    speed: Output(crank.rate),
    angle: Output(crank.angle),
});

/// Steps of a run.
pub const STEPS: u32 = 1000;

/// The period of the controller and the step, s.
pub const PERIOD: f64 = 1e-3;

/// The wanted speed of the crank, rad/s, and the torque for a deviation from it, N m s.
const SPEED: f64 = 12.0;
const GAIN: f64 = 0.8;

/// What a run ends with.
pub struct Outcome {
    /// Its values at the end.
    pub outputs: SliderCrankOutputs,
    /// What the energy balance lacks at the end, J.
    pub energy_error: f64,
    /// Counts of the clock for all steps …
    pub total: u32,
    /// … and for the longest one.
    pub longest: u32,
}

/// The values with all their digits: equal texts are equal bits.
impl fmt::Display for Outcome {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(out, "stroke {:?} m", self.outputs.stroke)?;
        writeln!(out, "speed {:?} rad/s", self.outputs.speed)?;
        writeln!(out, "angle {:?} rad", self.outputs.angle)?;
        writeln!(out, "energy error {:?} J", self.energy_error)
    }
}

/// Runs the loop; `clock` counts upwards.
///
/// # Errors
/// As [`FixedStepSimulation::new`] and [`FixedStepSimulation::step`].
pub fn run(clock: impl Fn() -> u32) -> Result<Outcome, SimulationError> {
    let settings = Settings {
        step: PERIOD,
        ..Settings::default()
    };
    let mut plant: SliderCrankFixedStepSimulation =
        FixedStepSimulation::new(SliderCrank::default(), settings)?;
    let (mut total, mut longest) = (0, 0);
    for _ in 0..STEPS {
        let motor_torque = GAIN * (SPEED - plant.outputs().speed);
        let before = clock();
        plant.set_inputs(SliderCrankInputs { motor_torque })?;
        plant.step()?;
        let taken = clock().wrapping_sub(before);
        total += taken;
        longest = longest.max(taken);
    }
    Ok(Outcome {
        outputs: plant.outputs(),
        energy_error: plant.energy().error,
        total,
        longest,
    })
}
