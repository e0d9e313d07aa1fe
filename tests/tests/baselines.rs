//! The integrators of the literature agree with the references of scenes that they can integrate.

use mbs_examples::scenes::bricard::Bricard;
use mbs_examples::scenes::scenes;
use mbs_runtime::{
    BaselineStepper, BaumgarteSettings, BdfSettings, GeneralizedAlphaSettings, Method,
    PaperSettings, PenaltySettings, Settings, Simulation, SimulationError,
};
use mbs_tests::reference::{deviation, table};
use mbs_tests::tampered::Tampered;
use mbs_tests::with_room;

/// A scene away from singular poses, with the step and the bounds of the position error of methods of order two, of order
/// four, and of those that control their error.
struct Case {
    scene: &'static str,
    step: f64,
    until: f64,
    second: f64,
    fourth: f64,
    controlled: f64,
}

const CASES: &[Case] = &[
    Case {
        scene: "andrews",
        step: 5e-6,
        until: 0.01,
        second: 2e-5,
        fourth: 1e-10,
        controlled: 2e-6,
    },
    Case {
        scene: "double-four-bar",
        step: 2.5e-3,
        until: 0.5,
        second: 1e-4,
        fourth: 5e-8,
        controlled: 5e-6,
    },
    Case {
        scene: "heavy-top",
        step: 2.5e-5,
        until: 0.1,
        second: 1e-3,
        fourth: 5e-9,
        controlled: 1e-4,
    },
];

fn methods() -> Vec<(Method, fn(&Case) -> f64)> {
    let by_name = |name| Method::by_name(name).expect(name);
    let tight = PaperSettings {
        velocity_tolerance: 1e-7,
        residual_tolerance: 1e-9,
        // The default stiffness is for motions of seconds; one of the cases takes milliseconds.
        penalty: 1e10,
        ..PaperSettings::m_alf()
    };
    vec![
        (by_name("rattle"), |case| case.second),
        (by_name("index3-projections"), |case| case.second),
        (by_name("generalized-alpha"), |case| case.second),
        (
            Method::GeneralizedAlpha(GeneralizedAlphaSettings {
                stabilised: true,
                ..GeneralizedAlphaSettings::default()
            }),
            |case| case.second,
        ),
        (Method::MAlf(tight), |case| case.second),
        (
            Method::Penalty(PenaltySettings {
                penalty: 1e12,
                ..PenaltySettings::default()
            }),
            |case| case.second,
        ),
        (
            Method::Baumgarte(BaumgarteSettings {
                gain: 10.0,
                ..BaumgarteSettings::default()
            }),
            |case| case.fourth,
        ),
        (by_name("projected"), |case| case.fourth),
        (
            Method::Baumgarte(BaumgarteSettings {
                gain: 10.0,
                adaptive: Some(1e-8),
            }),
            |case| case.controlled,
        ),
        (
            Method::Bdf(BdfSettings {
                tolerance: 1e-8,
                ..BdfSettings::default()
            }),
            |case| case.controlled,
        ),
    ]
}

#[test]
fn references_are_met() {
    with_room(|| CASES.iter().for_each(check));
}

fn check(case: &Case) {
    let scene = scenes().iter().find(|scene| scene.name == case.scene);
    let scene = scene.expect(case.scene);
    let trusted = table(scene.reference.expect("a reference").file);
    let mut wrong = Vec::new();
    for (method, bound) in methods() {
        let error = |step: f64| -> Result<f64, SimulationError> {
            let settings = Settings {
                method,
                step,
                ..Settings::default()
            };
            let mut simulation = (scene.build)(&[], settings)?;
            Ok(deviation(simulation.as_mut(), scene, &trusted, case.until))
        };
        match error(case.step) {
            Ok(error) => {
                println!("{} {}: {error:.2e}", case.scene, method.name());
                if !(error <= bound(case)) {
                    wrong.push((method.name(), error));
                }
            }
            Err(SimulationError::Method { .. }) => {}
            Err(error) => panic!("{} {}: {error}", case.scene, method.name()),
        }
    }
    assert!(wrong.is_empty(), "{}: {wrong:?}", case.scene);
}

/// Orders above 2 are not A-stable. Without a cap on its steps, and with one of 3 ms, backward differentiation gains no more
/// than 2 % of the largest kinetic energy in 10 s. Not so with a cap of 10 ms: the slider-crank gains 17 % at tolerances of
/// 1e-2 and 1e-3, which lie far above the errors of such steps.
#[test]
fn backward_differentiation_gains_no_energy() {
    with_room(|| {
        for name in ["pendulum", "slider-crank", "double-four-bar", "bricard"] {
            check_gain(name);
        }
    });
}

fn check_gain(name: &str) {
    let scene = scenes().iter().find(|scene| scene.name == name);
    let scene = scene.expect(name);
    for tolerance in [1e-2, 1e-3, 1e-4] {
        for (step, looks) in [(0.003, 1000), (1000.0, 10)] {
            let settings = Settings {
                method: Method::Bdf(BdfSettings {
                    tolerance,
                    ..BdfSettings::default()
                }),
                step,
                ..Settings::default()
            };
            let mut simulation = (scene.build)(&[], settings).expect("assembles");
            let start = simulation.energy();
            let (mut kinetic, mut gain) = (start.kinetic, 0.0_f64);
            for look in 1..=looks {
                let until = 10.0 * f64::from(look) / f64::from(looks);
                simulation.run_until(until).expect("it runs to the end");
                let energy = simulation.energy();
                kinetic = kinetic.max(energy.kinetic);
                gain = gain.max(energy.error);
            }
            println!("{name} {tolerance:e}, steps to {step} s: {gain:.2e} J of {kinetic:.2e} J");
            assert!(
                gain <= 0.02 * kinetic,
                "{name} with {tolerance:e}, steps to {step} s: {gain} J of {kinetic} J"
            );
        }
    }
}

/// A row that follows from others in every pose is not a lost one: stages call the generated accelerations alone, and an error
/// in what the dense equations need changes nothing.
#[test]
fn redundant_rows_need_no_dense_equations_in_stages() {
    let end = |wrong: &'static str| {
        let simulation = Simulation::new(Bricard::default()).expect("it can be assembled");
        let settings = Settings {
            method: Method::Projected,
            order: 8,
            ..Settings::default()
        };
        let system = Tampered::new(simulation.system().clone(), wrong);
        let state = simulation.state().clone();
        let mut stepper = BaselineStepper::new(system, state, &settings).expect("settings");
        for _ in 0..5 {
            stepper.step(0.1).expect("a step");
        }
        stepper.state().positions
    };
    assert_eq!(end("gamma"), end("nothing"));
    assert_ne!(end("accelerations"), end("nothing"));
}
