//! Which constructors accept which methods.

use mbs_runtime::methods::{self, Methods};
use mbs_runtime::{
    BaumgarteSettings, Method, Settings, Simulation, SimulationError, mechanism, simulate_ensemble,
    simulate_ensemble_with_any_method,
};

mechanism!(SliderCrank {
    // With rows that several methods leave open by more than 1e-6.
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Natural),
    length: Param(0.15_m),
    push: Input(unit = N),
    crank: Bar(mass = 1.0_kg, length = length, angle = 60.0_deg),
    rod: Bar(mass = 0.5_kg, length = 0.4_m, angle = -20.0_deg),
    main_bearing: Revolute(ground.origin, crank.a),
    crank_pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),
    pushed: Force(on = rod.b, value = [push, 0.0]),
});

fn settings(name: &str) -> Settings {
    Settings {
        method: Method::by_name(name).expect(name),
        ..Settings::default()
    }
}

fn others() -> impl Iterator<Item = &'static str> {
    let names = Method::NAMES.iter().copied();
    names.filter(|name| *name != "two-level")
}

fn assert_not_compiled<T>(outcome: Result<T, SimulationError>, name: &str) {
    let error = outcome.err().expect(name);
    assert_eq!(
        error,
        SimulationError::NotCompiled {
            method: name_of(name)
        }
    );
    assert_eq!(
        error.to_string(),
        format!(
            "method `{name}` is not compiled into this simulation; construct it with \
             `Simulation::with_methods` and a value of `mbs_runtime::methods`, or resume it with \
             `Simulation::resume_with_methods`"
        )
    );
}

fn name_of(name: &str) -> &'static str {
    Method::by_name(name).expect(name).name()
}

#[test]
fn the_usual_constructors_refuse_other_methods() {
    let state = Simulation::new(SliderCrank::default())
        .unwrap()
        .state()
        .clone();
    for name in others() {
        let settings = settings(name);
        assert_not_compiled(
            Simulation::with_settings(SliderCrank::default(), settings),
            name,
        );
        let resumed = Simulation::resume(SliderCrank::default(), settings, state.clone());
        assert_not_compiled(resumed, name);
        let mut results = simulate_ensemble(&[SliderCrank::default()], settings, |_| Ok(()));
        assert_not_compiled(results.remove(0), name);
    }
}

#[test]
fn settings_are_checked_first() {
    let settings = Settings {
        order: 3,
        ..settings("bdf")
    };
    let error = Simulation::with_settings(SliderCrank::default(), settings).err();
    assert!(
        matches!(error, Some(SimulationError::Setting { name: "order", .. })),
        "{error:?}"
    );
}

/// Every method runs, in pieces and after an input was set, and gives the same from its constructor, in an ensemble and
/// through the object-safe form.
#[test]
fn the_constructors_for_any_method_run_each() {
    for name in Method::NAMES {
        let settings = settings(name);
        let mut simulation = Simulation::with_any_method(SliderCrank::default(), settings).unwrap();
        assert_eq!(simulation.settings().method.name(), *name);
        simulation.set_input("push", 0.1).unwrap();
        simulation.run_until(0.05).unwrap();
        let state = simulation.state().clone();
        simulation.run_until(0.1).unwrap();
        assert!(simulation.report().steps >= 100, "{name}");
        assert!(
            simulation.energy().error.abs() < 0.02,
            "{name}: {:?}",
            simulation.energy()
        );

        let mut results =
            simulate_ensemble_with_any_method(&[SliderCrank::default()], settings, |s| {
                s.set_input("push", 0.1)?;
                s.run_until(0.05)?;
                s.run_until(0.1)?;
                Ok(s.state().clone())
            });
        assert_eq!(&results.remove(0).unwrap(), simulation.state(), "{name}");

        let mut resumed =
            Simulation::resume_with_any_method(SliderCrank::default(), settings, state).unwrap();
        resumed.set_input("push", 0.1).unwrap();
        resumed.run_until(0.1).unwrap();
        let apart = resumed.positions() - simulation.positions();
        assert!(apart.norm() < 1e-6, "{name}: {apart}");
    }
}

/// A program that names a method has this one, with the same digits, and no other.
#[test]
fn named_methods_run_and_no_others() {
    fn run<C: Methods + Copy>(methods: C, named: &[&str]) {
        for name in others() {
            let settings = settings(name);
            let simulation = Simulation::with_methods(SliderCrank::default(), settings, methods);
            if !named.contains(&name) {
                assert_not_compiled(simulation, name);
                continue;
            }
            let mut simulation = simulation.unwrap();
            let start = simulation.state().clone();
            let mut resumed =
                Simulation::resume_with_methods(SliderCrank::default(), settings, start, methods)
                    .unwrap();
            let mut any = Simulation::with_any_method(SliderCrank::default(), settings).unwrap();
            for simulation in [&mut simulation, &mut resumed, &mut any] {
                simulation.run_until(0.02).unwrap();
            }
            assert_eq!(simulation.state(), any.state(), "{name}");
            assert_eq!(simulation.state(), resumed.state(), "{name}");
        }
    }
    run(methods::Projected, &["projected"]);
    run(methods::Baumgarte, &["baumgarte"]);
    run(methods::Rattle, &["rattle"]);
    run(methods::Penalty, &["penalty"]);
    run(methods::Index3Projections, &["index3-projections"]);
    run(methods::GeneralizedAlpha, &["generalized-alpha"]);
    run(methods::Bdf, &["bdf"]);
    run(methods::Radau, &["radau"]);
    run(methods::Paper, &["alf3f-paper", "m-alf"]);
    let adaptive = Settings {
        method: Method::Baumgarte(BaumgarteSettings {
            adaptive: Some(1e-6),
            ..BaumgarteSettings::default()
        }),
        ..Settings::default()
    };
    let named = Simulation::with_methods(SliderCrank::default(), adaptive, methods::Baumgarte);
    named.unwrap().run_until(0.02).unwrap();
}

/// The two-level method is the same with both.
#[test]
fn the_default_method_has_the_same_digits() {
    let settings = Settings {
        order: 4,
        ..Settings::default()
    };
    let mut usual = Simulation::with_settings(SliderCrank::default(), settings).unwrap();
    let mut any = Simulation::with_any_method(SliderCrank::default(), settings).unwrap();
    usual.run_until(0.5).unwrap();
    any.run_until(0.5).unwrap();
    assert_eq!(usual.state(), any.state());
}
