//! Algorithm 1: what it does at singular poses, loose and tight.

use crate::common::planar::SliderCrank;
use crate::common::scenes::SliderCrankAngles;
use crate::common::scenes::{DampedSleigh, Shaken, Sleigh};
use crate::common::{Hand, Parameters, Scene, distance};
use mbs_runtime::nalgebra::SVector;
use mbs_runtime::{
    Constraints, Method, MultiplierStart, PaperSettings, PaperStepper, RowDirection, Settings,
    Simulation, mechanism,
};

mechanism!(Spring {
    world: Planar(),
    stiffness: Param(1e13_N_per_m),
    bob: Particle(
        mass = 1.0_kg,
        at = [0.1_m, 0.0],
        velocity = [0.0_m_per_s, 0.3]
    ),
    spring: SpringDamper(ground.origin, bob.origin, stiffness = stiffness),
});

fn start<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    step: f64,
    paper: PaperSettings,
) -> Simulation<Hand<T, Q, N, R>, Q, N, R> {
    let settings = Settings {
        step,
        method: Method::Paper(paper),
        ..Settings::default()
    };
    Simulation::with_any_method(Parameters(scene), settings).unwrap()
}

fn tolerance(velocity_tolerance: f64) -> PaperSettings {
    PaperSettings {
        velocity_tolerance,
        ..PaperSettings::default()
    }
}

fn fine(residual_tolerance: f64) -> PaperSettings {
    PaperSettings {
        residual_tolerance,
        newton_tolerance: 1e-10,
        penalty: 1e4,
        ..tolerance(residual_tolerance)
    }
}

/// The accuracy of 0.01 that the paper names, and a penalty that suits the step.
fn accuracy() -> PaperSettings {
    PaperSettings {
        penalty: 1e4,
        ..tolerance(1e-2)
    }
}

/// max |E − E₀| and rejected steps over 10 s of the slider-crank.
fn over_ten_seconds(paper: PaperSettings) -> (f64, u64) {
    let mut simulation = start(SliderCrank, 1e-3, paper);
    let result = simulation.run_until(10.0);
    let report = simulation.report();
    println!("t = {} {report:?}", simulation.time());
    result.unwrap();
    (report.energy_error, report.rejected_steps)
}

#[test]
fn a_warm_start_keeps_the_energy_at_singular_poses_and_a_cold_one_does_not() {
    let (warm, rejected) = over_ten_seconds(accuracy());
    assert!(warm < 1e-2, "{warm} J");
    assert_eq!(rejected, 0);
    let (cold, _) = over_ten_seconds(PaperSettings {
        start: MultiplierStart::Cold,
        ..accuracy()
    });
    assert!(cold > 100.0 * warm, "{cold} and {warm} J");
}

/// k̄ = m̄ω² and c̄ = 2m̄ω bring φ back, and take energy.
#[test]
fn stiffness_of_the_rows_brings_positions_back() {
    let run = |stabilisation_frequency| {
        let paper = PaperSettings {
            stabilisation_frequency,
            ..accuracy()
        };
        let mut simulation = start(SliderCrank, 1e-3, paper);
        simulation.run_until(0.3).unwrap();
        println!("{:?}", simulation.report());
        let mut phi = SVector::zeros();
        let state = simulation.state();
        simulation.system().constraints(
            state.time,
            &state.positions,
            &mut phi,
            &mut [[0.0; 4]; 3],
            &mut SVector::zeros(),
        );
        phi.amax()
    };
    let (literal, stiff) = (run(0.0), run(200.0));
    println!("{literal:e} {stiff:e}");
    assert!(10.0 * stiff < literal, "{literal:e} {stiff:e}");
}

/// The direction of (19) changes m̄ and f̄ of the rows; the motion is the same to the error of the step.
#[test]
fn other_directions_of_rows_give_the_same_motion() {
    let [a, b] = [RowDirection::Metric, RowDirection::Euclidean].map(|direction| {
        let paper = PaperSettings {
            direction,
            ..fine(1e-9)
        };
        let mut simulation = start(SliderCrank, 1e-3, paper);
        simulation.run_until(0.2).unwrap();
        *simulation.positions()
    });
    let apart = distance(&a, &b);
    assert!(apart < 1e-6 && apart > 0.0, "{apart:e}");
}

/// Away from singular poses the forces with which the methods act are those of the equations at acceleration level.
#[test]
fn step_multipliers_are_the_constraint_forces() {
    for (method, bound) in [
        (Method::TwoLevel, 1e-2),
        (Method::Paper(fine(1e-9)), 1e-2),
        (Method::MAlf(PaperSettings::m_alf()), 1e-2),
        (Method::by_name("index3-projections").unwrap(), 2e-2),
        (Method::by_name("bdf").unwrap(), 2e-2),
        (Method::Rattle, 1e-2),
    ] {
        let settings = Settings {
            step: 1e-3,
            method,
            ..Settings::default()
        };
        let mut simulation =
            Simulation::with_any_method(Parameters(SliderCrank), settings).unwrap();
        simulation.run_until(0.2).unwrap();
        let expected = simulation.reactions().unwrap().multipliers;
        let own = simulation.step_multipliers().unwrap();
        println!("{}: {own:?} {expected:?}", method.name());
        for (own, expected) in own.iter().zip(&expected) {
            assert!((own - expected).abs() < bound * 30.0, "{own} {expected}");
        }
    }
}

/// The round-off of φ is not in the multipliers of index-3 projections, however short the step.
#[test]
fn short_steps_have_the_multipliers_of_the_reactions() {
    for step in [1e-3, 1e-4, 1e-5] {
        let settings = Settings {
            step,
            method: Method::by_name("index3-projections").unwrap(),
            ..Settings::default()
        };
        let mut simulation =
            Simulation::with_any_method(Parameters(SliderCrank), settings).unwrap();
        for _ in 0..100 {
            simulation.step().unwrap();
            let expected = simulation.reactions().unwrap().multipliers;
            let own = simulation.step_multipliers().unwrap();
            for (own, expected) in own.iter().zip(&expected) {
                assert!((own - expected).abs() < 0.1, "{step:e}: {own} {expected}");
            }
        }
    }
}

/// Steps that look about, at other instants or for an error, are not the last step.
#[test]
fn step_multipliers_are_those_of_the_last_step() {
    for tolerance in [None, Some(1e-5)] {
        let settings = Settings {
            step: 1e-2,
            tolerance,
            ..Settings::default()
        };
        let mut simulation = Simulation::with_settings(Parameters(SliderCrank), settings).unwrap();
        simulation.run_past(0.2, 1.0).unwrap();
        let before = simulation.state().clone();
        let own = simulation.step_multipliers().unwrap();
        let expected = simulation.reactions().unwrap().multipliers;
        for (own, expected) in own.iter().zip(&expected) {
            assert!((own - expected).abs() < 3.0, "{own} {expected}");
        }
        simulation.look_at(before.time - 1e-3, &mut |_| {}).unwrap();
        assert_eq!(simulation.step_multipliers(), Some(own));
    }
}

fn ratio<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    step: f64,
    time: f64,
) -> f64 {
    let [a, b, c] = [1.0, 2.0, 4.0].map(|divisor| {
        let mut simulation = start(scene.clone(), step / divisor, fine(1e-9));
        simulation.run_until(time).unwrap();
        println!("{:?} {:?}", simulation.report(), simulation.energy());
        *simulation.positions()
    });
    distance(&a, &b) / distance(&b, &c)
}

#[test]
fn second_order_away_from_singular_poses() {
    for ratio in [
        ratio(SliderCrank, 4e-3, 0.2),
        ratio(Sleigh::default(), 1e-2, 1.0),
        ratio(DampedSleigh::default(), 1e-2, 1.0),
        ratio(Shaken, 1e-2, 1.0),
    ] {
        println!("ratio {ratio}");
        assert!((3.5..4.5).contains(&ratio), "ratio {ratio}");
    }
}

/// The tolerances of the rows are loose; that of the update of q is not, or the order would be lost where M depends
/// on q.
#[test]
fn second_order_with_loose_tolerances_of_the_rows() {
    for method in [
        Method::Paper(accuracy()),
        Method::MAlf(PaperSettings::m_alf()),
    ] {
        let [a, b, c] = [2e-3, 1e-3, 5e-4].map(|step| {
            let settings = Settings {
                step,
                method,
                ..Settings::default()
            };
            let scene = Parameters(SliderCrankAngles);
            let mut simulation = Simulation::with_any_method(scene, settings).unwrap();
            simulation.run_until(0.2).unwrap();
            *simulation.positions()
        });
        let ratio = distance(&a, &b) / distance(&b, &c);
        println!("{}: ratio {ratio}", method.name());
        assert!((3.0..5.5).contains(&ratio), "{}: {ratio}", method.name());
    }
}

/// Rows quadratic in q: growing multipliers and restarted ones give the same motion.
#[test]
fn carried_fields_change_nothing_for_quadratic_rows() {
    let [a, b] = [true, false].map(|carried_fields| {
        let paper = PaperSettings {
            carried_fields,
            ..fine(1e-10)
        };
        let mut simulation = start(SliderCrank, 1e-3, paper);
        simulation.run_until(0.2).unwrap();
        *simulation.positions()
    });
    let difference = distance(&a, &b);
    println!("difference {difference:e}");
    assert!(difference < 1e-9, "{difference:e}");
}

/// A residual that overflows is none that has settled: the step is halved until its loop converges, or fails.
#[test]
fn a_loop_that_diverges_is_not_accepted() {
    let simulation = Simulation::new(Spring::default()).unwrap();
    let settings = Settings {
        method: Method::Paper(PaperSettings::default()),
        ..Settings::default()
    };
    let (system, state) = (simulation.system().clone(), simulation.state().clone());
    let mut paper = PaperStepper::new(system, state, &settings).unwrap();
    let outcome = paper.step(1e-3);
    let farthest = paper.state().positions.amax();
    // The bob is on a circle of less than 0.11 m about the origin, give or take the error of the step.
    assert!(farthest < 1.0, "{outcome:?}: {farthest:e} m");
}
