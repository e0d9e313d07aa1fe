//! `State`: values with a rate of their own.

mod motion;
mod names;
mod scales;

use mbs_runtime::{Mechanism, Settings, Simulation, System, mechanism};

/// A slider-crank whose motor keeps a speed, by a sensor with a delay.
macro_rules! engine {
    ($name:ident, $coordinates:ident) => {
        mechanism!($name {
            world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = $coordinates),
            wanted: Param(8.0_rad_per_s),
            delay: Param(0.05_s),
            crank: Bar(
                mass = 1.0_kg,
                length = 0.3_m,
                angle = Exactly(40.0_deg),
                rate = Exactly(2.0_rad_per_s)
            ),
            rod: Bar(mass = 0.5_kg, length = 0.8_m),
            bearing: Revolute(ground.origin, crank.a),
            pin: Revolute(crank.b, rod.a),
            guide: PointOnLine(rod.b, ground.origin, axis = X),
            /// What the sensor shows.
            seen: State(initial = 2.0_rad_per_s, rate = (crank.rate - seen) / delay),
            /// The integral of the controller.
            charge: State(rate = wanted - seen),
            motor: Torque(crank, value = 2.0_Nm_s * (wanted - seen) + 3.0_Nm * charge),
            speed: Output(crank.rate),
        });
    };
}

engine!(Engine, Auto);
engine!(ByJoints, Joint);

/// A run of so many steps.
fn run<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: M,
    settings: Settings,
    time: f64,
    steps: u32,
) -> Simulation<S, Q, N, R>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let settings = Settings {
        step: time / f64::from(steps),
        placement: false,
        ..settings
    };
    let mut simulation = Simulation::with_settings(mechanism, settings).expect("a start");
    simulation.run_until(time).expect("a run");
    simulation
}

fn order(order: u8) -> Settings {
    Settings {
        order,
        ..Settings::default()
    }
}

fn values(engine: &EngineSimulation) -> [f64; 3] {
    let outputs = engine.outputs();
    [outputs.speed, outputs.seen, outputs.charge]
}

fn apart(one: [f64; 3], other: [f64; 3]) -> f64 {
    let apart = one.iter().zip(other).map(|(a, b)| (a - b).abs());
    apart.fold(0.0, f64::max)
}
