//! A step allocates nothing, in any scene and with any method.

use crate::alloc::count;
use mbs_examples::scenes::scenes;
use mbs_runtime::{Method, Settings, SimulationError};

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
    for scene in scenes() {
        for name in Method::NAMES {
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
        }
    }
}
