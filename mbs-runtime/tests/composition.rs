//! Orders 4, 6 and 8: slopes for every kind of structure, refusals, and what must not depend on the order.

use crate::common::alloc::count;
use crate::common::planar::{Doubled, FourBar, SliderCrank};
use crate::common::scenes::*;
use crate::common::{Hand, Parameters, Scene, distance};
use mbs_runtime::{
    Flow, Method, PaperSettings, Settings, Simulation, SimulationError, TwoLevelStepper,
};

pub(crate) type Run<T, const Q: usize, const N: usize, const R: usize> =
    Simulation<Hand<T, Q, N, R>, Q, N, R>;

pub(crate) fn settings(order: u8, step: f64) -> Settings {
    Settings {
        order,
        step,
        placement: false,
        ..Settings::default()
    }
}

pub(crate) fn run<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    settings: Settings,
    time: f64,
) -> Run<T, Q, N, R> {
    let mut simulation = Simulation::with_settings(Parameters(scene), settings).unwrap();
    simulation.run_until(time).unwrap();
    simulation
}

/// Checks the slopes of positions between h and h/2, against order 8 with a fine step.
pub(crate) fn slopes<T: Scene<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    scene: T,
    time: f64,
    steps: [(u8, f64); 3],
) {
    let fine = run(scene.clone(), settings(8, steps[2].1 / 4.0), time);
    for (order, h) in steps {
        let error = |h: f64| {
            let end = run(scene.clone(), settings(order, h), time);
            distance(end.positions(), fine.positions())
        };
        let (coarse, half) = (error(h), error(h / 2.0));
        let slope = (coarse / half).log2();
        println!("order {order}, h = {h}: {coarse:.2e} {half:.2e}, slope {slope:.2}");
        let order = f64::from(order);
        assert!(
            (slope - order).abs() < 0.1 * order,
            "order {order}: {slope}"
        );
    }
}

#[test]
fn constant_mass_has_the_slopes() {
    slopes(SliderCrank, 0.2, [(4, 0.02), (6, 0.04), (8, 0.1)]);
}

#[test]
fn mass_that_depends_on_positions_has_the_slopes() {
    slopes(SliderCrankAngles, 0.2, [(4, 0.02), (6, 0.04), (8, 0.1)]);
}

#[test]
fn nonholonomic_rows_have_the_slopes() {
    slopes(Sleigh::default(), 2.0, [(4, 0.1), (6, 0.2), (8, 0.25)]);
}

#[test]
fn mixed_rows_have_the_slopes() {
    slopes(Towing, 1.0, [(4, 0.05), (6, 0.1), (8, 0.2)]);
}

#[test]
fn times_of_stages_reach_rows_and_forces() {
    slopes(Shaken, 1.0, [(4, 0.05), (6, 0.05), (8, 0.1)]);
}

#[test]
fn orders_that_do_not_exist_are_refused() {
    for order in [0, 1, 3, 5, 10] {
        let error = Simulation::with_settings(Parameters(SliderCrank), settings(order, 1e-2)).err();
        assert!(matches!(
            error,
            Some(SimulationError::Setting { name: "order", .. })
        ));
    }
}

#[test]
fn orders_that_would_be_wrong_are_refused() {
    for order in [4, 6, 8] {
        let wanted = |error: Option<SimulationError>| {
            let Some(SimulationError::Order { order: named, .. }) = error else {
                panic!("{error:?}");
            };
            assert_eq!(named, order);
            assert!(error.unwrap().to_string().contains("leave the order at 2"));
        };
        let plain = settings(order, 1e-2);
        let paper = Settings {
            method: Method::Paper(PaperSettings::default()),
            ..plain
        };
        wanted(Simulation::with_settings(Parameters(SliderCrank), paper).err());
        let implicit = Settings {
            flow: Some(Flow::Implicit),
            ..plain
        };
        wanted(Simulation::with_settings(Parameters(SliderCrank), implicit).err());
    }
}

#[test]
fn stages_are_counted() {
    for (order, stages) in [(2, 1), (4, 7), (6, 13), (8, 17)] {
        let report = run(FourBar, settings(order, 1e-2), 0.2).report();
        assert_eq!((report.steps, report.stages), (20, 20 * stages));
    }
}

#[test]
fn a_step_back_undoes_a_step() {
    for order in [4, 6, 8] {
        let settings = settings(order, 2e-2);
        let begun = run(SliderCrank, settings, 0.04);
        let system = Hand::new(SliderCrank);
        let mut stepper = TwoLevelStepper::new(system, begun.state().clone(), &settings).unwrap();
        for h in [2e-2, 2e-2, -2e-2, -2e-2] {
            stepper.step(h).unwrap();
        }
        let (now, then) = (stepper.state(), begun.state());
        assert!(distance(&now.positions, &then.positions) < 1e-12);
        assert!(distance(&now.velocities, &then.velocities) < 1e-12);
    }
}

#[test]
fn a_resumed_run_is_the_same_bit_for_bit() {
    for order in [2, 4, 6, 8] {
        let settings = Settings {
            placement: true,
            ..settings(order, 2e-2)
        };
        let mut whole = run(SliderCrank, settings, 1.0);
        let state = whole.state().clone();
        let mut resumed = Simulation::resume(Parameters(SliderCrank), settings, state).unwrap();
        whole.run_until(5.0).unwrap();
        resumed.run_until(5.0).unwrap();
        assert_eq!(whole.state(), resumed.state());
    }
}

#[test]
fn placed_steps_land_where_they_are_told() {
    for order in [2, 4, 6, 8] {
        let settings = Settings {
            placement: true,
            ..settings(order, 2.5e-2)
        };
        let mut simulation = Simulation::with_settings(Parameters(FourBar), settings).unwrap();
        for instant in 1..=40 {
            let time = 0.25 * f64::from(instant);
            simulation.run_until(time).unwrap();
            assert_eq!(simulation.time(), time);
        }
        let report = simulation.report();
        assert!(order == 2 || report.placed_steps > 0, "{report:?}");
    }
}

#[test]
fn rows_that_are_always_redundant_place_nothing() {
    for order in [2, 8] {
        let settings = Settings {
            placement: true,
            ..settings(order, 1e-2)
        };
        // Before the singular pose.
        let report = run(Doubled, settings, 0.2).report();
        assert!(report.regularised_solves > 0, "{report:?}");
        assert_eq!(report.placed_steps, 0);
    }
}

#[test]
fn composed_and_placed_steps_allocate_nothing() {
    for order in [2, 4, 8] {
        let settings = Settings {
            placement: true,
            ..settings(order, 2.5e-2)
        };
        let mut simulation = Simulation::with_settings(Parameters(FourBar), settings).unwrap();
        let before = count();
        simulation.run_until(10.0).unwrap();
        assert_eq!(count() - before, 0, "order {order}");
    }
}
