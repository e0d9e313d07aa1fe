//! Ensembles: the results of one run after the other, bit for bit and in order, and errors of single members.

use mbs_runtime::{Settings, Simulation, SimulationError, mechanism, simulate_ensemble};

mechanism!(SliderCrank {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    length: Param(1.0_m),
    crank: Bar(
        mass = 1.0_kg,
        length = length,
        angle = 45.0_deg,
        rate = 2.0_rad_per_s
    ),
    rod: Bar(
        mass = 1.0_kg,
        length = length,
        angle = -45.0_deg,
        rate = -2.0_rad_per_s
    ),
    main_bearing: Revolute(ground.origin, crank.a),
    crank_pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),
});

fn members() -> Vec<SliderCrank> {
    let length = |i: u32| 0.5 + 0.01 * f64::from(i);
    (0..60).map(|i| SliderCrank { length: length(i) }).collect()
}

/// Through a singular pose, in steps of the tolerance's choice.
fn settings() -> Settings {
    Settings {
        order: 4,
        tolerance: Some(1e-5),
        ..Settings::default()
    }
}

#[test]
fn results_are_those_of_one_run_after_the_other() {
    let parallel = simulate_ensemble(&members(), settings(), |simulation| {
        simulation.run_until(1.0)?;
        Ok(simulation.state().clone())
    });
    assert_eq!(parallel.len(), 60);
    for (result, member) in parallel.into_iter().zip(members()) {
        let mut alone = Simulation::with_settings(member, settings()).unwrap();
        alone.run_until(1.0).unwrap();
        assert_eq!(&result.unwrap(), alone.state());
    }
}

#[test]
fn members_fail_by_themselves() {
    let mut members = members();
    members[7].length = f64::NAN;
    let results = simulate_ensemble(&members, settings(), |simulation| {
        let until = if simulation.positions()[0] < 0.5 {
            -1.0
        } else {
            0.1
        };
        simulation.run_until(until)?;
        Ok(simulation.time())
    });
    for (index, result) in results.iter().enumerate() {
        match (index, result) {
            (7, Err(SimulationError::Parameter(_))) => {}
            (_, Ok(time)) if *time == 0.1 && index != 7 => {}
            (_, Err(SimulationError::Time { .. })) if members[index].length < 0.72 => {}
            other => panic!("{other:?}"),
        }
    }
    assert!(results[0].is_err() && results[59].is_ok());
}

#[test]
fn no_members_are_no_results() {
    let results = simulate_ensemble(&[] as &[SliderCrank], settings(), |s| s.run_until(1.0));
    assert!(results.is_empty());
}

#[test]
#[should_panic(expected = "on purpose")]
fn a_panic_of_the_caller_is_the_callers() {
    simulate_ensemble(&members(), settings(), |_| -> Result<(), SimulationError> {
        panic!("on purpose")
    });
}
