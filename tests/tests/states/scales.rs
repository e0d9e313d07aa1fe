//! The scales of states, which follow from the parameters of an instance.

use mbs_runtime::{
    Mechanism, Method, Observables, ParameterError, Settings, Simulation, mechanism, methods,
};

mechanism!(Ring {
    doc: "Two states that go around a circle, the second one from 0.",
    world: Planar(),
    size: Param(1.0),
    period: Param(1.0_s),
    bob: Particle(mass = 1.0_kg, at = [1.0_m, 0.0_m], free = true),
    along: State(initial = size, rate = 6.0 * across / period),
    across: State(scale = 2.0 * size, rate = -6.0 * along / period),
});

/// A power of two: motions of this size are those of size 1 to the last bit.
const SMALL: f64 = 1.0 / 1_048_576.0;
const TOLERANCE: f64 = 1e-6;
const TIME: f64 = 2.0;

fn ring(size: f64) -> Ring {
    Ring {
        size,
        ..Ring::default()
    }
}

fn settings(method: Method) -> Settings {
    Settings {
        method,
        order: if method == Method::TwoLevel { 4 } else { 2 },
        tolerance: Some(TOLERANCE),
        ..Settings::default()
    }
}

/// The distance from the circle of this size after the time, as a part of it.
fn error(ring: &RingSimulation, size: f64) -> f64 {
    let (sine, cosine) = (6.0 * TIME).sin_cos();
    let outputs = ring.outputs();
    (outputs.along / size - cosine).hypot(outputs.across / size + sine)
}

#[test]
fn a_small_instance_takes_the_steps_of_a_large_one() {
    for method in [Method::TwoLevel, Method::Radau] {
        let run = |size| {
            let mut ring =
                Simulation::with_methods(ring(size), settings(method), methods::Accuracy)
                    .expect("a start");
            ring.run_until(TIME).expect("a run");
            println!(
                "{method:?}: {size:e}, {} steps, error {:.1e}",
                ring.report().steps,
                error(&ring, size)
            );
            ring
        };
        let (large, small) = (run(1.0), run(SMALL));
        assert_eq!(large.report().steps, small.report().steps, "{method:?}");
        let error = error(&small, SMALL);
        assert!(error < 3.0 * TOLERANCE, "{method:?}: {error:e}");
    }
}

#[test]
fn other_parameters_have_other_scales() {
    let settings = settings(Method::TwoLevel);
    let mut ring = Simulation::with_settings(ring(1.0), settings).expect("a start");
    ring.set_state_value("along", SMALL).expect("its name");
    let verdict = ring.set_parameters(Ring {
        size: SMALL,
        ..Ring::default()
    });
    verdict.expect("other parameters");
    ring.run_until(TIME).expect("a run");
    let error = error(&ring, SMALL);
    println!("{} steps, error {error:.1e}", ring.report().steps);
    assert!(error < 3.0 * TOLERANCE, "{error:e}");
}

#[test]
fn a_scale_is_that_of_the_instance() {
    let scales = |size| -> Result<Vec<f64>, ParameterError> {
        let system = ring(size).prepare()?;
        Ok(system.states().iter().map(|state| state.scale).collect())
    };
    assert_eq!(scales(1.0), Ok(vec![1.0, 2.0]));
    assert_eq!(scales(0.25), Ok(vec![0.25, 0.5]));
    for size in [0.0, -3.0] {
        let refused = scales(size).expect_err("no scale");
        let text = refused.to_string();
        println!("{text}");
        assert!(
            matches!(
                refused,
                ParameterError::NotPositive {
                    entry: "across",
                    argument: "scale",
                    ..
                }
            ),
            "{text}"
        );
    }
}

mechanism!(Plain {
    world: Planar(),
    first: Param(0.5),
    bob: Particle(mass = 1.0_kg, free = true),
    any: State(initial = first, rate = -any / 1.0_s),
    fixed: State(initial = 3.0, rate = -fixed / 1.0_s),
});

/// Without `scale =` it is the size of the initial value, or 1.
#[test]
fn an_initial_value_is_a_scale() {
    for (first, scale) in [(0.5, 0.5), (-2e-9, 2e-9), (0.0, 1.0)] {
        let system = Plain { first }.prepare().expect("parameters");
        let scales: Vec<f64> = system.states().iter().map(|state| state.scale).collect();
        assert_eq!(scales, [scale, 3.0], "{first}");
    }
}
