//! `FixedStepSimulation`: the same motion as `Simulation` without placement, bit for bit, and what it refuses.

use crate::common::alloc::count;
use mbs_runtime::{
    FixedStepSimulation, Mechanism, Method, PosesAhead, Settings, Simulation, SimulationError,
    State, mechanism,
};

mechanism!(Plant {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    height: Param(0.0_m),
    push: Input(2.0_N),
    crank: Bar(
        mass = 1.0_kg,
        length = 0.15_m,
        angle = 60.0_deg,
        rate = 8.0_rad_per_s
    ),
    rod: Bar(mass = 0.5_kg, length = 0.4_m, angle = -20.0_deg),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    liner: PointOnLine(rod.b, ground.point(0.0_m, height), axis = X),
    gas: Force(on = rod.b, value = [push, 0.0]),
    stroke: Output(rod.b.x),
});

mechanism!(Held {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    rod: Bar(mass = 1.0_kg, length = 1.0_m, angle = Exactly(30.0_deg)),
    pivot: Revolute(ground.origin, rod.a),
});

const SETTINGS: Settings = Settings {
    method: Method::TwoLevel,
    order: 2,
    step: 1e-3,
    tolerance: None,
    accuracy: None,
    placement: false,
    flow: None,
    constraint_tolerance: 1e-13,
    max_iterations: 25,
    fixed_iterations: None,
};

fn plant() -> PlantFixedStepSimulation {
    FixedStepSimulation::new(Plant::default(), SETTINGS).expect("it assembles")
}

#[test]
fn steps_are_those_of_a_simulation() {
    let mut plant = plant();
    let mut simulation = Simulation::with_settings(Plant::default(), SETTINGS).unwrap();
    for step in 0..200 {
        let push = if step < 100 { 3.0 } else { -1.0 };
        plant.set_inputs(PlantInputs { push }).unwrap();
        simulation.set_input("push", push).unwrap();
        plant.step().unwrap();
        simulation.step().unwrap();
        let mut wanted = State {
            // These steps are not guarded against poses that are nearly singular, …
            poses_ahead: PosesAhead::default(),
            ..simulation.state().clone()
        };
        // … and not by their energy.
        wanted.ledger.range = None;
        assert_eq!(plant.state(), &wanted, "step {step}");
    }
    assert_eq!(plant.outputs(), simulation.outputs());
    assert_eq!(plant.inputs(), simulation.inputs());
    assert_eq!(plant.energy(), simulation.energy());
    assert!(plant.energy().nonconservative_work != 0.0);
}

#[test]
fn it_continues_from_a_state() {
    let mut whole = plant();
    for _ in 0..20 {
        whole.step().unwrap();
    }
    let state = whole.state().clone();
    let mut rest: PlantFixedStepSimulation =
        FixedStepSimulation::resume(Plant::default(), SETTINGS, state.clone()).unwrap();
    for _ in 0..20 {
        whole.step().unwrap();
        rest.step().unwrap();
    }
    assert_eq!(whole.state(), rest.state());

    let mut torn = state.clone();
    torn.positions[0] += 0.01;
    let mut slipped = state;
    slipped.velocities[0] += 0.01;
    for state in [torn, slipped] {
        let resumed = PlantFixedStepSimulation::resume(Plant::default(), SETTINGS, state);
        assert!(matches!(resumed, Err(SimulationError::StateRow { .. })));
    }
}

#[test]
fn a_step_allocates_nothing() {
    let mut plant = plant();
    let before = count();
    for _ in 0..20 {
        plant.set_inputs(PlantInputs { push: 1.0 }).unwrap();
        plant.step().unwrap();
    }
    let (outputs, energy) = (plant.outputs(), plant.energy());
    assert_eq!(count(), before);
    assert!(outputs.stroke.is_finite() && energy.error.is_finite());
}

#[test]
fn what_cannot_be_is_refused() {
    let with = |settings| PlantFixedStepSimulation::new(Plant::default(), settings).err();
    let tolerance = with(Settings::for_tolerance(1e-6));
    assert!(
        matches!(tolerance, Some(SimulationError::Setting { name, .. }) if name == "tolerance")
    );
    let other = with(Settings {
        method: Method::Rattle,
        ..SETTINGS
    });
    assert!(matches!(other, Some(SimulationError::NotCompiled { .. })));

    let far = FixedStepSimulation::new(Plant { height: 1.0 }, SETTINGS);
    let far = far.expect_err("the rail is out of reach").to_string();
    let named = |row: &mbs_runtime::Row| far.contains(&format!("`{}`", row.name));
    assert!(far.contains("cannot be assembled"), "{far}");
    assert!(Plant::MODEL.rows.iter().any(named), "{far}");
    let held = HeldFixedStepSimulation::new(Held {}, SETTINGS);
    let held = held.expect_err("it holds an angle").to_string();
    assert!(held.contains("`rod.angle`"), "{held}");

    let mut plant = plant();
    let refused = plant.set_inputs(PlantInputs { push: f64::NAN });
    assert!(matches!(refused, Err(SimulationError::Input { name, .. }) if name == "push"));
    assert_eq!(plant.inputs(), PlantInputs { push: 2.0 });
}
