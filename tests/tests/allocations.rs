//! A step allocates nothing, in any scene and with any method.

use mbs_examples::scenes::scenes;
use mbs_runtime::{Method, Settings, SimulationError};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

/// An allocator that counts, per thread.
struct Counting;

thread_local! {
    static COUNT: Cell<u64> = const { Cell::new(0) };
}

// SAFETY: forwards to the system allocator; the counter itself does not allocate.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let _ = COUNT.try_with(|count| count.set(count.get() + 1));
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn allocations(work: impl FnOnce()) -> u64 {
    let before = COUNT.with(Cell::get);
    work();
    COUNT.with(Cell::get) - before
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
