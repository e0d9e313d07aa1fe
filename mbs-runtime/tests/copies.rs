//! Copies of simulations go on alike, and messages show where a simulation is.

use crate::common::planar::SliderCrank;
use crate::common::{Parameters, distance};
use mbs_runtime::{AnySimulation, Method, Settings, Simulation, SimulationError};
use std::error::Error;

#[test]
fn a_copy_goes_on_bit_for_bit_with_every_method() {
    for name in Method::NAMES {
        let settings = Settings {
            method: Method::by_name(name).unwrap(),
            step: 1e-4,
            ..Settings::default()
        };
        let start = Simulation::with_any_method(Parameters(SliderCrank), settings);
        let mut simulation = start.expect(name);
        simulation.run_until(0.003).expect(name);
        let before = *simulation.positions();
        let mut copy = simulation.clone();
        copy.run_until(0.006).expect(name);
        assert_eq!(*simulation.positions(), before, "{name}");
        simulation.run_until(0.006).expect(name);
        assert!(distance(&before, simulation.positions()) > 0.0, "{name}");
        assert_eq!(simulation.state(), copy.state(), "{name}");
        assert_eq!(simulation.report(), copy.report(), "{name}");
    }
}

#[test]
fn messages_show_time_and_state() {
    let mut simulation = Simulation::new(Parameters(SliderCrank)).unwrap();
    simulation.run_until(0.002).unwrap();
    let any: &dyn AnySimulation = &simulation;
    let text = format!("{any:?}");
    assert!(text.starts_with("Simulation { mechanism: "), "{text}");
    assert!(text.contains("time: 0.002, positions: ["), "{text}");
}

#[test]
fn errors_have_their_sources() {
    let simulation = Simulation::new(Parameters(SliderCrank)).unwrap();
    let unknown = simulation.input("torqe").unwrap_err();
    let error = SimulationError::from(unknown.clone());
    let source = error.source().expect("the name");
    assert_eq!(source.downcast_ref(), Some(&unknown));
    let error = SimulationError::Mass { time: 0.0 };
    assert!(error.source().is_none());
}
