//! A step allocates nothing, in any scene and with any method.

use crate::alloc::count;
use mbs_examples::scenes::scenes;
use mbs_examples::scenes::slider_crank::SliderCrank;
use mbs_runtime::{Method, Settings, Simulation, SimulationError};

fn allocations(work: impl FnOnce()) -> u64 {
    let before = count();
    work();
    count() - before
}

#[test]
fn the_allocator_counts() {
    assert_eq!(allocations(|| drop(std::hint::black_box(vec![1.0; 3]))), 1);
}

#[test]
fn a_step_allocates_nothing() {
    mbs_tests::with_room(every_scene);
}

fn every_scene() {
    for name in Method::NAMES {
        let mut counted = 0;
        for scene in scenes() {
            let method = Method::by_name(name).expect(name);
            let settings = Settings {
                method,
                step: scene.step,
                ..Settings::default()
            };
            let mut simulation = match (scene.build)(&[], settings) {
                Err(SimulationError::Method { .. }) => continue,
                simulation => simulation.expect(scene.name),
            };
            // A method may fail on a scene; then nothing is counted.
            if simulation.step().is_err() {
                assert!(
                    *name != "two-level" && *name != "alf3f-paper",
                    "{}",
                    scene.name
                );
                continue;
            }
            let steps = if simulation.coordinates().len() > 20 {
                2
            } else {
                20
            };
            let count = allocations(|| {
                for _ in 0..steps {
                    if simulation.step().is_err() {
                        break;
                    }
                }
            });
            assert_eq!(count, 0, "{} with {}", scene.name, method.name());
            counted += 1;
        }
        assert!(counted > 0, "no run with {name} was counted");
    }
}

#[test]
fn a_step_of_a_copy_allocates_nothing_past_singular_poses() {
    for tolerance in [None, Some(1e-4)] {
        let settings = Settings {
            step: 1e-2,
            tolerance,
            ..Settings::default()
        };
        let start = Simulation::with_settings(SliderCrank::default(), settings);
        let mut copy = start.expect("the slider-crank").clone();
        let count = allocations(|| copy.run_until(3.0).expect("the slider-crank"));
        assert!(copy.report().rank_losses > 1);
        assert_eq!(count, 0, "{tolerance:?}");
    }
}
