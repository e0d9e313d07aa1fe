//! Planned eliminations beside singular poses: ten parallelograms in a row, whose bars are level in one pose.

use mbs_runtime::{
    BaumgarteSettings, Mechanism, Method, Settings, Simulation, State, System, mechanism, methods,
};
use mbs_tests::dense::Dense;

const GRAVITY: f64 = 9.81;
const LOOPS: u32 = 10;

mechanism!(Row {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    start: Param(1.0_rad),
    rate: Param(0.0_rad_per_s),
    crank: Each(0..=10, |i| Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        angle = start,
        rate = rate
    )),
    coupler: Each(1..=10, |i| Bar(mass = 1.0_kg, length = 1.0_m)),
    bearing: Each(0..=10, |i| Revolute(
        ground.point(i * 1.0_m, 0.0),
        crank[i].a
    )),
    left: Each(1..=10, |i| Revolute(crank[i - 1].b, coupler[i].a)),
    right: Each(1..=10, |i| Revolute(crank[i].b, coupler[i].b)),
    astray: Output((crank[0].b - crank[10].b).y),
});

// A coupler on three cranks, four times: one row of each follows from the others.
mechanism!(Tables {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Reference),
    start: Param(1.0_rad),
    rate: Param(0.0_rad_per_s),
    first: Each(0..4, |k| Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        angle = start,
        rate = rate
    )),
    middle: Each(0..4, |k| Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        angle = start,
        rate = rate
    )),
    last: Each(0..4, |k| Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        angle = start,
        rate = rate
    )),
    top: Each(0..4, |k| Bar(mass = 1.0_kg, length = 2.0_m)),
    foot: Each(0..4, |k| Revolute(
        ground.point(k * 4.0_m, 0.0_m),
        first[k].a
    )),
    stay: Each(0..4, |k| Revolute(
        ground.point(k * 4.0_m + 1.0_m, 0.0_m),
        middle[k].a
    )),
    heel: Each(0..4, |k| Revolute(
        ground.point(k * 4.0_m + 2.0_m, 0.0_m),
        last[k].a
    )),
    left: Each(0..4, |k| Revolute(first[k].b, top[k].a)),
    centre: Each(0..4, |k| Revolute(middle[k].b, top[k].point(1.0_m, 0.0_m))),
    right: Each(0..4, |k| Revolute(last[k].b, top[k].b)),
});

/// Velocities after a step of this length, by Runge–Kutta steps without terms of Baumgarte.
fn velocities_after<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: M,
    step: f64,
) -> [Vec<f64>; 2]
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let settings = Settings {
        method: Method::Baumgarte(BaumgarteSettings {
            gain: 0.0,
            ..BaumgarteSettings::default()
        }),
        order: 4,
        step,
        ..Settings::default()
    };
    let simulation = Simulation::with_methods(mechanism, settings, methods::Baumgarte);
    let mut simulation = simulation.expect("assembled");
    let state = |state: &State<Q, N, R>| state.velocities.as_slice().to_vec();
    let before = state(simulation.state());
    simulation.step().expect("a step");
    [before, state(simulation.state())]
}

/// The largest error of the accelerations of the tips at this angle, from rest, relative.
fn error_at<M, S, const Q: usize, const N: usize, const R: usize>(mechanism: M, angle: f64) -> f64
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    // From rest velocities are the accelerations, to all digits.
    const STEP: f64 = 1e-8;
    let [_, after] = velocities_after(mechanism, STEP);
    let (cranks, couplers) = (f64::from(LOOPS + 1), f64::from(LOOPS));
    let turning = -GRAVITY * (0.5 * cranks + couplers) / (cranks / 3.0 + couplers) * angle.cos();
    let exact = [-turning * angle.sin(), turning * angle.cos()];
    let errors = after.iter().enumerate();
    let errors = errors.map(|(i, v)| (v / STEP - exact[i % 2]).abs());
    errors.fold(0.0, f64::max) / turning.abs()
}

/// How many rows of the plan of a mechanism follow from others; `None` without a plan.
fn redundant<M, S, const Q: usize, const N: usize, const R: usize>(_: &M) -> Option<usize>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    S::ELIMINATION.map(|plan| plan.redundant)
}

#[test]
fn the_mechanisms_have_plans() {
    assert_eq!(redundant(&Row::default()), Some(0));
    assert_eq!(redundant(&Tables::default()), Some(4));
    assert_eq!(redundant(&Dense(Row::default())), None);
}

#[test]
fn accelerations_are_exact_beside_singular_poses() {
    for power in 1..=12 {
        let angle = 0.1_f64.powi(power);
        let row = || Row {
            start: angle,
            ..Row::default()
        };
        let [planned, dense] = [error_at(row(), angle), error_at(Dense(row()), angle)];
        println!("{angle:.0e} rad: {planned:.1e}, with dense arrays {dense:.1e}");
        // With round-off of 1e-16 a direction is lost where σ² is.
        assert!(power > 5 || planned < 1e-11, "{angle:e}: {planned:e}");
        assert!(
            planned < 1.01 * dense + 1e-14,
            "{angle:e}: {planned:e} {dense:e}"
        );
    }
}

#[test]
fn accelerations_with_redundant_rows_are_those_with_dense_arrays() {
    for power in 1..=12 {
        let angle = 0.1_f64.powi(power);
        let tables = || Tables {
            start: angle,
            rate: 0.5,
        };
        let step = 1e-3 * angle.max(1e-4);
        let [before, planned] = velocities_after(tables(), step);
        let [_, dense] = velocities_after(Dense(tables()), step);
        let apart = planned.iter().zip(&dense).map(|(a, b)| (a - b).abs());
        let gained = dense.iter().zip(&before).map(|(a, b)| (a - b).abs());
        let [apart, gained] = [apart.fold(0.0, f64::max), gained.fold(0.0, f64::max)];
        println!("{angle:.0e} rad: {apart:.1e} of {gained:.1e} m/s");
        assert!(apart < 1e-6 * gained, "{angle:e}: {apart:e} of {gained:e}");
    }
}

/// With the bound of dense arrays half of these runs ended on another branch, or failed.
#[test]
fn constant_steps_stay_on_their_branch() {
    for steps in (200..700).step_by(50) {
        let settings = Settings {
            method: Method::Projected,
            order: 8,
            step: 10.0 / f64::from(steps),
            placement: false,
            ..Settings::default()
        };
        let row = Row {
            start: std::f64::consts::FRAC_PI_2,
            rate: -1.0,
        };
        let row = Simulation::with_methods(row, settings, methods::Projected);
        let mut row = row.expect("assembled");
        row.run_until(10.0).expect("the end");
        let (error, astray) = (row.report().energy_error, row.outputs().astray);
        println!("{steps} steps: {error:.1e} J, {astray:.1e} m");
        assert!(
            error < 1e-4 && astray.abs() < 1e-4,
            "{steps} steps: {error:e} J"
        );
    }
}

/// Starts in the pose, from rest and not, with constant steps and with a tolerance: each pose is noticed.
#[test]
fn starts_in_a_singular_pose_go_on() {
    for rate in [0.0, 1e-3, 1.0] {
        for tolerance in [None, Some(1e-3), Some(1e-6)] {
            let settings = Settings {
                method: Method::Projected,
                order: if tolerance.is_none() { 4 } else { 8 },
                step: 5e-3,
                tolerance,
                ..Settings::default()
            };
            let row = Row { start: 0.0, rate };
            let row = Simulation::with_methods(row, settings, methods::Projected);
            let mut row = row.expect("assembled");
            row.run_until(1.0).expect("the end");
            let first = row.rank_losses()[0].time;
            let error = row.report().energy_error;
            println!("{rate} rad/s, {tolerance:?}: {error:.1e} J, first pose at {first:.1e} s");
            assert!(first < 0.01 && error < 0.02);
            assert!(row.outputs().astray.abs() < 0.01);
        }
    }
}
