//! Runs to each instant of a program, which take one step where a longer one would do.

use mbs_runtime::methods::Methods;
use mbs_runtime::{
    GeneralizedAlphaSettings, Mechanism, Method, Settings, Simulation, System, mechanism, methods,
};

mechanism!(SliderCrank {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    crank: Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        angle = 45.0_deg,
        rate = 2.83_rad_per_s
    ),
    rod: Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        angle = -45.0_deg,
        rate = -2.83_rad_per_s
    ),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),
    angle: Output(crank.angle),
});

mechanism!(Stiff {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    upper: Bar(mass = 1.0_kg, length = 1.0_m, angle = 40.0_deg),
    lower: Bar(mass = 0.01_kg, length = 0.3_m, angle = -20.0_deg),
    foot: Revolute(ground.origin, upper.a),
    pin: Revolute(upper.b, lower.a),
    damper: TorsionSpring(upper, lower, damping = 10.0_N_m_s),
    angle: Output(upper.angle),
});

mechanism!(Buffered {
    world: Planar(),
    push: Input(unit = N),
    x: Coordinate(0.0_m, rate = 1.0_m_per_s),
    block: Particle(mass = 1.0_kg, position = [x, 0.0_m]),
    hand: Force(on = block.origin, value = [push, 0.0_N]),
    walls: Stop(
        x,
        lower = -0.2_m,
        upper = 0.2_m,
        stiffness = 1e5_N_per_m,
        onset = 1.0_mm,
        dissipation = 0.1_s_per_m
    ),
    place: Output(x),
});

mechanism!(Driven {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    crank: Bar(mass = 1.0_kg, length = 0.4_m, angle = 0.5_rad),
    bob: Bar(mass = 0.3_kg, length = 0.7_m, angle = -80.0_deg),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, bob.a),
    motor: Drive(crank.angle, value = 0.5 + 0.4 * sin(3.0_rad_per_s * t)),
    angle: Output(bob.angle),
});

mechanism!(Engine {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Natural),
    crank: Bar(
        mass = 0.36_kg,
        length = 0.15_m,
        angle = 40.0_deg,
        rate = 20.0_rad_per_s
    ),
    rod: Bar(mass = 0.15_kg, length = 0.4_m, angle = -14.0_deg),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),
});

fn input(piece: u32) -> f64 {
    2.0 * (0.37 * f64::from(piece)).sin()
}

/// The first output after each tenth of so many pieces of a run, and the steps for each piece.
fn run<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: M,
    settings: Settings,
    (end, pieces): (f64, u32),
) -> (Vec<f64>, f64, Method)
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let mut simulation = Simulation::with_methods(mechanism, settings, methods::Accuracy).unwrap();
    let method = simulation.settings().method;
    let mut places = Vec::new();
    for piece in 1..=pieces {
        let inputs = vec![input(piece); simulation.input_values().len()];
        simulation.set_input_values(&inputs).unwrap();
        simulation
            .run_until(end * f64::from(piece) / f64::from(pieces))
            .unwrap();
        if piece.is_multiple_of(pieces / 10) {
            places.push(simulation.output_values()[0]);
        }
    }
    let steps = simulation.report().steps as f64 / f64::from(pieces);
    (places, steps, method)
}

/// The largest difference to a fine run with the same pieces, in accuracies, and the steps for each piece.
fn seen<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: M,
    accuracy: f64,
    pieces: (f64, u32),
) -> (f64, f64, Method)
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let exact = run(mechanism.clone(), Settings::accuracy(1e-11), pieces).0;
    let (places, steps, method) = run(mechanism, Settings::accuracy(accuracy), pieces);
    let errors = places.iter().zip(&exact).map(|(a, b)| (a - b).abs());
    (errors.fold(0.0, f64::max) / accuracy, steps, method)
}

#[test]
fn smooth_motion_takes_a_step_each() {
    let (error, steps, method) = seen(Driven {}, 1e-5, (2.0, 1000));
    assert_eq!(method, Method::Projected);
    assert!(error < 1.0 && steps < 1.2, "drive: {error}, {steps}");
    let (error, steps, method) = seen(Stiff {}, 1e-4, (1.0, 1000));
    assert_eq!(method, Method::Radau);
    assert!(error < 1.0 && steps < 1.3, "collocation: {error}, {steps}");
}

/// Near the pose, which comes each half turn, pairs are taken.
#[test]
fn a_singular_pose_is_passed_in_pieces() {
    let (error, steps, _) = seen(SliderCrank {}, 1e-5, (4.0, 2000));
    assert!(error < 1.0 && steps < 1.6, "{error}, {steps}");
}

#[test]
fn stops_and_inputs_are_seen_in_pieces() {
    for pieces in [3000, 300] {
        for accuracy in [1e-3, 1e-5, 1e-7] {
            let (error, ..) = seen(Buffered {}, accuracy, (3.0, pieces));
            assert!(error < 10.0, "{pieces}, {accuracy:e}: {error}");
        }
    }
}

/// The largest difference of a coordinate of the engine to a fine run, after so many pieces: one of 16 ms, and then some that are
/// much shorter than a step.
fn off_after<C: Methods>(methods: C, method: Method, count: u32, (short, more): (f64, u32)) -> f64 {
    let settings = Settings {
        method,
        ..Settings::default()
    };
    let mut simulation = Simulation::with_methods(Engine {}, settings, methods).unwrap();
    let mut time = 0.0;
    for _ in 0..count {
        time += 0.016;
        simulation.run_until(time).unwrap();
        for _ in 0..more {
            time += short;
            simulation.run_until(time).unwrap();
        }
    }
    let mut exact = Simulation::with_accuracy(Engine {}, 1e-10).unwrap();
    exact.run_until(time).unwrap();
    let apart = simulation.positions() - exact.positions();
    println!("{} {short:e}: {:e}", method.name(), apart.amax());
    apart.amax()
}

/// A step that is much shorter than those before closes what they leave of the rates of rows. The accelerations of that are not those
/// of the motion.
#[test]
fn short_ends_of_pieces_leave_no_accelerations() {
    let method = Method::by_name("generalized-alpha").unwrap();
    for short in [1e-5, 1e-6, 1e-8] {
        let off = off_after(methods::GeneralizedAlpha, method, 60, (short, 1));
        // Pieces of 16 ms alone leave 4.6e-4 m.
        assert!(off < 1e-3, "{short:e}: {off:e} m");
    }
}

/// Pieces of one step and a part of one: the accelerations of the part were those of the step after it, and grew without bound.
#[test]
fn pieces_of_more_than_a_step_keep_the_energy() {
    for stabilised in [false, true] {
        let settings = Settings {
            method: Method::GeneralizedAlpha(GeneralizedAlphaSettings {
                stabilised,
                ..GeneralizedAlphaSettings::default()
            }),
            step: 1e-3,
            ..Settings::default()
        };
        for tenths in 11..=16 {
            let mut engine =
                Simulation::with_methods(Engine {}, settings, methods::GeneralizedAlpha).unwrap();
            let every = 1e-4 * f64::from(tenths);
            for piece in 1..=300 {
                engine.run_until(every * f64::from(piece)).unwrap();
            }
            let error = engine.report().energy_error;
            println!("{stabilised} {tenths}: {error:e}");
            // Whole steps have 5e-4 J. After a tenth of a step accelerations begin anew.
            let bound = if tenths == 11 { 1e-2 } else { 1e-3 };
            assert!(error < bound, "{stabilised} {tenths}: {error:e} J");
        }
    }
}

/// The history has instants at the distances of steps.
#[test]
fn short_pieces_do_not_fill_the_history() {
    let method = Method::by_name("bdf").unwrap();
    for pieces in [(1e-9, 200), (1e-7, 50), (1e-5, 50)] {
        let off = off_after(methods::Bdf, method, 10, pieces);
        assert!(off < 2e-5, "{pieces:?}: {off:e} m");
    }
}
