//! Steps chosen by a tolerance: errors in proportion to it, steps that do not follow the motion, instants between steps.

use crate::common::alloc::count;
use crate::common::planar::{DampedSliderCrank, FourBar, SliderCrank};
use crate::common::scenes::*;
use crate::common::spatial::{HeavyTop, Sprung};
use crate::common::{Hand, Parameters, Scene, distance, structure};
use mbs_runtime::nalgebra::SVector;
use mbs_runtime::{
    Method, PaperSettings, Settings, Simulation, SimulationError, Structure, mechanism, methods,
};

type Run<T, const Q: usize, const N: usize, const R: usize> = Simulation<Hand<T, Q, N, R>, Q, N, R>;

fn settings(order: u8, tolerance: f64) -> Settings {
    Settings {
        order,
        tolerance: Some(tolerance),
        ..Settings::default()
    }
}

fn begin<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    settings: Settings,
) -> Run<T, Q, N, R> {
    Simulation::with_settings(Parameters(scene), settings).unwrap()
}

/// The error after `time` stays within ten times each tolerance, and it falls with the tolerance.
fn proportional<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    order: u8,
    tolerances: &[f64],
    exact: &SVector<f64, Q>,
    time: f64,
) {
    let mut last = f64::INFINITY;
    for &tolerance in tolerances {
        let mut simulation = begin(scene.clone(), settings(order, tolerance));
        simulation.run_until(time).unwrap();
        let error = distance(simulation.positions(), exact);
        let report = simulation.report();
        println!("order {order}, tolerance {tolerance:e}: {error:.1e}, {report:?}");
        assert!(error < 10.0 * tolerance, "{tolerance:e}: {error:e}");
        assert!(error > 1e-5 * tolerance, "wasted: {tolerance:e}: {error:e}");
        assert!(error < last);
        last = error;
    }
}

fn fine<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    order: u8,
    step: f64,
    time: f64,
) -> SVector<f64, Q> {
    let settings = Settings {
        order,
        step,
        ..Settings::default()
    };
    let mut simulation = begin(scene, settings);
    simulation.run_until(time).unwrap();
    *simulation.positions()
}

#[test]
fn errors_follow_the_tolerance_through_singular_poses() {
    let exact = fine(SliderCrank, 8, 1e-3, 3.0);
    for order in [4, 6, 8] {
        proportional(SliderCrank, order, &[1e-5, 1e-7, 1e-9], &exact, 3.0);
    }
}

#[test]
fn errors_follow_the_tolerance_where_the_mass_varies() {
    let exact = fine(SliderCrankAngles, 8, 1e-3, 1.0);
    for order in [2, 6] {
        proportional(SliderCrankAngles, order, &[1e-4, 1e-6], &exact, 1.0);
    }
}

#[test]
fn errors_follow_the_tolerance_with_nonholonomic_rows() {
    let exact = fine(Sleigh::default(), 8, 1e-2, 5.0);
    for order in [2, 8] {
        proportional(Sleigh::default(), order, &[1e-4, 1e-6], &exact, 5.0);
    }
}

#[test]
fn errors_follow_the_tolerance_with_dampers() {
    let exact = fine(DampedSliderCrank, 2, 2e-5, 0.3);
    proportional(DampedSliderCrank, 2, &[1e-3, 1e-4, 1e-5], &exact, 0.3);
}

/// With an embedded estimate most pairs are kept without a comparison, and their length follows the motion. With a length
/// that does not, this run has 9492 calls of the accelerations and an error of 5.7e-8.
#[test]
fn estimates_take_the_place_of_comparisons() {
    let exact = fine(SliderCrank, 8, 1e-3, 10.0);
    let settings = Settings {
        method: Method::Projected,
        ..settings(8, 1e-8)
    };
    let mut simulation =
        Simulation::with_methods(Parameters(SliderCrank), settings, methods::Projected).unwrap();
    simulation.run_until(10.0).unwrap();
    let report = simulation.report();
    let error = distance(simulation.positions(), &exact);
    println!("{} calls, error {error:.1e}", report.stages);
    assert!(report.stages < 7000 && error < 1e-7);
}

/// Two steps of a pair, and one of twice their length, have three times the stages of a step.
fn keeps_most_pairs_without_comparison<
    T: Scene<Q, N, R>,
    const Q: usize,
    const N: usize,
    const R: usize,
>(
    scene: T,
    stages_of_a_step: u64,
) {
    let mut simulation = begin(scene, settings(8, 1e-8));
    simulation.run_until(10.0).unwrap();
    let report = simulation.report();
    let each = report.stages as f64 / (report.steps * stages_of_a_step) as f64;
    assert!(each < 1.3, "{each}: {report:?}");
}

#[test]
fn stages_take_the_place_of_comparisons() {
    keeps_most_pairs_without_comparison(HeavyTop, 17);
    keeps_most_pairs_without_comparison(Sprung::<true>::default(), 20);
}

mechanism!(HangingPendulum {
    world: Planar(),
    torque: Param(0.0_N_m),
    bar: Bar(length = 1.0_m, angle = -90.0_deg),
    bob: Particle(mass = 1.0_kg),
    pivot: Revolute(ground.origin, bar.a),
    joint: Revolute(bar.b, bob.origin),
    motor: Torque(bar, value = torque),
});

mechanism!(PendulumAtRest {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    bar: Bar(length = 1.0_m, angle = 180.0_deg),
    bob: Particle(mass = 1.0_kg),
    pivot: Revolute(ground.origin, bar.a),
    joint: Revolute(bar.b, bob.origin),
});

/// Steps of a mechanism at rest grow without end. A run that is a millionth of one of them is a run.
#[test]
fn a_rest_has_no_end() {
    let settings = Settings {
        method: Method::Projected,
        ..settings(8, 1e-6)
    };
    let hanging = HangingPendulum { torque: 0.0 };
    let mut simulation = Simulation::with_methods(hanging, settings, methods::Projected).unwrap();
    simulation.run_until(1e6).unwrap();
    let before = simulation.report().steps;
    simulation.run_until(1e6 + 1e-3).unwrap();
    assert!(simulation.report().steps > before);
}

/// A start at rest: there the error is a millionth of the estimate, a few steps later a tenth.
#[test]
fn errors_follow_the_tolerance_from_a_start_at_rest() {
    let run = |settings: Settings| {
        let mut simulation =
            Simulation::with_methods(PendulumAtRest {}, settings, methods::Projected).unwrap();
        simulation.run_until(10.0).unwrap();
        *simulation.positions()
    };
    let exact = run(Settings {
        step: 1e-3,
        order: 8,
        ..Settings::default()
    });
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-10] {
        let error = distance(
            &run(Settings {
                method: Method::Projected,
                ..settings(8, tolerance)
            }),
            &exact,
        );
        println!("tolerance {tolerance:e}: {error:.1e}");
        assert!(error < 10.0 * tolerance);
    }
}

/// At turning points one of the two differences of which the estimate is made is small. With the estimate of DOP853 this run had 2784
/// calls of the accelerations and an error of 8.2e-11.
#[test]
fn turning_points_are_no_harder_than_the_rest() {
    let settings = Settings {
        method: Method::Projected,
        ..settings(8, 1e-9)
    };
    let run = |settings: Settings| {
        let mut simulation =
            Simulation::with_methods(PendulumAtRest {}, settings, methods::Projected).unwrap();
        simulation.run_until(10.0).unwrap();
        (*simulation.positions(), simulation.report().stages)
    };
    let (exact, _) = run(Settings {
        step: 1e-3,
        tolerance: None,
        ..settings
    });
    let (positions, calls) = run(settings);
    let error = distance(&positions, &exact);
    println!("{calls} calls, error {error:.1e}");
    assert!(calls < 2720 && error < 8e-11);
}

/// A thousand seconds: the energy error does not grow, as the steps hardly change.
#[test]
fn energy_does_not_drift() {
    let mut simulation = begin(Oscillating, settings(4, 1e-4));
    simulation.run_until(20.0).unwrap();
    let (early, rejected) = (
        simulation.report().energy_error,
        simulation.report().rejected_steps,
    );
    simulation.run_until(1000.0).unwrap();
    let report = simulation.report();
    println!("{early:e} after 20 s, {report:?}");
    assert!(report.energy_error < 3.0 * early, "{early:e}, {report:?}");
    assert!(report.rejected_steps <= rejected + 12, "{report:?}");
}

#[test]
fn looking_changes_nothing() {
    let settings = settings(6, 1e-6);
    let mut alone = begin(FourBar, settings);
    alone.run_until(4.0).unwrap();
    let mut watched = begin(FourBar, settings);
    let exact = |time: f64| fine(FourBar, 8, 2.5e-3, time);
    let mut looks = 0;
    for instant in 1..=400 {
        let time = 0.01 * f64::from(instant);
        watched.run_past(time, 4.0).unwrap();
        watched
            .look_at(time, &mut |seen| {
                looks += 1;
                assert_eq!(seen.time(), time);
                let sample = seen.sample();
                assert!(sample.holonomic_error < 1e-10, "{sample:?}");
                assert!(sample.velocity_error < 1e-10, "{sample:?}");
                if instant % 80 == 0 {
                    let error = distance(&seen.coordinates(), &exact(time));
                    assert!(error < 1e-5, "t = {time}: {error:e}");
                }
            })
            .unwrap();
    }
    assert_eq!(looks, 400);
    assert_eq!(watched.state(), alone.state());
    assert_eq!(watched.report().steps, alone.report().steps);
    assert!(alone.report().steps < 300);
    let before = watched.state().clone();
    for outside in [5.0, 0.0, f64::NAN] {
        let error = watched.look_at(outside, &mut |_| ());
        assert!(
            matches!(error, Err(SimulationError::Time { .. })),
            "{error:?}"
        );
    }
    assert_eq!(watched.state(), &before);
}

#[test]
fn samples_fall_between_steps() {
    let mut simulation = begin(Oscillating, settings(8, 1e-6));
    let samples: Vec<_> = simulation.samples(2.0, 0.01).map(Result::unwrap).collect();
    assert_eq!(samples.len(), 201);
    for (number, sample) in samples.iter().enumerate() {
        assert!((sample.time - 0.01 * number as f64).abs() < 1e-12);
        assert!(sample.energy.error.abs() < 1e-5, "{sample:?}");
    }
    assert_eq!(simulation.time(), 2.0);
    assert!(simulation.report().steps < 100, "{:?}", simulation.report());
}

#[test]
fn a_resumed_run_is_the_same_bit_for_bit() {
    for order in [2, 6] {
        let settings = settings(order, 1e-5);
        let mut whole = begin(SliderCrank, settings);
        for _ in 0..20 {
            whole.step().unwrap();
        }
        let state = whole.state().clone();
        let mut resumed = Simulation::resume(Parameters(SliderCrank), settings, state).unwrap();
        whole.run_until(4.0).unwrap();
        resumed.run_until(4.0).unwrap();
        assert_eq!(whole.state(), resumed.state());
    }
}

#[test]
fn small_strides_are_as_good() {
    let exact = fine(FourBar, 8, 2.5e-3, 1.0);
    let mut simulation = begin(FourBar, settings(6, 1e-6));
    for stride in 1..=1000 {
        simulation.run_until(1e-3 * f64::from(stride)).unwrap();
    }
    let error = distance(simulation.positions(), &exact);
    assert!(error < 1e-5, "{error:e}");
}

#[test]
fn steps_of_a_tolerance_allocate_nothing() {
    for order in [2, 6] {
        let mut simulation = begin(FourBar, settings(order, 1e-4));
        simulation.step().unwrap();
        let before = count();
        simulation.run_until(5.0).unwrap();
        assert_eq!(count() - before, 0, "order {order}");
    }
}

#[test]
fn a_mechanism_at_rest_takes_long_steps() {
    let mut simulation = begin(Resting, settings(4, 1e-6));
    simulation.run_until(1000.0).unwrap();
    assert!(simulation.report().steps < 200, "{:?}", simulation.report());
    assert_eq!(simulation.report().rejected_steps, 0);
}

#[test]
fn noise_is_an_error_that_says_where() {
    let mut simulation = begin(Noisy, settings(2, 1e-6));
    let error = simulation.run_until(1.0).unwrap_err();
    let SimulationError::Tolerance { time, times, .. } = error else {
        panic!("{error}");
    };
    assert!(time < 1.0 && times > 1.0, "{error}");
    assert!(error.to_string().contains("tolerance 1.0e-6"), "{error}");
    // What was reached is kept.
    assert_eq!(simulation.time(), time);
}

#[test]
fn tolerances_that_make_no_sense_are_refused() {
    for tolerance in [0.0, -1.0, 1e-13, 0.5, f64::NAN, f64::INFINITY] {
        let settings = settings(2, tolerance);
        let error = Simulation::with_settings(Parameters(SliderCrank), settings).err();
        let name = match error {
            Some(SimulationError::Setting { name, .. }) => name,
            other => panic!("{other:?}"),
        };
        assert_eq!(name, "tolerance");
    }
    let paper = Settings {
        method: Method::Paper(PaperSettings::default()),
        ..settings(2, 1e-6)
    };
    let error = Simulation::with_settings(Parameters(SliderCrank), paper).err();
    assert!(error.unwrap().to_string().contains("two-level"));
}

mechanism!(Swing {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    mass: Param(1.0_kg),
    body: Body(
        mass = mass,
        inertia = diag(0.1, 0.2, 0.15),
        at = [1.0_m, 0.0, 0.0],
        angular_velocity = [1.0_rad_per_s, 2.0_rad_per_s, 3.0_rad_per_s]
    ),
    hold: Distance(ground.origin, body.origin, length = 1.0_m),
    level: Event(dot(body.x, ground.z)),
});

/// The cubic of the step foresees the event: few stages are spent on it.
#[test]
fn events_cost_few_stages() {
    for (settings, most) in [
        (
            Settings {
                step: 1e-2,
                ..Settings::default()
            },
            8,
        ),
        (
            Settings::for_tolerance(1e-4),
            // Eight looks of two steps of seven stages.
            112,
        ),
    ] {
        let mut simulation = Simulation::with_settings(Swing::default(), settings).unwrap();
        let found = simulation.run_to_event("level", 5.0).unwrap().unwrap();
        let mut plain = Simulation::with_settings(Swing::default(), settings).unwrap();
        plain.run_past(found, 5.0).unwrap();
        let spent = simulation.report().stages - plain.report().stages;
        println!("event at {found}: {spent} stages");
        assert!(spent <= most, "{spent}");
        let now = simulation.time();
        simulation.run_until(now + 1e-9).unwrap();
        assert_eq!(found, now);
    }
}

/// A mass on a nonlinear spring: ẍ = −x − x³.
#[derive(Clone, Default)]
struct Oscillating;

impl Scene<1, 1, 0> for Oscillating {
    const STRUCTURE: Structure = structure(true, false, 0);
    fn guess(&self) -> ([f64; 1], [f64; 1]) {
        ([1.5], [0.0])
    }
    fn mass(&self, _: &[f64; 1]) -> [[f64; 1]; 1] {
        [[1.0]]
    }
    fn force(&self, _: f64, [x]: &[f64; 1], _: &[f64; 1]) -> [f64; 1] {
        [-x - x.powi(3)]
    }
    fn rows(&self, _: f64, _: &[f64; 1]) -> ([f64; 0], [[f64; 1]; 0], [f64; 0]) {
        ([], [], [])
    }
    fn potential(&self, [x]: &[f64; 1]) -> f64 {
        0.5 * x * x + 0.25 * x.powi(4)
    }
}

/// The same mass where the spring is at ease.
#[derive(Clone, Default)]
struct Resting;

impl Scene<1, 1, 0> for Resting {
    const STRUCTURE: Structure = structure(true, false, 0);
    fn guess(&self) -> ([f64; 1], [f64; 1]) {
        ([0.0], [0.0])
    }
    fn mass(&self, _: &[f64; 1]) -> [[f64; 1]; 1] {
        [[1.0]]
    }
    fn force(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
        Oscillating.force(t, q, v)
    }
    fn rows(&self, _: f64, _: &[f64; 1]) -> ([f64; 0], [[f64; 1]; 0], [f64; 0]) {
        ([], [], [])
    }
    fn potential(&self, q: &[f64; 1]) -> f64 {
        Oscillating.potential(q)
    }
}

/// A force without any smoothness in time.
#[derive(Clone, Default)]
struct Noisy;

impl Scene<1, 1, 0> for Noisy {
    const STRUCTURE: Structure = structure(true, false, 0);
    fn guess(&self) -> ([f64; 1], [f64; 1]) {
        ([0.0], [1e-3])
    }
    fn mass(&self, _: &[f64; 1]) -> [[f64; 1]; 1] {
        [[1.0]]
    }
    fn force(&self, t: f64, _: &[f64; 1], _: &[f64; 1]) -> [f64; 1] {
        let bits = t.to_bits().wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32;
        [1e9 * (bits as f64 / f64::from(u32::MAX) - 0.5)]
    }
    fn rows(&self, _: f64, _: &[f64; 1]) -> ([f64; 0], [[f64; 1]; 0], [f64; 0]) {
        ([], [], [])
    }
    fn potential(&self, _: &[f64; 1]) -> f64 {
        0.0
    }
}
