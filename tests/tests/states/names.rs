//! Where states are listed, read, set and kept.

use super::{Engine, order};
use mbs_runtime::c_interface;
use mbs_runtime::output::csv;
use mbs_runtime::{
    Energy, FixedStepSimulation, Mechanism, Settings, Simulation, assembly, mechanism,
};

mechanism!(Alone {
    world: Planar(),
    first: State(initial = 1.0, rate = -1.0_per_s * second),
    second: State(rate = 1.0_per_s * first),
});

assembly!(Axle {
    world: Planar(),
    hub: Port(Point),
    drift: Port(Number),
    /// Along which a tyre builds up its force.
    relaxation: Param(0.5_m),
    speed: Param(10.0_m_per_s),
    wheel: Body(mass = 10.0_kg, inertia = 0.5_kg_m2),
    bearing: Revolute(hub, wheel.origin),
    /// Deflection of the tyre.
    slip: State(initial = 0.0_m, rate = drift - speed / relaxation * slip),
    brake: Torque(wheel, value = 10.0_N * slip),
});

mechanism!(Car {
    world: Planar(),
    axle: Each(0..2, |i| Assembly(
        Axle,
        hub = ground.point(i * 2.5_m, 0.0_m),
        drift = (1.0 + i) * 1.0_m_per_s
    )),
    gauge: Each(0..2, |i| State(rate = 2.0 * axle[i].slip / 1.0_m_s)),
});

#[test]
fn states_need_no_parts() {
    let mut alone = Simulation::with_settings(Alone::default(), order(8)).expect("a start");
    alone.run_until(1.0).expect("a run");
    let outputs = alone.outputs();
    assert!((outputs.first - f64::cos(1.0)).abs() < 1e-12, "{outputs:?}");
    assert!(
        (outputs.second - f64::sin(1.0)).abs() < 1e-12,
        "{outputs:?}"
    );
    let free = Alone::MODEL
        .mobility
        .map(|mobility| mobility.degrees_of_freedom);
    assert_eq!((free, alone.energy()), (Some(0), Energy::default()));
}

#[test]
fn states_are_listed_and_no_degrees_of_freedom() {
    let model = Engine::MODEL;
    let states: Vec<_> = model
        .states()
        .map(|q| (q.name, q.unit, q.default))
        .collect();
    assert_eq!(states, [("seen", "rad/s", 2.0), ("charge", "", 0.0)]);
    assert_eq!(
        model.mobility.map(|mobility| mobility.degrees_of_freedom),
        Some(1)
    );
    let text = model.explain().to_string();
    assert!(
        text.contains("States\n  name    initial  unit\n  seen          2  rad/s  What"),
        "{text}"
    );
    assert!(
        !text.contains("integral  ") && !text.contains("Outputs\n  output  unit\n  seen"),
        "{text}"
    );
    let latex = model.latex().expect("formulas");
    assert!(
        latex.contains("\\dot{\\mathrm{seen}} &= -\\frac"),
        "{latex}"
    );
    assert!(
        !latex.contains("M_{4,4}") && !latex.contains("integral"),
        "{latex}"
    );
}

#[test]
fn states_have_columns_of_their_own() {
    let mut engine = Simulation::new(Engine::default()).expect("a start");
    let recording = engine.record(0.02).every(0.01).run().expect("a run");
    let mut writer = csv::CsvWriter::new(Vec::new(), Engine::MODEL).expect("a table");
    for frame in &recording.frames {
        writer.write(frame).expect("a row");
    }
    let table = String::from_utf8(writer.finish().expect("a table")).expect("UTF-8");
    let mut lines = table
        .lines()
        .map(|line| line.split(',').collect::<Vec<_>>());
    let header = lines.next().expect("a header");
    assert_eq!(
        &header[..4],
        ["time_s", "seen_rad_per_s", "charge", "speed_rad_per_s"]
    );
    assert!(
        !header[4..]
            .iter()
            .any(|name| name.contains("seen") || name.contains("charge"))
    );
    let last = lines.next_back().expect("rows");
    assert_eq!(last.len(), header.len());
    assert_eq!(last[2].parse(), Ok(engine.outputs().charge));
    assert_eq!(recording.frames[0].outputs[..2], [2.0, 0.0]);
}

#[test]
fn states_are_set_kept_and_resumed() {
    let start = Simulation::start(Engine::default()).hold("charge", 0.7);
    let mut engine = start.begin().expect("a start");
    assert_eq!(engine.outputs().charge, 0.7);
    let start = Simulation::start(Engine::default()).hold_rate("charge", 0.7);
    let error = start.begin().err().map(|error| error.to_string());
    let found = error.unwrap_or_default();
    assert!(
        found.starts_with("no coordinate, velocity or output of positions alone is named `charge`")
    );
    assert!(
        !found.contains("seen") && !found.contains("integral"),
        "{found}"
    );
    engine.run_until(0.1).expect("a run");
    let text = serde_json::to_string(engine.state()).expect("text");
    let state = serde_json::from_str(&text).expect("a state");
    let resumed = Simulation::resume(Engine::default(), Settings::default(), state);
    let (mut resumed, mut copy) = (resumed.expect("a start"), engine.clone());
    for simulation in [&mut engine, &mut resumed, &mut copy] {
        simulation.run_until(0.2).expect("a run");
    }
    assert_eq!(resumed.state(), engine.state());
    assert_eq!(copy.state(), engine.state());

    let energy = engine.energy();
    engine.set_state_value("charge", 0.0).expect("a state");
    assert_eq!(engine.state_value("charge"), Ok(0.0));
    assert_eq!(engine.energy(), energy);
    let error = engine
        .set_state_value("charge", f64::NAN)
        .expect_err("no number");
    assert_eq!(
        error.to_string(),
        "`charge` cannot be NaN; give it a finite value"
    );
    let error = engine.state_value("chrge").expect_err("no state");
    assert_eq!(
        error.to_string(),
        "no state is named `chrge`; there are: seen, charge"
    );
}

/// What programs in C and without an operating system run.
#[test]
fn steps_of_one_length_have_states() {
    let settings = Settings {
        placement: false,
        ..Settings::default()
    };
    let mut fixed: AloneFixedStepSimulation =
        FixedStepSimulation::new(Alone::default(), settings).expect("a start");
    let mut usual = Simulation::with_settings(Alone::default(), settings).expect("a start");
    for _ in 0..10 {
        fixed.step().expect("a step");
        usual.step().expect("a step");
    }
    assert_eq!(fixed.outputs(), usual.outputs());
    assert_ne!(fixed.outputs().second, 0.0);
    let header = c_interface::header("alone", Alone::MODEL);
    assert!(
        header.contains("double second; /* dimensionless"),
        "{header}"
    );
}

#[test]
fn families_and_assemblies_have_states() {
    let mut car = Simulation::with_settings(Car::default(), order(4)).expect("a start");
    car.run_until(0.05).expect("a run");
    let outputs = car.outputs();
    for i in 0..2 {
        let exact = (1.0 + i as f64) / 20.0 * (1.0 - f64::exp(-1.0));
        let found = car
            .state_value(&format!("axle[{i}].slip"))
            .expect("its name");
        println!("{found} {:e}", found - exact);
        assert!((found - exact).abs() < 1e-8);
        assert_eq!(outputs.axle[i].slip, found);
        // 2 ∫ slip dt
        let exact = 2.0 * (1.0 + i as f64) / 20.0 * (0.05 - 0.05 * (1.0 - f64::exp(-1.0)));
        assert!((outputs.gauge[i] - exact).abs() < 1e-8);
    }
    assert_eq!(
        CarSimulation::new(Car::default())
            .map(|car| car.model().mobility.map(|m| m.degrees_of_freedom))
            .ok(),
        Some(Some(2))
    );
}
