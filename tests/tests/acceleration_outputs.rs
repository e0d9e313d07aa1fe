//! Outputs that read accelerations and reactions, in all descriptions.

use crate::alloc::count;
use mbs_runtime::{Mechanism, Observables, Settings, Simulation, System};

/// A declaration with one coordinate for each freedom of a joint, and with rows.
macro_rules! both {
    ($module:ident: $name:ident in $world:ident, $($entries:tt)*) => {
        mod $module {
            pub mod natural {
                mbs_runtime::mechanism!($name { world: $world(coordinates = Natural), $($entries)* });
            }
            pub mod joint {
                mbs_runtime::mechanism!($name { world: $world(coordinates = Joint), $($entries)* });
            }
        }
    };
}

both!(presses: Press in Planar,
    crank: Bar(mass = 0.36_kg, length = 0.15_m, angle = Exactly(0.7), rate = Exactly(9.0_rad_per_s)),
    rod: Bar(mass = 0.15_kg, length = 0.40_m, angle = -0.24),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),
    drag: SpringDamper(rod.b, ground.point(2.0_m, 0.0), stiffness = 3.0_N_per_m, length = 1.0_m, damping = 0.4_N_s_per_m),
    seconds: Param(1.0_s),
    wound: State(initial = 1.0, rate = 0.5 * bearing.rate),
    winding: Output(rate(wound)),
    load: Output(hypot(pin.reaction.fx, pin.reaction.fy)),
    side: Output(guide.reaction.fy),
    velocity: Output(rod.b.velocity),
    acceleration: Output(rod.b.acceleration),
    center: Output(rod.point(0.2_m, 0.0).acceleration.y - rate(rod.point(0.2_m, 0.0).velocity.y)),
    turning: Output(bearing.rate),
    spin: Output(rate(bearing.rate)),
    same: Output(rate(crank.rate)),
    mixed: Output(crank.angle + rate(crank.rate) * seconds * seconds),
);

/// The derivative of a quantity along the motion, by differences of fourth order.
fn slope(values: &[f64], step: f64, i: usize) -> f64 {
    (8.0 * (values[i + 1] - values[i - 1]) - (values[i + 2] - values[i - 2])) / (12.0 * step)
}

fn press<M, S, const Q: usize, const N: usize, const R: usize>() -> Vec<Vec<f64>>
where
    M: Mechanism<System = S> + Default,
    S: System<Q, N, R>,
{
    let settings = Settings {
        step: 1e-3,
        order: 8,
        ..Settings::default()
    };
    let mut simulation = Simulation::with_settings(M::default(), settings).unwrap();
    let mut rows = Vec::new();
    for k in 0..60 {
        simulation.run_until(1e-3 * f64::from(k)).unwrap();
        let now = |name: &str| simulation.output(name).unwrap();
        let reaction = |joint, component| simulation.reaction(joint, component).unwrap();
        let load = reaction("pin", "fx").hypot(reaction("pin", "fy"));
        assert!((now("load") - load).abs() < 1e-13 * load);
        assert!((now("side") - reaction("guide", "fy")).abs() < 1e-13 * load);
        assert!(now("center").abs() < 1e-9);
        assert!((now("winding") - 0.5 * now("turning")).abs() < 1e-12);
        let before = count();
        let fields = simulation.outputs();
        let _ = (simulation.output("side"), simulation.reaction("pin", "fy"));
        assert_eq!(count(), before);
        assert_eq!(fields, simulation.outputs());
        // The general solution, which is also that of redundant rows.
        let general = simulation.reactions().unwrap().values;
        let mut names = S::MODEL.reactions.iter();
        let guide = names.position(|own| own.joint == "guide" && own.component == "fy");
        let error = general[guide.unwrap()] - now("side");
        assert!(error.abs() < 1e-10, "{error}");
        rows.push(simulation.output_values());
    }
    let column = |name: &str| -> Vec<f64> {
        let mut outputs = S::MODEL.outputs.iter();
        let index = outputs.position(|own| own.name == name).unwrap();
        rows.iter().map(|row| row[index]).collect()
    };
    for (velocity, acceleration) in [
        ("velocity.x", "acceleration.x"),
        ("turning", "spin"),
        ("turning", "same"),
    ] {
        let (velocity, acceleration) = (column(velocity), column(acceleration));
        let largest = acceleration.iter().fold(1.0, |a: f64, b| a.max(b.abs()));
        for i in 2..58 {
            let error = acceleration[i] - slope(&velocity, 1e-3, i);
            assert!(error.abs() < 1e-6 * largest, "{error}");
        }
    }
    rows
}

#[test]
fn accelerations_are_rates_and_loads_are_reactions() {
    let natural = press::<presses::natural::Press, _, _, _, _>();
    let joint = press::<presses::joint::Press, _, _, _, _>();
    for (a, b) in natural.iter().flatten().zip(joint.iter().flatten()) {
        assert!((a - b).abs() < 1e-9 * (1.0 + a.abs()), "{a} {b}");
    }
}

both!(rotors: Rotor in Spatial,
    arm: Body(mass = 2.0_kg, inertia = diag(0.25_kg_m2, 0.2_kg_m2, 0.1_kg_m2), center_of_mass = [0.4_m, 0.1_m, 0.0], orientation = turn(Z, 0.4), angular_velocity = [0.0, 0.0, 3.0_rad_per_s]),
    hinge: Revolute(ground.origin, arm.origin, axis = Z),
    blade: Body(mass = 1.0_kg, inertia = diag(0.02_kg_m2, 0.03_kg_m2, 0.04_kg_m2), at = arm.point(0.8_m, 0.0, 0.0), orientation = turn(Z, 0.4), angular_velocity = [2.0_rad_per_s, 0.0, 3.0_rad_per_s]),
    bend: Revolute(arm.point(0.8_m, 0.0, 0.0), blade.origin, axis = X),
    stiffness: TorsionSpring(bend, stiffness = 5.0_N_m),
    velocity: Output(blade.point(0.0, 0.3_m, 0.1_m).velocity),
    acceleration: Output(blade.point(0.0, 0.3_m, 0.1_m).acceleration),
    turning: Output(blade.angular_velocity),
    spin: Output(blade.angular_acceleration),
    moment: Output(hinge.reaction.tx),
);

fn rotor<M, S, const Q: usize, const N: usize, const R: usize>() -> Vec<Vec<f64>>
where
    M: Mechanism<System = S> + Default,
    S: System<Q, N, R>,
{
    let settings = Settings {
        step: 1e-3,
        order: 8,
        ..Settings::default()
    };
    let mut simulation = Simulation::with_settings(M::default(), settings).unwrap();
    let rows = (0..20).map(|k| {
        simulation.run_until(1e-3 * f64::from(k)).unwrap();
        let moment = simulation.reaction("hinge", "tx").unwrap();
        assert!((simulation.output("moment").unwrap() - moment).abs() < 1e-11);
        simulation.output_values()
    });
    let rows: Vec<Vec<f64>> = rows.collect();
    for (velocity, acceleration) in [(0, 3), (1, 4), (2, 5), (6, 9), (7, 10), (8, 11)] {
        let velocity: Vec<f64> = rows.iter().map(|row| row[velocity]).collect();
        for i in 2..18 {
            let error = rows[i][acceleration] - slope(&velocity, 1e-3, i);
            assert!(error.abs() < 1e-6, "{error}");
        }
    }
    rows
}

#[test]
fn bodies_in_space_have_accelerations() {
    let natural = rotor::<rotors::natural::Rotor, _, _, _, _>();
    let joint = rotor::<rotors::joint::Rotor, _, _, _, _>();
    for (a, b) in natural.iter().flatten().zip(joint.iter().flatten()) {
        assert!((a - b).abs() < 1e-8 * (1.0 + a.abs()), "{a} {b}");
    }
}

mod swing {
    mbs_runtime::mechanism!(Swing {
        world: Planar(gravity = [0.0, -9.81_m_per_s2]),
        rod: Bar(mass = 1.0_kg, length = 1.0_m, angle = -60.0_deg),
        pivot: Revolute(ground.origin, rod.a),
        pull: Output(pivot.reaction.fx),
        shifted: Output(rod.angle + 0.5 * pi),
        spin: Output(rate(rod.rate)),
        turning: Output(rod.rate),
        tip: Output(rod.b),
    });
}

/// The outputs behind one that reads an acceleration stood a place too early: held was the one behind.
#[test]
fn outputs_behind_those_that_read_accelerations_keep_their_places() {
    use swing::Swing;
    let start = || Simulation::start(Swing::default());
    let held = start().hold("shifted", 0.3).hold_rate("shifted", 2.0);
    let held = held.begin().expect("it can be held");
    let found = held.outputs();
    assert!((found.shifted - 0.3).abs() < 1e-9, "{found:?}");
    assert!((found.turning - 2.0).abs() < 1e-9, "{found:?}");
    let turning = start().hold("turning", 0.7).begin().expect("a rate");
    assert!((turning.outputs().turning - 0.7).abs() < 1e-9);
    let refused = start().hold("spin", 0.3).begin().err();
    let message = refused.map(|error| error.to_string()).unwrap_or_default();
    assert!(message.contains("without accelerations"), "{message}");
    let (state, mut values) = (held.state(), [0.0f64; 6]);
    let (q, v) = (&state.positions, &state.velocities);
    Observables::outputs(held.system(), 0.0, q, v, &mut values);
    assert!(values[0].is_nan() && values[2].is_nan(), "{values:?}");
    assert_eq!(values[1], found.shifted);
    assert_eq!(values[3], found.turning);
}
