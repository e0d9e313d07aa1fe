//! What a start refuses is refused later, too: at a change of parameters, and by the equations of motion.

use mbs_runtime::{Settings, Simulation, SimulationError, mechanism};

mechanism!(FourBar {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    rocker_length: Param(1.0_m),
    crank: Bar(
        mass = 1.0_kg,
        length = 0.5_m,
        from = [0.0, 0.0],
        to = [0.30000004_m, 0.4_m]
    ),
    coupler: Bar(mass = 1.0_kg, length = 1.5_m),
    rocker: Bar(
        mass = 1.0_kg,
        length = rocker_length,
        from = [1.5_m, 0.0],
        angle = 80.0_deg
    ),
    foot: Revolute(ground.origin, crank.a),
    left: Revolute(crank.b, coupler.a),
    right: Revolute(coupler.b, rocker.b),
    other_foot: Revolute(ground.point(1.5_m, 0.0), rocker.a),
});

/// Newton's method stopped at the tolerance of the run, and the pose was refused by that of assembly.
#[test]
fn a_loose_tolerance_assembles_and_follows() {
    for tolerance in [1e-2, 1e-5, 1e-7] {
        let settings = Settings {
            constraint_tolerance: tolerance,
            step: 1e-2,
            ..Settings::default()
        };
        let mut simulation =
            Simulation::with_settings(FourBar::default(), settings).expect("the pose is closed");
        simulation.run_until(0.5).expect("it runs");
        let state = simulation.state().clone();
        let verdict = simulation
            .set_parameters(FourBar {
                rocker_length: 1.001,
            })
            .expect("it follows");
        assert!(verdict.residual < 1e-8, "{}", verdict.residual);
        Simulation::resume(FourBar::default(), settings, state).expect("states can be resumed");
    }
}

mechanism!(Twice {
    world: Planar(),
    speed: Param(1.0_rad_per_s),
    other_speed: Param(1.0_rad_per_s),
    stiffness: Param(1.0_Nm),
    arm: Bar(mass = 1.0_kg, length = 1.0_m),
    pin: Revolute(ground.origin, arm.a),
    first: Drive(pin.rate, value = speed),
    second: Drive(pin.rate, value = other_speed),
    spring: TorsionSpring(pin, stiffness = stiffness),
});

#[test]
fn other_parameters_may_not_contradict_each_other() {
    let mut simulation = Simulation::new(Twice::default()).expect("the drives agree");
    let before = simulation.state().clone();
    let other = Twice {
        other_speed: 2.0,
        ..Twice::default()
    };
    let refused = simulation.set_parameters(other);
    assert!(
        matches!(refused, Err(SimulationError::Contradiction { .. })),
        "{refused:?}"
    );
    assert_eq!(simulation.state().velocities, before.velocities);
    simulation.run_until(0.1).expect("it goes on as before");
}

mechanism!(Parallel {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Natural),
    crank: Each(0..3, |i| Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        angle = 60.0_deg
    )),
    coupler: Each(0..2, |i| Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        angle = 0.0_deg
    )),
    foot: Each(0..3, |i| Revolute(ground.point(i * 1.0_m, 0.0), crank[i].a)),
    left: Each(0..2, |i| Revolute(crank[i].b, coupler[i].a)),
    right: Each(0..2, |i| Revolute(coupler[i].b, crank[i + 1].b)),
    beam: Distance(crank[0].b, crank[2].b, length = 2.0_m),
});

/// The proximal solve, which redundant rows lead to, made zero multipliers of what is not a number.
#[test]
fn equations_of_states_that_are_no_numbers_are_refused() {
    let simulation = Simulation::new(Parallel::default()).expect("it assembles");
    assert!(!simulation.assembly().redundant_rows.is_empty());
    let mut dynamics = simulation.dynamics().expect("it has a mass");
    let (q, mut v) = (*simulation.positions(), *simulation.velocities());
    v[0] = f64::NAN;
    assert!(dynamics.evaluate(0.0, &q, &v).is_err());
}
