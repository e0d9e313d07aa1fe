//! Tables: the curves themselves, and mechanisms that follow them.

use crate::common::expansion::accepted;
use mbs_macros_core::symbolic::{Beyond, INTEGRAL, Interpolation, Table};
use mbs_runtime::{Settings, Simulation, mechanism};
use mbs_tests::fixtures::Measured;

const X: [f64; 6] = [-1.0, 0.0, 0.5, 2.0, 3.0, 4.5];
const Y: [f64; 6] = [2.0, 2.0, 5.0, 5.5, 5.0, -1.0];

fn table(interpolation: Interpolation, beyond: Beyond) -> Table {
    Table::new((0, "y".into()), &X, &Y, interpolation, beyond)
}

fn all() -> Vec<Table> {
    let kinds = [Interpolation::Cubic, Interpolation::Linear];
    let both = |kind| [Beyond::Linear, Beyond::Constant].map(|beyond| table(kind, beyond));
    kinds.into_iter().flat_map(both).collect()
}

#[test]
fn it_goes_through_its_points() {
    for table in all() {
        for (x, y) in X.into_iter().zip(Y) {
            assert!((table.value(x, 0) - y).abs() < 1e-14);
            // From the left, too.
            assert!((table.value(x - 1e-12, 0) - y).abs() < 1e-10);
        }
    }
}

#[test]
fn it_does_not_overshoot() {
    for table in all() {
        for (k, pair) in Y.windows(2).enumerate() {
            let (low, high) = (pair[0].min(pair[1]), pair[0].max(pair[1]));
            for part in 0..=100 {
                let x = X[k] + f64::from(part) / 100.0 * (X[k + 1] - X[k]);
                let y = table.value(x, 0);
                assert!((low - 1e-14..=high + 1e-14).contains(&y), "{y} at {x}");
            }
        }
    }
}

/// Each order is the derivative of the one before.
#[test]
fn derivatives_and_the_integral_are_those_of_the_curve() {
    for table in all() {
        for k in 0..400 {
            let x = -2.0 + 0.0197 * f64::from(k);
            if X.iter().any(|knot| (knot - x).abs() < 2e-4) {
                continue;
            }
            for order in INTEGRAL..3 {
                let h = 1e-4;
                let slope = (table.value(x + h, order) - table.value(x - h, order)) / (2.0 * h);
                let given = table.value(x, order + 1);
                assert!(
                    (slope - given).abs() < 1e-5,
                    "{order} at {x}: {given}, {slope}"
                );
            }
        }
        assert_eq!(table.value(0.0, INTEGRAL), 0.0);
    }
}

/// A periodic curve: the same in each period, smooth where one ends, with an integral that grows by the area of a period.
#[test]
fn it_is_repeated() {
    let y = [2.0, 2.5, 5.0, 5.5, 1.0, 2.0];
    let [cubic, linear] = [Interpolation::Cubic, Interpolation::Linear]
        .map(|kind| Table::new((0, "y".into()), &X, &y, kind, Beyond::Periodic));
    assert!(linear.has_kinks() && !cubic.has_kinks());
    for table in [&cubic, &linear] {
        let area = table.value(4.5, INTEGRAL) - table.value(-1.0, INTEGRAL);
        for k in 0..110 {
            let x = -0.975 + 0.05 * f64::from(k);
            for periods in [-7.0, -1.0, 1.0, 1e3] {
                let there = x + 5.5 * periods;
                for order in 0..4 {
                    let values = [x, there].map(|x| table.value(x, order));
                    let apart = values[0] - values[1];
                    assert!(apart.abs() < 1e-10, "{order} at {x}: {values:?}");
                }
                let grown = table.value(there, INTEGRAL) - table.value(x, INTEGRAL);
                assert!((grown - periods * area).abs() < 1e-9, "{x}: {grown}");
            }
        }
        for end in [-6.5, -1.0, 4.5] {
            for order in [INTEGRAL, 0] {
                let [before, after] = [-1e-9, 1e-9].map(|h| table.value(end + h, order));
                assert!((before - after).abs() < 1e-7, "{end}, {order}");
            }
        }
        assert_eq!(table.value(0.0, INTEGRAL), 0.0);
        assert!(table.value(f64::NAN, 0).is_nan());
    }
    // Secants 2/3 before the ends and 1/2 behind them over widths 3/2 and 1.
    let wanted = 7.5 / (3.5 / (2.0 / 3.0) + 4.0 / 0.5);
    let slopes = [-1.0, 4.5, 10.0].map(|x| cubic.value(x, 1));
    assert!(
        slopes.iter().all(|slope| (slope - wanted).abs() < 1e-14),
        "{slopes:?}"
    );
}

/// The slopes of Fritsch and Butland, by hand: weighted harmonic means, and zero at an extremum.
#[test]
fn slopes_are_those_of_the_method() {
    let cubic = table(Interpolation::Cubic, Beyond::Linear);
    let slope = |x| cubic.value(x, 1);
    // Secants 0, 6, 1/3, −1/2, −4 over widths 1, 1/2, 3/2, 1, 3/2.
    assert_eq!([slope(0.0), slope(2.0)], [0.0, 0.0]);
    let wanted = (3.5 + 2.5) / (3.5 / 6.0 + 2.5 / (1.0 / 3.0));
    assert!((slope(0.5) - wanted).abs() < 1e-14);
    let wanted = (4.0 + 3.5) / (4.0 / -0.5 + 3.5 / -4.0);
    assert!((slope(3.0) - wanted).abs() < 1e-14);
    // At the ends by three points, limited: the first has the secant 0, the last is ((2 · 3/2 + 1)(−4) + 3/4) / (5/2).
    assert_eq!(slope(-1.0), 0.0);
    assert!((slope(4.5) + 6.1).abs() < 1e-14);
    assert!(!cubic.has_kinks());
    assert!(!table(Interpolation::Cubic, Beyond::Constant).has_kinks());
    assert!(table(Interpolation::Linear, Beyond::Linear).has_kinks());
}

#[test]
fn beyond_its_ends_it_goes_on_as_declared() {
    let at = |beyond, kind, x: f64| table(kind, beyond).value(x, 0);
    for kind in [Interpolation::Cubic, Interpolation::Linear] {
        assert_eq!(at(Beyond::Constant, kind, -7.0), 2.0);
        assert_eq!(at(Beyond::Constant, kind, 9.0), -1.0);
    }
    assert_eq!(at(Beyond::Linear, Interpolation::Linear, 6.0), -7.0);
    assert!((at(Beyond::Linear, Interpolation::Cubic, 5.5) + 7.1).abs() < 1e-13);
    assert!(
        table(Interpolation::Cubic, Beyond::Linear)
            .value(f64::NAN, 0)
            .is_nan()
    );
}

mechanism!(Linear {
    doc: "A mass on a spring, by its stiffness.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    bob: Particle(mass = 0.8_kg, at = [0.3_m, -0.9_m]),
    spring: SpringDamper(
        ground.origin,
        bob.origin,
        stiffness = 60.0_N_per_m,
        damping = 0.4_N_s_per_m,
        length = 0.7_m
    ),
    place: Output(bob.origin),
});

mechanism!(Tabulated {
    doc: "The same, by tables of the same straight lines.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    line: Table([-0.1_m, 0.0_m, 0.2_m], [-6.0_N, 0.0_N, 12.0_N]),
    slope: Table([-2.0_m_per_s, 0.5_m_per_s], [-0.8_N, 0.2_N]),
    bob: Particle(mass = 0.8_kg, at = [0.3_m, -0.9_m]),
    spring: SpringDamper(
        ground.origin,
        bob.origin,
        law = line,
        damping = slope,
        length = 0.7_m
    ),
    place: Output(bob.origin),
});

#[test]
fn straight_tables_are_a_stiffness_and_a_damping() {
    let (mut linear, mut table) = (
        Simulation::new(Linear::default()).expect("it assembles"),
        Simulation::new(Tabulated::default()).expect("it assembles"),
    );
    linear.run_until(3.0).expect("it runs");
    table.run_until(3.0).expect("it runs");
    for name in ["place.x", "place.y"] {
        let [a, b] = [linear.output(name), table.output(name)].map(|x| x.expect("an output"));
        assert!((a - b).abs() < 1e-9, "{name}: {a} and {b}");
    }
    let [a, b] = [linear.energy(), table.energy()];
    assert!((a.potential - b.potential).abs() < 1e-8);
    assert!((a.error - b.error).abs() < 1e-10, "{:e}", b.error);
}

mechanism!(Hardening {
    doc: "A mass on a spring of measured stiffness, and with its force as a load.",
    world: Planar(),
    rubber: Table(
        [0.0_m, 0.1_m, 0.2_m, 0.3_m, 0.4_m],
        [0.0_N, 5.0_N, 13.0_N, 30.0_N, 80.0_N]
    ),
    x: Coordinate(0.35_m),
    y: Coordinate(0.35_m),
    first: Particle(mass = 0.8_kg, position = [x, 0.0_m]),
    second: Particle(mass = 0.8_kg, position = [y, 1.0_m]),
    spring: SpringDamper(
        ground.point(-1.0_m, 0.0_m),
        first.origin,
        law = rubber,
        length = 1.0_m
    ),
    load: Force(second.origin, value = [-rubber(y), 0.0]),
    speed: Output(x.rate),
    loaded: Output(y.rate),
    back: Event(x),
});

/// The speed at the point without force is that of the area under the curve; as a load the same force does its work.
#[test]
fn energy_is_the_area_under_the_curve() {
    let settings = Settings {
        step: 1e-4,
        ..Settings::default()
    };
    let mut simulation =
        Simulation::with_settings(Hardening::default(), settings).expect("it assembles");
    let start = simulation.energy();
    let data = Table::new(
        (0, "rubber".into()),
        &[0.0, 0.1, 0.2, 0.3, 0.4],
        &[0.0, 5.0, 13.0, 30.0, 80.0],
        Interpolation::Cubic,
        Beyond::Linear,
    );
    let area = data.value(0.35, INTEGRAL);
    assert!((start.potential - area).abs() < 1e-12);
    simulation.run_to_event("back", 1.0).expect("it comes back");
    let speed = (2.0 * area / 0.8_f64).sqrt();
    for name in ["speed", "loaded"] {
        let found = simulation.output(name).expect("an output");
        assert!((found + speed).abs() < 1e-5, "{name}: {found}, {speed}");
    }
    let energy = simulation.energy();
    assert!((energy.nonconservative_work - area).abs() < 1e-5);
    assert!(energy.error.abs() < 1e-5, "{:e}", energy.error);
}

/// Drives and conditions follow the curve, and reactions its second derivative.
#[test]
fn rows_follow_the_curve() {
    let mut simulation = Simulation::new(Measured::default()).expect("it assembles");
    let program = Table::new(
        (0, "program".into()),
        &[0.0, 1.0, 2.5, 4.0],
        &[0.0, 0.6, 0.9, 2.0],
        Interpolation::Cubic,
        Beyond::Linear,
    );
    for step in 1..8 {
        let time = 0.1 * f64::from(step);
        simulation.run_until(time).expect("it runs");
        let angle = simulation.outputs().turn;
        assert!(
            (angle - program.value(time, 0)).abs() < 1e-9,
            "at {time}: {angle}"
        );
        let outputs = simulation.outputs();
        assert!((outputs.height - outputs.lift).abs() < 1e-9);
    }
    assert!(
        simulation.energy().error.abs() < 1e-4,
        "{:?}",
        simulation.energy()
    );
}

/// Where both slopes at the ends of a piece vanish, one of them is round-off, and that was a kink.
#[test]
fn a_cubic_table_between_dwells_moves_a_drive() {
    for table in [
        "[0.0, 0.4, 1.1, 2.0], [0.0, 0.0, 0.3, 0.3]",
        "[0.0, 1.0, 1.3, 2.0], [0.0, 0.0, 0.7, 0.7]",
        "[0.0, 0.2, 0.9, 2.0], [0.1, 0.1, 0.6, 0.6]",
        "[0.0, 0.3, 0.7, 1.0], [0.0, 0.1, -0.1, 0.3]",
    ] {
        accepted(&format!(
            "mechanism!(Dwell {{
    world: Planar(),
    lift: Table({table}),
    bar: Bar(mass = 1.0_kg, length = 1.0_m, angle = lift(0.0)),
    pin: Revolute(ground.origin, bar.a),
    cam: Drive(bar.angle, value = lift(t / 1.0_s)),
}});"
        ));
    }
}
