//! A step allocates nothing, in any scene and with any method.

use crate::alloc::count;
use mbs_examples::scenes::scenes;
use mbs_examples::scenes::slider_crank::SliderCrank;
use mbs_runtime::{Method, Settings, Simulation, SimulationError, mechanism};

// A hoist: a drive follows an input, and a force is another one.
mechanism!(Hoist {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    height: Input(0.0_m),
    push: Input(0.0_N),
    cage: Body(mass = 2.0_kg, inertia = 1.0_kg_m2),
    shaft: Prismatic(ground.origin, cage.origin, axis = Y),
    hoist: Drive(shaft.stroke, value = height),
    load: Bar(mass = 1.0_kg, length = 0.5_m),
    hook: Revolute(cage.origin, load.a),
    wind: Force(load.b, value = [push, 0.0]),
});

// Forces alone follow inputs.
mechanism!(Sled {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    push: Input(0.0_N),
    sled: Particle(mass = 1.0_kg),
    track: PointOnLine(sled.origin, ground.origin, axis = X),
    wind: Force(sled.origin, value = [push, 0.0]),
});

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

/// A drive follows `height`, so that a new value of it takes a new pose; no drive follows `push`.
#[test]
fn steps_after_inputs_allocate_nothing() {
    let mut hoist = Simulation::new(Hoist::default()).expect("it assembles");
    let mut set = |name: &str, value: f64| {
        let setting = allocations(|| hoist.set_input(name, value).expect(name));
        let step = allocations(|| hoist.step().expect("a step"));
        assert_eq!(step, 0, "after {name}");
        setting
    };
    for period in 1..=5 {
        let value = f64::from(period) * 1e-3;
        let (push, height) = (set("push", value), set("height", value));
        assert!(push <= 2 && height <= 30, "{push} and {height}");
    }
}

#[test]
fn inputs_of_forces_allocate_nothing() {
    let mut sled = Simulation::new(Sled::default()).expect("it assembles");
    let count = allocations(|| {
        for period in 1..=5 {
            sled.inputs_mut().push = f64::from(period);
            sled.set_input("push", 0.5).expect("push");
            sled.step().expect("a step");
        }
    });
    assert_eq!(count, 0);
}
