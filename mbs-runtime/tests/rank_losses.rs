//! Singular poses on the way are found, whatever the step; rows that are always redundant are none.

use crate::common::bricard::Bricard;
use crate::common::planar::{FourBar, SliderCrank};
use crate::common::scenes::StiffPendulum;
use crate::common::spatial::{HeavyTop, RollingDisk};
use crate::common::{Hand, Parameters, Scene, row};
use mbs_runtime::{Row, RowKind::Holonomic, Settings, Simulation, Structure};

type Run<T, const Q: usize, const N: usize, const R: usize> = Simulation<Hand<T, Q, N, R>, Q, N, R>;

fn start<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    order: u8,
    step: f64,
    placement: bool,
) -> Run<T, Q, N, R> {
    let settings = Settings {
        order,
        step,
        placement,
        ..Settings::default()
    };
    Simulation::with_settings(Parameters(scene), settings).unwrap()
}

fn run<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    order: u8,
    step: f64,
) -> Run<T, Q, N, R> {
    let mut simulation = start(scene, order, step, true);
    simulation.run_until(10.0).unwrap();
    assert_eq!(
        simulation.report().rank_losses,
        simulation.rank_losses().len()
    );
    simulation
}

/// Quadruple precision: the first passages of the slider-crank.
const TIMES: [f64; 3] = [0.39174, 1.27701, 2.16228];

#[test]
fn the_slider_crank_passes_eleven_times() {
    for (order, step) in [(2, 1e-3), (2, 1e-2), (6, 1e-2), (6, 4e-2)] {
        let run = run(SliderCrank, order, step);
        let losses = run.rank_losses();
        assert_eq!(losses.len(), 11, "order {order}, h = {step}: {losses:?}");
        for (loss, time) in losses.iter().zip(TIMES) {
            assert!(
                (loss.time - time).abs() < 5.0 * step * step + 2e-4,
                "{loss:?}"
            );
            assert!(loss.sigma_min < 0.02, "{loss:?}");
            let mut joints = loss.joints().to_vec();
            joints.sort_unstable();
            assert_eq!(joints, ["crank.length", "liner", "rod.length"]);
        }
    }
}

#[test]
fn placement_makes_no_difference() {
    let mut simulation = start(SliderCrank, 2, 1e-3, false);
    simulation.run_until(10.0).unwrap();
    assert_eq!(simulation.rank_losses().len(), 11);
}

/// The slider-crank with each row twice.
#[derive(Clone, Default)]
struct Twice;

impl Scene<4, 4, 6> for Twice {
    const STRUCTURE: Structure = Structure {
        holonomic_rows: 6,
        ..SliderCrank::STRUCTURE
    };
    const ROWS: &'static [Row] = &[
        row("crank.length", Holonomic),
        row("rod.length", Holonomic),
        row("liner", Holonomic),
        row("crank.copy", Holonomic),
        row("rod.copy", Holonomic),
        row("liner.copy", Holonomic),
    ];
    fn guess(&self) -> ([f64; 4], [f64; 4]) {
        SliderCrank.guess()
    }
    fn mass(&self, q: &[f64; 4]) -> [[f64; 4]; 4] {
        Scene::mass(&SliderCrank, q)
    }
    fn force(&self, t: f64, q: &[f64; 4], v: &[f64; 4]) -> [f64; 4] {
        SliderCrank.force(t, q, v)
    }
    fn rows(&self, t: f64, q: &[f64; 4]) -> ([f64; 6], [[f64; 4]; 6], [f64; 6]) {
        let (phi, a, _) = SliderCrank.rows(t, q);
        let phi = std::array::from_fn(|i| phi[i % 3]);
        (phi, std::array::from_fn(|i| a[i % 3]), [0.0; 6])
    }
    fn potential(&self, q: &[f64; 4]) -> f64 {
        SliderCrank.potential(q)
    }
}

#[test]
fn redundant_rows_are_no_losses() {
    let (single, doubled) = (run(SliderCrank, 2, 1e-2), run(Twice, 2, 1e-2));
    let (single, doubled) = (single.rank_losses(), doubled.rank_losses());
    assert_eq!(single.len(), doubled.len(), "{doubled:?}");
    for (one, other) in single.iter().zip(doubled) {
        assert!((one.time - other.time).abs() < 1e-2, "{one:?} {other:?}");
    }
    assert_eq!(run(FourBar, 2, 1e-2).rank_losses().len(), 10);
    assert!(run(Bricard::default(), 2, 1e-2).rank_losses().is_empty());
}

#[test]
fn mechanisms_without_singular_poses_report_none() {
    assert!(run(HeavyTop, 2, 1e-3).rank_losses().is_empty());
    assert!(run(RollingDisk, 2, 1e-2).rank_losses().is_empty());
    let damped = StiffPendulum::default();
    assert!(run(damped, 2, 1e-2).rank_losses().is_empty());
}

/// A step that is taken again to find an event counts once.
#[test]
fn events_in_the_pose_itself_count_once() {
    let mut simulation = start(SliderCrank, 2, 1e-2, true);
    for time in TIMES {
        let found = simulation.run_to_event("crank_upright", 3.0).unwrap();
        assert!((found.unwrap() - time).abs() < 1e-3);
    }
    simulation.run_until(2.5).unwrap();
    let losses = simulation.rank_losses();
    assert_eq!(losses.len(), 3, "{losses:?}");
    for (loss, time) in losses.iter().zip(TIMES) {
        assert!((loss.time - time).abs() < 1e-3, "{loss:?}");
    }
}

/// The list grew with the run, and allocated in a step.
#[test]
fn the_last_passages_are_kept_and_all_are_counted() {
    let mut simulation = start(SliderCrank, 2, 1e-2, true);
    simulation.run_until(80.0).unwrap();
    let (losses, count) = (simulation.rank_losses(), simulation.report().rank_losses);
    assert_eq!(losses.len(), 64);
    assert!((85..95).contains(&count), "{count}");
    assert!(losses.windows(2).all(|pair| pair[0].time < pair[1].time));
    assert!(losses[63].time > 78.0 && losses[0].time > 10.0);
    let copy = simulation.clone();
    assert_eq!(copy.report().rank_losses, count);
}
