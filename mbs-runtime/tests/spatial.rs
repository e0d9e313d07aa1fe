//! Rigid bodies in space: unit quaternions, free flight, and every flow on them.

use crate::common::alloc::count;
use crate::common::bricard::Bricard;
use crate::common::space::{cross, matrix, scaled, sum, to_space};
use crate::common::spatial::*;
use crate::common::{Hand, Parameters, Scene, distance, unit};
use mbs_runtime::generated::entries;
use mbs_runtime::nalgebra::SVector;
use mbs_runtime::{
    Configuration, Flow, Method, PaperSettings, Settings, Simulation, SimulationError, State,
    TwoLevelStepper,
};

type Run<T, const Q: usize, const N: usize, const R: usize> = Simulation<Hand<T, Q, N, R>, Q, N, R>;

fn settings(order: u8, step: f64) -> Settings {
    Settings {
        order,
        step,
        ..Settings::default()
    }
}

fn by(flow: Flow, step: f64) -> Settings {
    Settings {
        flow: Some(flow),
        ..settings(2, step)
    }
}

fn run<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    settings: Settings,
    time: f64,
) -> Run<T, Q, N, R> {
    let mut simulation = Simulation::with_any_method(Parameters(scene), settings).unwrap();
    simulation.run_until(time).unwrap();
    let (flow, order, step) = (simulation.flow().name(), settings.order, settings.step);
    println!("{flow} order {order} h = {step}: {:?}", simulation.report());
    for &i in T::ROTATIONS {
        // One body after the other: seven coordinates for six velocities.
        let q = &simulation.positions().as_slice()[i + i / 6..][..4];
        let length = q.iter().map(|x| x * x).sum::<f64>();
        assert!((length - 1.0).abs() < 1e-15, "|q|² − 1 = {}", length - 1.0);
    }
    simulation
}

/// log₂ of the ratio of the errors with h and h/2.
fn slope<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    settings: Settings,
    time: f64,
    exact: &SVector<f64, Q>,
) -> f64 {
    let error = |step: f64| {
        let settings = Settings { step, ..settings };
        distance(run(scene.clone(), settings, time).positions(), exact)
    };
    let (coarse, fine) = (error(settings.step), error(0.5 * settings.step));
    let slope = (coarse / fine).log2();
    println!("errors {coarse:.2e} {fine:.2e}, slope {slope:.2}");
    slope
}

fn assert_slope(slope: f64, order: u8) {
    let order = f64::from(order);
    assert!(
        (slope - order).abs() < 0.12 * order,
        "order {order}: {slope}"
    );
}

/// Forward, velocities reversed, back: the distance from where it began.
fn reversal<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    settings: Settings,
    time: f64,
) -> f64 {
    let start = Simulation::with_settings(Parameters(scene.clone()), settings).unwrap();
    let forward = run(scene.clone(), settings, time);
    let back = State::new(0.0, *forward.positions(), forward.velocities().map(|v| -v));
    let mut simulation = Simulation::resume(Parameters(scene), settings, back).unwrap();
    simulation.run_until(time).unwrap();
    let error = distance(simulation.positions(), start.positions());
    println!("reversal {error:e}");
    error
}

/// The scenes themselves: A is the derivative of φ along the velocities.
fn rows_are_derivatives<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>() {
    let system = Hand::<T, Q, N, R>::new(T::default());
    let (guess, _) = system.guess();
    let way = SVector::from_fn(|i, _| (1.3 * i as f64).sin());
    let q = system.advance(&guess, &way, 0.3);
    let rows = system.scene.rows(0.0, entries(&q)).1;
    for j in 0..N {
        let at = |e: f64| {
            let q = system.advance(&q, &unit(j), e);
            system.scene.rows(0.0, entries(&q)).0
        };
        let (low, high) = (at(-1e-5), at(1e-5));
        for i in 0..T::STRUCTURE.holonomic_rows {
            let slope = (high[i] - low[i]) / 2e-5;
            assert!((rows[i][j] - slope).abs() < 1e-9, "row {i}, column {j}");
        }
    }
}

#[test]
fn scenes_are_consistent() {
    rows_are_derivatives::<HeavyTop, 7, 6, 3>();
    rows_are_derivatives::<RollingDisk, 7, 6, 3>();
    rows_are_derivatives::<Bricard, 35, 30, 30>();
}

#[test]
fn flows_follow_the_structure() {
    let flow = |settings| run(Sprung::<false>::default(), settings, 0.01).flow();
    assert_eq!(flow(settings(2, 1e-3)), Flow::Leapfrog);
    assert_eq!(flow(settings(2, 1e-2)), Flow::Trapezoid);
    let damped = run(Sprung::<true>::default(), settings(2, 1e-3), 0.01);
    assert_eq!(damped.flow(), Flow::Implicit);
    // ω × Jω is no velocity-dependent force: free flight takes care of it.
    assert_eq!(
        run(HeavyTop, settings(2, 1e-3), 0.01).flow(),
        Flow::Leapfrog
    );
}

#[test]
fn a_free_body_keeps_its_angular_momentum() {
    let body = FreeBody::default();
    let momentum = |q: &[f64; 7], v: &[f64; 6]| {
        let l = std::array::from_fn(|i| body.0[i] * v[3 + i]);
        to_space(&matrix(&q[3..]), l)
    };
    let (q, v) = body.guess();
    let start = momentum(&q, &v);
    for order in [2, 4, 6, 8] {
        let end = run(body.clone(), settings(order, 0.05), 50.0);
        let (position, velocity) = (entries(end.positions()), entries(end.velocities()));
        let drift = distance(&momentum(position, velocity), &start);
        assert!(drift < 4e-12, "{drift:e}");
        assert_eq!(velocity[..3], v[..3]);
    }
    // Bounded: ten times as long a run has no larger error.
    let error = |time: f64| {
        run(body.clone(), settings(2, 0.05), time)
            .report()
            .energy_error
    };
    assert!(error(200.0) < 1.2 * error(20.0) && error(20.0) < 1e-2);
}

#[test]
fn a_free_body_has_the_slopes() {
    let body = FreeBody::default();
    let exact = *run(body.clone(), settings(8, 0.01), 2.0).positions();
    for (order, step) in [(2, 0.05), (4, 0.1), (6, 0.2), (8, 0.4)] {
        let slope = slope(body.clone(), settings(order, step), 2.0, &exact);
        assert_slope(slope, order);
    }
    for flow in [Flow::Trapezoid, Flow::Implicit] {
        assert_slope(slope(body.clone(), by(flow, 0.02), 2.0, &exact), 2);
    }
}

/// A symmetric top without forces moves exactly, however long the step.
#[test]
fn a_free_top_moves_exactly() {
    let top = FreeBody([2.0, 0.5, 2.0]);
    let [one, many] =
        [2.0, 0.002].map(|step| *run(top.clone(), settings(2, step), 2.0).positions());
    assert!(distance(&one, &many) < 1e-12);
}

/// Quadruple precision, 16 digits: centre of mass and rotation after 2 s.
const TOP_AT_2: [f64; 7] = [
    -1.5041682274564176e-01,
    -7.2416559163689565e-01,
    -6.7302226956044410e-01,
    1.2294713504153347e-01,
    -4.9107989255002701e-01,
    3.5043003034362096e-01,
    -7.8798688755048567e-01,
];

#[test]
fn the_heavy_top_is_as_published() {
    for (order, step) in [(2, 2e-3), (4, 4e-3), (6, 8e-3), (8, 1e-2)] {
        let slope = slope(HeavyTop, settings(order, step), 2.0, &TOP_AT_2.into());
        assert_slope(slope, order);
    }
    let end = run(HeavyTop, settings(8, 2e-3), 2.0);
    assert!(distance(end.positions(), &TOP_AT_2) < 1e-10);
    // The spin of a symmetric top is a constant of the motion.
    assert!((end.velocities()[4] - 150.0).abs() < 1e-10);
    let [one, two] = [1e-2, 1e-3].map(|h| run(HeavyTop, settings(2, h), 2.0).report());
    assert!(one.iterations <= 3 * one.stages && two.iterations <= 2 * two.stages);
}

#[test]
fn the_pivot_holds_the_top() {
    let start = Simulation::with_settings(Parameters(HeavyTop), settings(2, 1e-3)).unwrap();
    // The hand-written scene takes its second derivatives by differences.
    let force = start.reactions().unwrap().multipliers;
    let expected = [0.0, -3.1952598816600000e+02, -3.1726246153846154e+02];
    assert!(distance(&force, &expected) < 1e-3, "{force:?}");
    let end = run(HeavyTop, settings(8, 2e-3), 2.0);
    let force = end.reactions().unwrap().multipliers;
    let expected = [-260.73521131108336, 613.61269898259720, 309.71663139093925];
    assert!(distance(&force, &expected) < 1e-3, "{force:?}");
}

#[test]
fn algorithm_1_follows_the_top() {
    let paper = |step| Settings {
        method: Method::Paper(PaperSettings {
            velocity_tolerance: 1e-9,
            ..PaperSettings::default()
        }),
        ..settings(2, step)
    };
    let exact = *run(HeavyTop, settings(8, 1e-3), 0.2).positions();
    assert_slope(slope(HeavyTop, paper(4e-4), 0.2, &exact), 2);
}

/// Rank 29 of 30 rows, and a rod that comes to rest now and then.
#[test]
fn bricard_keeps_its_energy() {
    let error = |order, step| {
        let run = run(Bricard::default(), settings(order, step), 1.0);
        let report = run.report();
        assert_eq!(report.rank, 29);
        assert!(report.holonomic_error < 1e-11 && report.velocity_error < 1e-11);
        // A Newton iteration that sees the turn of the rods.
        assert!(report.iterations <= 3 * report.stages, "{report:?}");
        report.energy_error
    };
    for (order, bound) in [(2, 1.6e-3), (4, 3e-8), (6, 5e-11)] {
        let (coarse, fine) = (error(order, 0.04), error(order, 0.02));
        assert_slope((coarse / fine).log2(), order);
        assert!(fine < bound, "{fine:e}");
    }
}

/// Hardly any inertia about the axes of the rods: rows that are weak, but not lost.
#[test]
fn slender_rods_cost_no_more() {
    for order in [2, 6] {
        let report = run(Bricard::slender(), settings(order, 0.02), 1.0).report();
        assert_eq!((report.rejected_steps, report.placed_steps), (0, 0));
        assert!(report.iterations <= 4 * report.stages, "{report:?}");
        assert!(report.velocity_error < 1e-11 && report.rank_losses == 0);
        assert!(report.energy_error < if order == 2 { 2e-3 } else { 1e-8 });
    }
}

/// Quadruple precision, 16 digits: centre and rotation after 10 s (the other of the two unit quaternions).
const DISK_AT_10: [f64; 7] = [
    3.8523311538813135,
    -7.0298799637407730,
    3.9950340236824528e-01,
    -2.5791948097928095e-01,
    -7.6570688885257865e-01,
    -4.3841263918934489e-01,
    3.9365576268373919e-01,
];

#[test]
fn a_disk_rolls_as_it_should() {
    for (order, step) in [(2, 0.01), (4, 0.025), (6, 0.05), (8, 0.05)] {
        let slope = slope(RollingDisk, settings(order, step), 10.0, &DISK_AT_10.into());
        assert_slope(slope, order);
    }
    let end = run(RollingDisk, settings(8, 0.01), 10.0);
    assert!(distance(end.positions(), &DISK_AT_10) < 1e-9);
    assert!(end.report().energy_error < 1e-10);
}

#[test]
fn stiff_springs_are_taken_by_the_trapezoid() {
    let soft = Sprung::<false> {
        stiffness: 200.0,
        ..Sprung::default()
    };
    let exact = *run(soft.clone(), settings(8, 1e-2), 1.0).positions();
    for flow in [Flow::Leapfrog, Flow::Trapezoid, Flow::Implicit] {
        assert_slope(slope(soft.clone(), by(flow, 1e-2), 1.0, &exact), 2);
    }
    for order in [4, 6] {
        let settings = Settings {
            flow: Some(Flow::Trapezoid),
            ..settings(order, 0.02)
        };
        assert_slope(slope(soft.clone(), settings, 1.0, &exact), order);
    }
    // From 5e5 N/m on energy grows, and whether a run ends is a matter of luck.
    for percent in 0..8 {
        let stiff = Sprung::<false> {
            stiffness: 1e5 + 1e3 * f64::from(percent),
            ..Sprung::default()
        };
        let report = run(stiff, settings(2, 1e-2), 2.0).report();
        assert!(report.iterations <= 5 * report.stages, "{report:?}");
        assert!(report.energy_error < 0.5, "{report:?}");
    }
}

#[test]
fn damping_is_paid_for() {
    let damped = Sprung::<true> {
        stiffness: 500.0,
        damping: 20.0,
        ..Sprung::default()
    };
    let exact = *run(damped.clone(), settings(2, 1e-4), 0.5).positions();
    assert_slope(slope(damped.clone(), settings(2, 4e-3), 0.5, &exact), 2);
    let [coarse, fine] = [4e-3, 2e-3].map(|h| run(damped.clone(), settings(2, h), 0.5));
    assert!(fine.energy().nonconservative_work < -0.1);
    let ratio = coarse.report().energy_error / fine.report().energy_error;
    assert_slope(ratio.log2(), 2);
}

#[test]
fn steps_are_reversible() {
    assert!(reversal(FreeBody::default(), settings(2, 0.05), 5.0) < 1e-11);
    assert!(reversal(FreeBody::default(), by(Flow::Trapezoid, 0.05), 5.0) < 1e-11);
    assert!(reversal(HeavyTop, settings(2, 2e-3), 0.5) < 1e-9);
    assert!(reversal(HeavyTop, by(Flow::Trapezoid, 2e-3), 0.5) < 1e-9);
    assert!(reversal(RollingDisk, settings(2, 1e-2), 5.0) < 1e-9);
    assert!(reversal(Bricard::default(), settings(2, 1e-2), 1.0) < 1e-9);
    assert!(reversal(Sprung::<false>::default(), settings(2, 1e-3), 0.5) < 1e-9);
    assert!(reversal(Sprung::<false>::default(), by(Flow::Trapezoid, 1e-2), 0.5) < 1e-9);
}

fn allocations<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    settings: Settings,
) -> u64 {
    let start = Simulation::with_settings(Parameters(scene.clone()), settings).unwrap();
    let state = start.state().clone();
    let mut stepper = TwoLevelStepper::new(Hand::new(scene), state, &settings).unwrap();
    // The first step of a composition makes room.
    stepper.step(settings.step).unwrap();
    let before = count();
    for _ in 0..20 {
        stepper.step(settings.step).unwrap();
    }
    count() - before
}

#[test]
fn steps_allocate_nothing() {
    for order in [2, 6] {
        assert_eq!(allocations(FreeBody::default(), settings(order, 1e-2)), 0);
        assert_eq!(allocations(HeavyTop, settings(order, 1e-2)), 0);
        assert_eq!(allocations(RollingDisk, settings(order, 1e-2)), 0);
        assert_eq!(allocations(Bricard::default(), settings(order, 1e-2)), 0);
    }
    let stiff = Sprung::<false>::default();
    assert_eq!(allocations(stiff, by(Flow::Trapezoid, 1e-2)), 0);
    assert_eq!(allocations(Sprung::<true>::default(), settings(2, 1e-2)), 0);
}

/// A guess that is not assembled, with a quaternion that is not of unit length.
#[derive(Clone, Default)]
struct Careless;

impl Scene<7, 6, 3> for Careless {
    const STRUCTURE: mbs_runtime::Structure = HeavyTop::STRUCTURE;
    const ROTATIONS: &'static [usize] = HeavyTop::ROTATIONS;
    const ROWS: &'static [mbs_runtime::Row] = HeavyTop::ROWS;
    fn guess(&self) -> ([f64; 7], [f64; 6]) {
        let (q, v) = HeavyTop.guess();
        let mut far = [0.1, 1.2, -0.1, 2.0, 0.1, 0.0, 0.3];
        far[3] += q[3];
        (far, v)
    }
    fn mass(&self, q: &[f64; 7]) -> [[f64; 6]; 6] {
        Scene::mass(&HeavyTop, q)
    }
    fn force(&self, t: f64, q: &[f64; 7], v: &[f64; 6]) -> [f64; 6] {
        HeavyTop.force(t, q, v)
    }
    fn kinetic_gradient(&self, q: &[f64; 7], v: &[f64; 6]) -> [f64; 6] {
        HeavyTop.kinetic_gradient(q, v)
    }
    fn spins(&self) -> Vec<mbs_runtime::generated::Spin> {
        HeavyTop.spins()
    }
    fn rows(&self, t: f64, q: &[f64; 7]) -> ([f64; 3], [[f64; 6]; 3], [f64; 3]) {
        HeavyTop.rows(t, q)
    }
    fn potential(&self, q: &[f64; 7]) -> f64 {
        HeavyTop.potential(q)
    }
}

#[test]
fn assembly_moves_on_the_group() {
    let simulation = run(Careless, settings(2, 1e-3), 0.0);
    let verdict = simulation.assembly();
    assert!(
        verdict.residual < 1e-12 && verdict.moved > 0.05,
        "{verdict:?}"
    );
    let (q, v) = (simulation.positions(), simulation.velocities());
    let r = matrix(&entries(q)[3..]);
    let arm = to_space(&r, [0.0, 1.0, 0.0]);
    assert!(distance(&arm, &entries(q)[..3]) < 1e-12);
    let speed = cross(to_space(&r, [v[3], v[4], v[5]]), arm);
    let slip = sum([v[0], v[1], v[2]], scaled(-1.0, speed));
    assert!(distance(&slip, &[0.0; 3]) < 1e-12);
}

#[test]
fn states_are_resumed_bit_for_bit_or_refused() {
    let settings = settings(4, 1.0 / 128.0);
    let whole = run(HeavyTop, settings, 1.0);
    let half = run(HeavyTop, settings, 0.5);
    let resume = |state| Simulation::resume(Parameters(HeavyTop), settings, state);
    let mut rest = resume(half.state().clone()).unwrap();
    rest.run_until(1.0).unwrap();
    assert_eq!(rest.positions(), whole.positions());
    let mut longer = half.state().clone();
    longer.positions.rows_mut(3, 4).scale_mut(1.01);
    let error = resume(longer).err();
    assert!(
        matches!(error, Some(SimulationError::State { .. })),
        "{error:?}"
    );
    let mut none = half.state().clone();
    none.positions.rows_mut(3, 4).fill(0.0);
    let error = resume(none).err();
    assert!(
        matches!(error, Some(SimulationError::State { .. })),
        "{error:?}"
    );
}
