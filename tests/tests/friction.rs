//! Friction against closed forms and a fine integration.

use crate::method_changes::Block;
use mbs_runtime::{Mechanism, Method, Settings, Simulation, mechanism, methods};

fn settings(step: f64) -> Settings {
    Settings {
        step,
        ..Settings::default()
    }
}

mechanism!(Blocks {
    doc: "A block slides to rest; one creeps down a slope; one is pulled by a spring over a moving belt.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    slope: Param(0.2),
    x: Coordinate(0.0_m, rate = 2.0_m_per_s),
    y: Coordinate(0.0_m),
    z: Coordinate(0.0_m),
    sliding: Particle(mass = 2.0_kg, position = [x, 0.0_m]),
    creeping: Particle(mass = 2.0_kg, position = [y * cos(slope), -y * sin(slope)]),
    pulled: Particle(mass = 1.0_kg, position = [z, 1.0_m]),
    pad: Friction(
        x.rate,
        load = 10.0_N,
        coefficient = 0.3,
        regularization_velocity = 0.1_m_per_s
    ),
    foot: Friction(
        y.rate,
        load = 2.0_kg * 9.81_m_per_s2 * cos(slope),
        coefficient = 0.4,
        regularization_velocity = 0.01_m_per_s
    ),
    spring: SpringDamper(
        ground.point(-1.0_m, 1.0_m),
        pulled.origin,
        stiffness = 100.0_N_per_m,
        length = 1.0_m
    ),
    belt: Friction(
        z.rate - 0.1_m_per_s,
        load = 9.81_N,
        coefficient = 0.2,
        static_coefficient = 0.4,
        stribeck_velocity = 0.05_m_per_s,
        regularization_velocity = 0.005_m_per_s,
        damping = 0.3_N_s_per_m
    ),
    speed: Output(x.rate),
    creep: Output(y.rate),
    place: Output(z),
    rate: Output(z.rate),
});

/// m v̇ = −μ N tanh(v/ε) has the solution sinh(v/ε) = sinh(v₀/ε) exp(−μ N t/(m ε)).
#[test]
fn a_block_slides_to_rest() {
    let mut simulation =
        Simulation::with_settings(Blocks::default(), settings(1e-4)).expect("it assembles");
    for time in [0.5, 1.2, 1.4] {
        simulation.run_until(time).expect("it runs");
        let exact = 0.1 * f64::asinh(f64::sinh(20.0) * f64::exp(-3.0 * time / 0.2));
        let found = simulation.outputs().speed;
        assert!((found - exact).abs() < 1e-6, "{found} at {time}, {exact}");
    }
}

/// On a slope whose tangent is less than μ it creeps with v = ε artanh(tan α/μ).
#[test]
fn a_block_creeps_down_a_slope() {
    let mut simulation =
        Simulation::with_settings(Blocks::default(), settings(1e-4)).expect("it assembles");
    simulation.run_until(0.5).expect("it runs");
    let exact = 0.01 * f64::atanh(f64::tan(0.2) / 0.4);
    let found = simulation.outputs().creep;
    assert!((found - exact).abs() < 1e-9, "{found}, {exact}");
}

/// The friction of the belt on the block.
fn friction(speed: f64) -> f64 {
    let coefficient = 0.2 + 0.2 * (-(speed / 0.05).powi(2)).exp();
    -9.81 * coefficient * (speed / 0.005).tanh() - 0.3 * speed
}

/// Stick–slip on a belt, against a Runge–Kutta method with small steps.
#[test]
fn a_block_sticks_to_a_belt_and_slips() {
    let mut simulation =
        Simulation::with_settings(Blocks::default(), settings(5e-5)).expect("it assembles");
    let rates = |[x, v]: [f64; 2]| [v, friction(v - 0.1) - 100.0 * x];
    let (mut state, h) = ([0.0, 0.0], 2e-5);
    let mut slips = 0;
    for piece in 1..=20 {
        for _ in 0..5000 {
            let after = |k: [f64; 2], h: f64| [state[0] + h * k[0], state[1] + h * k[1]];
            let a = rates(state);
            let b = rates(after(a, 0.5 * h));
            let c = rates(after(b, 0.5 * h));
            let d = rates(after(c, h));
            state = std::array::from_fn(|i| {
                state[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i])
            });
        }
        simulation
            .run_until(0.1 * f64::from(piece))
            .expect("it runs");
        let outputs = simulation.outputs();
        assert!(
            (outputs.place - state[0]).abs() < 2e-6,
            "{piece}: {state:?}"
        );
        slips += usize::from(state[1] < -0.02);
    }
    assert!(slips > 0);
    // The belt does work, which is that on the block and not that at the contact.
    let energy = simulation.energy();
    assert!(energy.error.abs() < 1e-4, "{:e}", energy.error);
}

mechanism!(Rotor {
    doc: "A rotor in a bearing with friction.",
    world: Spatial(),
    radius: Param(8.0_mm),
    rotor: Body(
        mass = 3.0_kg,
        inertia = diag(0.02, 0.02, 0.03),
        angular_velocity = [0.0, 0.0, 30.0]
    ),
    bearing: Revolute(ground, rotor, at = [0.0, 0.0, 0.0], axis = Z),
    journal: Friction(
        bearing.rate,
        load = 29.4_N * radius,
        coefficient = 0.15,
        regularization_velocity = 2.0_rad_per_s
    ),
    speed: Output(bearing.rate),
});

#[test]
fn a_rotor_spins_down() {
    let mut simulation =
        Simulation::with_settings(Rotor::default(), settings(1e-3)).expect("it assembles");
    let torque = 0.15 * 29.4 * 0.008;
    for time in [5.0, 20.0, 25.0, 30.0] {
        simulation.run_until(time).expect("it runs");
        let decay = f64::exp(-torque * time / (0.03 * 2.0));
        let exact = 2.0 * f64::asinh(f64::sinh(15.0) * decay);
        let found = simulation.outputs().speed;
        assert!((found - exact).abs() < 1e-5, "{found} at {time}, {exact}");
    }
    let energy = simulation.energy();
    assert!(energy.error.abs() < 1e-4, "{:e}", energy.error);
}

/// The pull ends and the block slides back: at the turn friction reverses within microseconds. A step that does not converge is
/// halved; the estimate of the last half told nothing of the turn in another one, and the place was wrong by 3500 tolerances,
/// without a comparison.
#[test]
fn a_turn_within_a_part_of_a_step_is_seen() {
    let places = [
        Settings::for_tolerance(1e-8),
        Settings {
            method: Method::Radau,
            tolerance: Some(1e-10),
            ..Settings::default()
        },
    ]
    .map(|settings| {
        let turning = Block { stiffness: 1.0 };
        let mut simulation =
            Simulation::with_methods(turning, settings, methods::Accuracy).expect("it assembles");
        simulation.run_until(2.0).expect("it runs");
        simulation.set_input("pull", 0.0).expect("an input");
        simulation.run_until(2.2).expect("it runs");
        simulation.run_until(2.4).expect("it runs");
        simulation.output("place").expect("an output")
    });
    assert!((places[0] - places[1]).abs() < 1e-8, "{places:?}");
}

mechanism!(Swing {
    doc: "Two rods swing, a motor turns with a torque of time, springs act on coordinates: nothing jumps.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    stiffness: Param(4.0_N_per_m),
    torque: Input(0.0_N_m),
    upper: Bar(mass = 1.0_kg, length = 1.0_m, angle = 30.0_deg),
    lower: Bar(mass = 1.0_kg, length = 1.0_m, angle = -60.0_deg),
    pivot: Revolute(ground.origin, upper.a),
    elbow: Revolute(upper.b, lower.a),
    motor: Torque(upper, value = torque + 1.0_N_m * sin(2.0_rad_per_s * t)),
    slide: Each(0..12, |i| Coordinate(0.1_m * i)),
    carriage: Each(0..12, |i| Particle(
        mass = 1.0_kg,
        position = [slide[i], -2.0_m]
    )),
    spring: Each(0..12, |i| Force(
        carriage[i].origin,
        value = [
            -stiffness * slide[i] - 2.0 * sqrt(stiffness * 1.0_kg) * slide[i].rate,
            0.0_N
        ]
    )),
});

mechanism!(Rough {
    doc: "A block slides with friction.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    x: Coordinate(0.0_m, rate = 1.0_m_per_s),
    block: Particle(mass = 1.0_kg, position = [x, 0.0_m]),
    sole: Friction(
        x.rate,
        load = 9.81_N,
        coefficient = 0.3,
        regularization_velocity = 0.1_m_per_s
    ),
});

mechanism!(Bent {
    doc: "A force with a corner.",
    world: Planar(),
    x: Coordinate(0.0_m, rate = 1.0_m_per_s),
    block: Particle(mass = 1.0_kg, position = [x, 0.0_m]),
    push: Force(block.origin, value = [-1.0_N_per_m * abs(x), 0.0_N]),
});

mechanism!(Attracted {
    doc: "A force that grows beyond all bounds.",
    world: Planar(),
    x: Coordinate(1.0_m),
    block: Particle(mass = 1.0_kg, position = [x, 0.0_m]),
    pull: Force(block.origin, value = [-1.0_N * (1.0_m / x), 0.0_N]),
});

mechanism!(Measured {
    doc: "A force by a table.",
    world: Planar(),
    curve: Table(
        [-1.0_m, 0.0_m, 1.0_m],
        [-2.0_N, 0.0_N, 1.0_N],
        interpolation = Linear
    ),
    x: Coordinate(0.5_m),
    block: Particle(mass = 1.0_kg, position = [x, 0.0_m]),
    pull: Force(block.origin, value = [-curve(x), 0.0_N]),
    place: Output(x),
});

mechanism!(Hung {
    doc: "A rod hangs by a spring, whose direction is none where its ends meet.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    rod: Bar(mass = 1.0_kg, length = 1.0_m),
    spring: SpringDamper(
        ground.point(0.0, 1.0_m),
        rod.a,
        stiffness = 10.0_N_per_m,
        length = 0.5_m
    ),
});

mechanism!(Turned {
    doc: "A bar that a drive turns.",
    world: Planar(coordinates = Natural),
    bar: Bar(mass = 1.0_kg, length = 1.0_m),
    pin: Revolute(ground.origin, bar.a),
    drive: Drive(bar.angle, value = 2.0_rad_per_s * t),
});

mechanism!(TurnedBack {
    doc: "The same in the other sense.",
    world: Planar(coordinates = Natural),
    bar: Bar(mass = 1.0_kg, length = 1.0_m),
    pin: Revolute(ground.origin, bar.a),
    drive: Drive(bar.angle, value = -2.0_rad_per_s * t),
});

/// Steps with a tolerance look for jumps only where there can be some.
#[test]
fn mechanisms_without_jumps_are_known() {
    for (model, smooth) in [
        (Swing::MODEL, true),
        (Rough::MODEL, false),
        (Bent::MODEL, false),
        (Attracted::MODEL, false),
        (Measured::MODEL, false),
        (Hung::MODEL, false),
        (Turned::MODEL, true),
        (TurnedBack::MODEL, true),
    ] {
        assert_eq!(model.structure.smooth, smooth, "{}", model.name);
    }
}

/// Where friction turns, and where the block passes the fixed end of its spring, the force jumps within a step. There the error
/// falls with the first or second power of the step, and the difference to another step is not 31 or 255 times the error.
#[test]
fn a_force_that_jumps_is_seen() {
    let settings = |(method, order), tolerance| Settings {
        method,
        order,
        tolerance: Some(tolerance),
        ..Settings::default()
    };
    let places = |settings| {
        let mut simulation =
            Simulation::with_methods(Block::default(), settings, methods::Accuracy)
                .expect("it assembles");
        simulation.run_until(2.0).expect("it runs");
        simulation.set_input("pull", 0.0).expect("an input");
        // After the turn at 2.7 s, and after the end of the spring at 6.45 s.
        [6.0, 7.3].map(|time| {
            simulation.run_until(time).expect("it runs");
            simulation.output("place").expect("an output")
        })
    };
    let fine = places(settings((Method::Projected, 8), 1e-9));
    let two_level = [4, 6, 8].map(|order| (Method::TwoLevel, order));
    let others = [(Method::Projected, 8), (Method::Radau, 2)];
    for method in two_level.into_iter().chain(others) {
        for tolerance in [6e-5, 2e-5, 6e-6, 2e-6, 6e-7] {
            let coarse = places(settings(method, tolerance));
            let error = |i: usize| (coarse[i] - fine[i]).abs() / tolerance;
            let largest = error(0).max(error(1));
            assert!(largest < 10.0, "{method:?}, {tolerance}: {largest}");
        }
    }
}

/// A block on a spring, with what is beside it.
macro_rules! sprung {
    ($name:ident, $($beside:tt)*) => {
        mechanism!($name {
            doc: "A block on a spring slides with friction, turns, and sticks.",
            world: Planar(),
            stiffness: Param(2.0_N_per_m),
            kinetic: Param(0.2),
            x: Coordinate(0.0_m, rate = 3.5_m_per_s),
            block: Particle(mass = 1.0_kg, position = [x, 0.0_m]),
            spring: SpringDamper(
                ground.point(-20.0_m, 0.0_m),
                block.origin,
                stiffness = stiffness,
                length = 20.0_m
            ),
            sole: Friction(
                x.rate,
                load = 9.81_N,
                coefficient = kinetic,
                static_coefficient = 0.4,
                stribeck_velocity = 0.05_m_per_s,
                regularization_velocity = 0.1_mm_per_s
            ),
            place: Output(x),
            $($beside)*
        });
    };
}

sprung!(Sprung,);
sprung!(Clocked, passed: State(rate = 1.0_per_s, initial = 1.0), clock: Output(passed),);

/// With a state, which no estimate sees, each pair is compared; the estimate of the motion shows the jumps all the same. Without it the
/// errors were up to 139 tolerances with two-level steps and 633 with explicit ones.
#[test]
fn a_force_that_jumps_is_seen_beside_a_state() {
    let settings = |(method, order), tolerance| Settings {
        method,
        order,
        tolerance: Some(tolerance),
        ..Settings::default()
    };
    let two_level = [4, 6, 8].map(|order| (Method::TwoLevel, order));
    let others = [(Method::Projected, 8), (Method::Radau, 2)];
    for (stiffness, kinetic) in [(2.279, 0.1473), (16.1, 0.1174)] {
        let sprung = Sprung { stiffness, kinetic };
        let fine = settings((Method::Projected, 8), 1e-10);
        let mut fine = Simulation::with_methods(sprung, fine, methods::Accuracy).expect("a start");
        let places: [f64; 5] = std::array::from_fn(|second| {
            fine.run_until(1.0 + second as f64).expect("it runs");
            fine.outputs().place
        });
        for method in two_level.into_iter().chain(others) {
            for tolerance in [2e-4, 2e-5, 2e-6] {
                let clocked = Clocked { stiffness, kinetic };
                let settings = settings(method, tolerance);
                let mut clocked = Simulation::with_methods(clocked, settings, methods::Accuracy)
                    .expect("a start");
                for (second, place) in places.iter().enumerate() {
                    clocked.run_until(1.0 + second as f64).expect("it runs");
                    let error = (clocked.outputs().place - place).abs() / tolerance;
                    assert!(
                        error < 10.0,
                        "{method:?}, {tolerance}, {stiffness}: {error}"
                    );
                }
            }
        }
    }
}

/// A mass between two springs, of 1 and 2 N/m, of which each acts on one side: its half periods are π and π/√2, and a quarter of the
/// first one after a whole number of periods it passes the middle. Forces depend on positions alone, so that another estimate serves
/// two-level steps than with friction.
#[test]
fn a_force_that_bends_is_seen() {
    use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI};
    for order in [4, 6, 8] {
        for tolerance in [1e-4, 1e-5, 1e-6, 1e-7] {
            let settings = Settings {
                order,
                tolerance: Some(tolerance),
                ..Settings::default()
            };
            let mut simulation =
                Simulation::with_settings(Measured::default(), settings).expect("it assembles");
            let end = 3.0 * PI * (1.0 + FRAC_1_SQRT_2) + FRAC_PI_2;
            simulation.run_until(end).expect("it runs");
            let error = simulation.output("place").expect("an output").abs() / tolerance;
            assert!(error < 1.0, "order {order}, {tolerance}: {error}");
        }
    }
}
