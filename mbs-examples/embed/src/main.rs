//! A controller balances a pole on a cart, which a motor moves through a crank and a rod. It runs at 1 kHz, in real
//! time, with the simulated machine.

use mbs_runtime::{Settings, Simulation, SimulationError, mechanism};
use std::time::{Duration, Instant};

mechanism!(CartPole {
    doc: "A pole on a cart; crank, rod and rail close a loop.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    lean: Param(4.0_deg),
    motor_torque: Input(unit = Nm),

    crank: Bar(mass = 0.3_kg, length = 0.3_m, angle = 90.0_deg),
    rod: Bar(mass = 0.2_kg, length = 0.9_m, angle = 0.0_deg),
    cart: Particle(mass = 1.0_kg),
    pole: Bar(mass = 0.2_kg, length = 1.0_m, angle = 90.0_deg - lean),

    shaft: Revolute(ground.point(-0.9_m, -0.3_m), crank.a),
    crank_pin: Revolute(crank.b, rod.a),
    clevis: Revolute(rod.b, cart.origin),
    rail: PointOnLine(cart.origin, ground.origin, axis = X),
    hinge: Revolute(cart.origin, pole.a),

    motor: Torque(on = crank, value = motor_torque),

    cart_position: Output(cart.origin.x),
    cart_speed: Output(cart.velocity.x),
    pole_lean: Output(90.0_deg - pole.angle),
    pole_rate: Output(-pole.rate),
});

/// The period of the controller, which is the step of the simulation, s.
const PERIOD: f64 = 1e-3;

/// State feedback for small angles. The machine is, to first order,
///
///     a ẍ + b θ̈ = u,    b ẍ + c θ̈ = b g θ
///
/// with x the cart's position, θ the lean and u the force of the rod on the cart. So y = x + c/b θ satisfies ÿ = g θ,
/// and with u as feedback the controller has four poles at −ω.
struct Controller {
    a: f64,
    b: f64,
    c: f64,
    omega: f64,
}

impl Controller {
    const GRAVITY: f64 = 9.81;
    const CRANK_LENGTH: f64 = 0.3;

    fn new() -> Self {
        let (cart, pole, length, rod, crank) = (1.0, 0.2, 1.0, 0.2, 0.3);
        Controller {
            a: cart + pole + rod + crank / 3.0,
            b: pole * length / 2.0,
            c: pole * length * length / 3.0,
            omega: 4.0,
        }
    }

    /// The torque of the motor, N m.
    fn torque(&self, position: f64, speed: f64, lean: f64, rate: f64) -> f64 {
        let Controller { a, b, c, omega } = self;
        let g = Self::GRAVITY;
        let y = [
            position + c / b * lean,
            speed + c / b * rate,
            g * lean,
            g * rate,
        ];
        let fourth = -(omega.powi(4) * y[0]
            + 4.0 * omega.powi(3) * y[1]
            + 6.0 * omega.powi(2) * y[2]
            + 4.0 * omega * y[3]);
        let force = a * g * lean - (a * c - b * b) / (b * g) * fourth;
        // The crank is vertical: a force to the right is a clockwise torque.
        -Self::CRANK_LENGTH * force
    }
}

/// The results.
struct Outcome {
    lean: f64,
    position: f64,
    widest: f64,
    late: u32,
}

/// Balances for some seconds; with `real_time` each period takes its real time.
fn balance(seconds: f64, real_time: bool) -> Result<Outcome, SimulationError> {
    // Without placement every step has the length of the period, in every pose.
    let settings = Settings {
        step: PERIOD,
        placement: false,
        ..Settings::default()
    };
    let mut machine = Simulation::with_settings(CartPole::default(), settings)?;
    let controller = Controller::new();

    let start = Instant::now();
    let (mut widest, mut late) = (0.0_f64, 0);
    for tick in 0..(seconds / PERIOD).round() as u32 {
        let sensors = machine.outputs();
        let torque = controller.torque(
            sensors.cart_position,
            sensors.cart_speed,
            sensors.pole_lean,
            sensors.pole_rate,
        );
        machine.inputs_mut().motor_torque = torque;
        machine.step()?;

        widest = widest.max(sensors.cart_position.abs());
        if real_time {
            let deadline = start + (tick + 1) * Duration::from_secs_f64(PERIOD);
            match deadline.checked_duration_since(Instant::now()) {
                Some(left) => std::thread::sleep(left),
                None => late += 1,
            }
        }
    }
    let end = machine.outputs();
    Ok(Outcome {
        lean: end.pole_lean,
        position: end.cart_position,
        widest,
        late,
    })
}

fn main() -> Result<(), SimulationError> {
    let outcome = balance(5.0, true)?;
    println!(
        "the pole leans by {:.1e} rad, the cart stands at {:.1e} m",
        outcome.lean, outcome.position
    );
    println!(
        "on the way it went up to {:.3} m; {} of 5000 periods were late",
        outcome.widest, outcome.late
    );
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pole_stands() -> Result<(), SimulationError> {
        let outcome = balance(5.0, false)?;
        assert!(outcome.lean.abs() < 1e-4, "{} rad", outcome.lean);
        assert!(outcome.position.abs() < 1e-3, "{} m", outcome.position);
        assert!(outcome.widest < 0.2, "{} m", outcome.widest);
        Ok(())
    }

    #[test]
    fn it_falls_without_a_motor() -> Result<(), SimulationError> {
        let mut machine = Simulation::new(CartPole::default())?;
        let mut most: f64 = 0.0;
        while machine.time() < 2.0 {
            machine.step()?;
            most = most.max(machine.outputs().pole_lean.abs());
        }
        assert!(most > 1.0, "{most} rad");
        Ok(())
    }

    #[test]
    fn real_time_takes_its_time() -> Result<(), SimulationError> {
        let start = Instant::now();
        balance(0.05, true)?;
        assert!(start.elapsed() >= Duration::from_millis(49));
        Ok(())
    }
}
