//! Runs that begin in a singular pose, and runs that pass one nearly at rest.

#[path = "../../mbs-examples/src/scenes/passages/cranks.rs"]
#[allow(dead_code)]
mod cranks;
#[path = "../../mbs-examples/src/scenes/passages/shaken.rs"]
mod shaken;

use cranks::DoubleFourBar;
use mbs_runtime::{Settings, Simulation};
use shaken::Shaken;

fn level(rate: f64) -> DoubleFourBar {
    DoubleFourBar {
        phase: 0.0,
        rate,
        damping: 0.0,
    }
}

/// Rows that vanish in the pose of the declaration were measured by their own lengths for the whole run, and those that
/// depend on others there counted as redundant: no later pose was noticed.
#[test]
fn a_start_in_a_singular_pose_counts_and_the_poses_after_it_do() {
    for order in [2, 8] {
        let settings = Settings {
            order,
            step: 0.01,
            ..Settings::default()
        };
        let mut simulation = Simulation::with_settings(level(1.0), settings).expect("it assembles");
        simulation.run_until(3.0).expect("it goes on");
        let losses = simulation.rank_losses();
        assert!(losses.iter().all(|loss| !loss.undetermined));
        let times: Vec<f64> = losses.iter().map(|loss| loss.time).collect();
        let wanted = [0.0, 0.1746, 1.1078, 1.2816, 2.2148, 2.3890];
        assert_eq!(times.len(), wanted.len(), "order {order}: {times:?}");
        for (time, wanted) in times.iter().zip(wanted) {
            assert!((time - wanted).abs() < 2e-3, "order {order}: {times:?}");
        }
        assert!(simulation.outputs().astray < 1e-6);
    }
}

/// From rest, in any of the branches that cross there.
#[test]
fn a_start_from_rest_in_a_singular_pose_goes_on() {
    for order in [2, 4, 6, 8] {
        let settings = Settings {
            order,
            ..Settings::default()
        };
        let mut simulation = Simulation::with_settings(level(0.0), settings).expect("it assembles");
        simulation.run_until(2.0).expect("it goes on");
        assert!(simulation.report().energy_error < 1e-3, "order {order}");
        let losses = simulation.rank_losses();
        assert_eq!(losses[0].time, 0.0, "order {order}");
        // Which branch it is, round-off has decided; at the poses after it the motion decides.
        assert!(losses[0].undetermined, "order {order}");
        assert!(losses[1..].iter().all(|loss| !loss.undetermined));
    }
}

/// A step past a singular pose turned into another branch. The drive gave the energy for this, so that the balance alone was
/// not taken as a sign; but it jumped within the step.
#[test]
fn a_driven_mechanism_passes_a_pose_nearly_at_rest() {
    let settings = Settings {
        step: 0.018_472_135_954_999_58,
        ..Settings::default()
    };
    let mechanism = Shaken {
        phase: -2.399_963_229_728_653,
        rate: 3.570_356_111_440_006_4,
        damping: 0.0,
    };
    let mut simulation = Simulation::with_settings(mechanism, settings).expect("it assembles");
    let mut most = 0.0_f64;
    for piece in 1..=580 {
        let end = f64::from(piece) * 0.216_290_767_559_380_06;
        simulation.run_until(end).expect("it goes on");
        most = most.max(simulation.outputs().astray.abs());
    }
    assert!(most < 1e-6, "{most}");
}
