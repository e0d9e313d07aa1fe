//! Inputs and outputs as fields, beside those by name.

use crate::common::alloc::count;
use mbs_runtime::nalgebra::SVector;
use mbs_runtime::{AnySimulation, Settings, Simulation, SimulationError, mechanism};

mechanism!(Cart {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    /// Pushes the cart.
    push: Input(0.0_N),
    pull: Input(1.5_N),
    cart: Particle(mass = 2.0_kg, at = [0.0, 0.0]),
    rail: PointOnLine(cart.origin, ground.origin, axis = X),
    along: Force(cart.origin, value = [push - pull, 0.0_N]),
    /// Where the cart is.
    place: Output(cart.origin.x),
    tip: Output(cart.origin + [0.0_m, 0.5_m]),
    speed: Output(cart.velocity.x),
});

fn cart() -> CartSimulation {
    Simulation::new(Cart::default()).unwrap()
}

#[test]
fn fields_are_what_names_are() {
    let mut simulation = cart();
    simulation.run_until(0.5).unwrap();
    let outputs = simulation.outputs();
    assert_eq!(outputs.place, simulation.output("place").unwrap());
    assert_eq!(outputs.speed, simulation.output("speed").unwrap());
    assert_eq!(outputs.tip, SVector::from([outputs.place, 0.5]));
    let values = simulation.output_values();
    assert_eq!(
        values,
        [outputs.place, outputs.tip.x, outputs.tip.y, outputs.speed]
    );
    assert_eq!(
        simulation.inputs(),
        CartInputs {
            push: 0.0,
            pull: 1.5
        }
    );
}

#[test]
fn inputs_act_from_now_on() {
    let mut simulation = cart();
    simulation.inputs_mut().push = 5.5;
    assert_eq!(simulation.input("push").unwrap(), 5.5);
    simulation.run_until(1.0).unwrap();
    assert!((simulation.outputs().place - 1.0).abs() < 1e-12);
    simulation.set_input("pull", 0.5).unwrap();
    assert_eq!(simulation.inputs().pull, 0.5);
    // Nothing is set by looking.
    let _ = simulation.inputs_mut().push;
    assert_eq!(
        simulation.inputs(),
        CartInputs {
            push: 5.5,
            pull: 0.5
        }
    );
}

#[test]
fn the_next_step_tells_of_a_value_that_is_not_finite() {
    let mut simulation = cart();
    {
        let mut inputs = simulation.inputs_mut();
        inputs.push = 2.0;
        inputs.pull = f64::NAN;
    }
    assert_eq!(
        simulation.inputs(),
        CartInputs {
            push: 0.0,
            pull: 1.5
        }
    );
    match simulation.step() {
        Err(SimulationError::Input { name, value }) => {
            assert_eq!(name, "pull");
            assert!(value.is_nan());
        }
        other => panic!("{other:?}"),
    }
    simulation.step().unwrap();
}

#[test]
fn every_name_can_be_asked_of_any_simulation() {
    let mut simulation = cart();
    simulation.run_until(0.5).unwrap();
    let any: &dyn AnySimulation = &simulation;
    assert_eq!(any.output("speed").unwrap(), simulation.outputs().speed);
    let model = any.model();
    for (index, coordinate) in model.coordinates.iter().enumerate() {
        let value = any.coordinate(coordinate.name).unwrap();
        assert_eq!(value, simulation.positions()[index]);
    }
    for (index, velocity) in model.velocities.iter().enumerate() {
        let value = any.velocity(velocity.name).unwrap();
        assert_eq!(value, simulation.velocities()[index]);
    }
    assert_eq!(any.point("cart.origin").unwrap(), simulation.points()[0]);
    let force = any.reaction("rail", "fy").unwrap();
    assert!((force - 2.0 * 9.81).abs() < 1e-9, "{force}");
    let unknown = any.output("sped").unwrap_err();
    assert_eq!(
        unknown.to_string(),
        "no output is named `sped`; there are: place, tip.x, tip.y, speed"
    );
    for unknown in [any.coordinate("q"), any.velocity("q")] {
        assert!(!unknown.unwrap_err().known.is_empty());
    }
    assert!(any.point("cart").is_err());
}

#[test]
fn outputs_and_reactions_by_name_do_not_allocate() {
    let mut simulation = cart();
    let mut dynamics = simulation.dynamics().unwrap();
    simulation.inputs_mut().push = 5.5;
    let before = count();
    let mut sum = 0.0;
    for _ in 0..10 {
        simulation.step().unwrap();
        sum += simulation.output("speed").unwrap();
        simulation.update(&mut dynamics).unwrap();
        sum += dynamics.reaction("rail", "fy").unwrap();
    }
    assert_eq!(count(), before);
    assert!(sum > 190.0);
    // The equations have followed the input and the state.
    let here = simulation.dynamics().unwrap();
    assert_eq!(dynamics.applied_forces(), here.applied_forces());
    let reaction = dynamics.reaction("rail", "fy").unwrap();
    assert_eq!(reaction, simulation.reaction("rail", "fy").unwrap());
    assert!(dynamics.reaction("rail", "fz").is_err());
}

/// The error of such an input came from the next step although the value was right again, or never, after a look.
#[test]
fn an_error_of_inputs_is_told_once_or_repaired() {
    let mut simulation = cart();
    simulation.inputs_mut().push = f64::NAN;
    // That another one is set, or is looked at, does not make it right.
    simulation.inputs_mut().pull = 1.0;
    assert!(simulation.inputs_mut().push.is_nan());
    assert_eq!(simulation.inputs().pull, 1.5);
    simulation.inputs_mut().push = 1.0;
    assert_eq!(simulation.input_values(), [1.0, 1.0]);
    simulation.step().unwrap();
    simulation.inputs_mut().push = f64::NAN;
    simulation.set_input("push", 2.0).unwrap();
    simulation.step().unwrap();
    simulation.run_past(0.1, 1.0).unwrap();
    simulation.inputs_mut().push = f64::NAN;
    let now = simulation.time();
    simulation.look_at(now, &mut |_| {}).unwrap();
    let told = simulation.run_until(1.0);
    assert!(
        matches!(told, Err(SimulationError::Input { name: "push", .. })),
        "{told:?}"
    );
    assert_eq!(simulation.time(), now);
    simulation.run_until(1.0).unwrap();
}

#[test]
fn all_inputs_are_set_at_once_or_none() {
    let mut simulation = cart();
    simulation
        .set_inputs(CartInputs {
            push: 2.0,
            pull: 1.0,
        })
        .unwrap();
    assert_eq!(simulation.input_values(), [2.0, 1.0]);
    assert!(simulation.set_input_values(&[3.0, f64::NAN]).is_err());
    assert!(simulation.set_input_values(&[3.0]).is_err());
    let any: &mut dyn AnySimulation = &mut simulation;
    assert_eq!(any.input_values(), [2.0, 1.0]);
    any.set_input_values(&[4.0, 1.0]).unwrap();
    assert_eq!(simulation.inputs().push, 4.0);
}

/// A state did not have them: a resumed run went on with those that are declared.
#[test]
fn a_state_has_the_inputs() {
    let mut simulation = cart();
    simulation.inputs_mut().push = 5.0;
    simulation.run_until(0.5).unwrap();
    let state = simulation.state().clone();
    assert_eq!(state.inputs, [5.0, 1.5]);
    let mut resumed: CartSimulation =
        Simulation::resume(Cart::default(), Settings::default(), state).unwrap();
    simulation.run_until(1.0).unwrap();
    resumed.run_until(1.0).unwrap();
    assert_eq!(resumed.state(), simulation.state());
    assert_eq!(resumed.inputs().push, 5.0);
}
