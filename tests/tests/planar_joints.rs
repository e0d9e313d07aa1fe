//! Joints of the plane: `angle`, `rate`, `stroke` and `speed`, and forces in joints, in all descriptions, against closed
//! forms.

use mbs_runtime::{AnySimulation, Mechanism, Settings, Simulation, System, mechanism};

/// A declaration in each of the descriptions.
macro_rules! each {
    ($name:ident, $($entries:tt)*) => {
        mod natural {
            use super::mechanism;
            mechanism!($name { world: Planar(coordinates = Natural), $($entries)* });
        }
        mod reference {
            use super::mechanism;
            mechanism!($name { world: Planar(coordinates = Reference), $($entries)* });
        }
        mod joint {
            use super::mechanism;
            mechanism!($name { world: Planar(coordinates = Joint), $($entries)* });
        }
    };
}

// Bars of 1 kg m² about their ends.
each!(Shop,
    wheel: Bar(mass = 3.0_kg, length = 1.0_m, angle = 0.5, rate = 20.0_rad_per_s),
    bearing: Revolute(ground.origin, wheel.a),
    motor: Torque(bearing, value = 2.0_N_m),
    disk: Body(mass = 1.0_kg, inertia = 0.1_kg_m2, angle = 7.0, rate = -10.0_rad_per_s),
    pin: Revolute(disk.origin, wheel.a),

    balance: Bar(mass = 3.0_kg, length = 1.0_m, angle = 20.0),
    pivot: Revolute(balance.a, ground.point(3.0, 0.0)),
    hair: TorsionSpring(pivot, stiffness = 4.0_N_m),

    sledge: Body(mass = 2.0_kg, inertia = 0.1_kg_m2, at = [0.06, 0.08]),
    guide: Prismatic(ground.origin, sledge.origin, axis = [0.6, 0.8]),
    push: Force(guide, value = 4.0_N),

    four: Event(wheel.angle - 4.5),
    twelve: Event(bearing.angle - 12.5),
    turned: Output(bearing.angle),
    turning: Output(bearing.rate),
    apart: Output(pin.angle),
    parting: Output(rate(pin.angle)),
    wound: Output(pivot.angle),
    stroke: Output(guide.stroke),
    speed: Output(guide.speed),
);

fn shop<M, S, const Q: usize, const N: usize, const R: usize>()
where
    M: Mechanism<System = S> + Default,
    S: System<Q, N, R>,
{
    let settings = Settings {
        step: 4e-3,
        order: 6,
        ..Settings::default()
    };
    let mut simulation =
        Simulation::<S, Q, N, R>::with_settings(M::default(), settings).expect("it assembles");
    // Measured: 1.4e-9 at most.
    let rounding = 1e-8;
    let expect = |simulation: &dyn AnySimulation| {
        let t = simulation.time();
        let wheel = [0.5 + 20.0 * t + t * t, 20.0 + 2.0 * t];
        for (name, value) in [
            ("turned", wheel[0]),
            ("turning", wheel[1]),
            ("apart", wheel[0] - 7.0 + 10.0 * t),
            ("parting", wheel[1] + 10.0),
            ("wound", -20.0 * (2.0 * t).cos()),
            ("stroke", 0.1 + t * t),
            ("speed", 2.0 * t),
        ] {
            let mut outputs = M::MODEL.outputs.iter();
            let index = outputs.position(|output| output.name == name);
            let found = simulation.output_values()[index.expect(name)];
            assert!(
                (found - value).abs() < rounding,
                "{name} at {t}: {found}, {value}"
            );
        }
    };
    expect(&simulation);
    for (event, turn) in [("four", 4.0), ("twelve", 12.0)] {
        simulation.run_to_event(event, 1.0).expect("it fires");
        // 20 t + t² = turn.
        let t = -10.0 + f64::sqrt(100.0 + turn);
        assert!(
            (simulation.time() - t).abs() < rounding,
            "{}",
            simulation.time()
        );
        expect(&simulation);
    }
    for time in [0.7013, 0.8537] {
        simulation.run_past(time, 1.0).expect("it runs");
        let look = &mut |simulation: &dyn AnySimulation| expect(simulation);
        simulation
            .look_at(time, look)
            .expect("it is in the last step");
    }
    simulation.run_until(1.0).expect("it runs");
    expect(&simulation);
}

#[test]
fn joints_of_points_count_turns() {
    shop::<natural::Shop, _, _, _, _>();
}

#[test]
fn joints_of_bodies_count_turns() {
    shop::<reference::Shop, _, _, _, _>();
}

#[test]
fn joints_that_are_coordinates_count_turns() {
    shop::<joint::Shop, _, _, _, _>();
}

/// The wheel has no angle among its coordinates; that is stored beside them, and saved with them.
#[test]
fn a_saved_state_has_the_turns() {
    let new = || Simulation::new(natural::Shop::default()).expect("it assembles");
    let mut first = new();
    first.run_until(0.7).expect("it runs");
    let state = first.state().clone();
    let mut second = Simulation::resume(natural::Shop::default(), Settings::default(), state)
        .expect("it goes on");
    for simulation in [&mut first, &mut second] {
        simulation.run_until(0.9).expect("it runs");
    }
    assert!(first.outputs().turned > 18.0);
    assert_eq!(first.outputs().turned, second.outputs().turned);
}

/// A start holds the angle of a bar without angle, also beyond half a turn.
#[test]
fn a_start_holds_turns() {
    let start = Simulation::start(natural::Shop::default()).hold("turned", 9.0);
    let shop: natural::ShopSimulation = start.begin().expect("it is held");
    assert!((shop.outputs().turned - 9.0).abs() < 1e-9);
}
