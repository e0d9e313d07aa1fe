//! Orders 4, 6 and 8 where forces depend on velocities: slopes for every kind of rows, and what must not depend on the
//! order.

use crate::common::alloc::count;
use crate::common::planar::DampedSliderCrank;
use crate::common::scenes::DampedSleigh;
use crate::common::spatial::Sprung;
use crate::common::{Parameters, distance};
use crate::composition::{run, settings, slopes};
use mbs_runtime::{Settings, Simulation, mechanism};

/// Four hanging bars with a friction at the top hinge.
macro_rules! rub {
    ($name:ident, $coordinates:ident) => {
        mechanism!($name {
            world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = $coordinates),
            link: Each(0..4, |k| Bar(
                mass = 0.5_kg,
                length = 0.1_m,
                angle = (-80.0 + 10.0 * k) * 1.0_deg
            )),
            top: Revolute(ground.origin, link[0].a),
            joint: Each(1..4, |k| Revolute(link[k - 1].b, link[k].a)),
            rub: Friction(
                top.rate,
                load = 0.5_Nm,
                coefficient = 0.3,
                regularization_velocity = 0.05_rad_per_s
            ),
            rate: Output(link[0].rate),
        });
    };
}

rub!(Rub, Joint);
rub!(RubOnRows, Reference);

#[test]
fn holonomic_rows_have_the_slopes() {
    slopes(DampedSliderCrank, 0.4, [(4, 0.02), (6, 0.04), (8, 0.1)]);
}

#[test]
fn nonholonomic_rows_have_the_slopes() {
    slopes(DampedSleigh::default(), 2.0, [(4, 0.1), (6, 0.2), (8, 0.5)]);
}

#[test]
fn rotations_have_the_slopes() {
    let soft = Sprung::<true> {
        stiffness: 100.0,
        damping: 1.0,
        ..Sprung::default()
    };
    slopes(soft, 0.4, [(4, 0.02), (6, 0.04), (8, 0.1)]);
}

/// A kick changes the velocity of a link by many times the regularization velocity: forces are taken before and after it.
#[test]
fn friction_beside_rows_keeps_its_digits() {
    macro_rules! rate {
        ($mechanism:ident, $settings:expr) => {{
            let mut simulation =
                Simulation::with_settings($mechanism::default(), $settings).unwrap();
            simulation.run_until(0.2).unwrap();
            simulation.outputs().rate
        }};
    }
    let fine = Settings {
        tolerance: Some(1e-9),
        ..settings(6, 1e-3)
    };
    let exact = rate!(Rub, fine);
    for (order, bound) in [(4, 1e-7), (6, 2e-9), (8, 2e-9)] {
        let settings = settings(order, 1e-3);
        let errors =
            [rate!(Rub, settings), rate!(RubOnRows, settings)].map(|rate| (rate - exact).abs());
        println!("order {order}: {errors:?} rad/s");
        assert!(errors.iter().all(|&error| error < bound), "{errors:?}");
    }
    let second = (rate!(RubOnRows, settings(2, 1e-3)) - exact).abs();
    let fourth = (rate!(RubOnRows, settings(4, 1e-3)) - exact).abs();
    assert!(fourth < 1e-2 * second, "{fourth:e} {second:e}");
}

/// Through eleven singular poses, at which steps are placed.
#[test]
fn singular_poses_are_passed() {
    let end = |order: u8, h: f64| {
        let settings = Settings {
            placement: true,
            ..settings(order, h)
        };
        run(DampedSliderCrank, settings, 10.0)
    };
    let fine = end(8, 1e-2);
    for (order, bound) in [(4, 1e-5), (6, 1e-7), (8, 1e-7)] {
        let end = end(order, 2e-2);
        let apart = distance(end.positions(), fine.positions());
        println!("order {order}: {apart:.1e} m, {:.1e} J", end.energy().error);
        assert!(apart < bound, "order {order}: {apart:e}");
    }
}

/// The work of dampers has the order of the motion.
#[test]
fn works_have_the_slope() {
    let lost = |h: f64| {
        let end = run(DampedSleigh::default(), settings(6, h), 2.0);
        assert!(end.energy().nonconservative_work < -0.1);
        end.energy().error.abs()
    };
    let slope = (lost(0.2) / lost(0.1)).log2();
    assert!((slope - 6.0).abs() < 0.8, "{slope}");
}

/// Rows hold to round-off after each step, although the mean of the columns does not satisfy them.
#[test]
fn rows_hold() {
    let end = run(DampedSliderCrank, settings(4, 0.05), 0.5);
    let report = end.report();
    assert!(report.holonomic_error < 1e-12, "{report:?}");
    assert!(report.velocity_error < 1e-11, "{report:?}");
}

#[test]
fn parts_are_counted() {
    for (order, parts) in [(4, 6), (6, 12), (8, 20)] {
        let report = run(DampedSliderCrank, settings(order, 1e-2), 0.2).report();
        assert_eq!((report.steps, report.stages), (20, 20 * parts));
    }
}

#[test]
fn a_resumed_run_is_the_same_bit_for_bit() {
    for order in [4, 6, 8] {
        let settings = Settings {
            placement: true,
            ..settings(order, 2e-2)
        };
        let mut whole = run(DampedSliderCrank, settings, 0.5);
        let state = whole.state().clone();
        let mut resumed =
            Simulation::resume(Parameters(DampedSliderCrank), settings, state).unwrap();
        whole.run_until(1.5).unwrap();
        resumed.run_until(1.5).unwrap();
        assert_eq!(whole.state(), resumed.state());
    }
}

#[test]
fn a_step_allocates_nothing() {
    for order in [4, 8] {
        let plain = settings(order, 1e-2);
        let placed = Settings {
            placement: true,
            ..plain
        };
        let paced = Settings {
            tolerance: Some(1e-6),
            ..placed
        };
        for settings in [plain, placed, paced] {
            let mut simulation =
                Simulation::with_settings(Parameters(DampedSliderCrank), settings).unwrap();
            let before = count();
            simulation.run_until(1.0).unwrap();
            assert_eq!(count() - before, 0, "{settings:?}");
        }
    }
}
