//! Accelerations by planned elimination, for every structure, are those with dense arrays.

use crate::alloc::count;
use mbs_examples::scenes::bricard::BricardReference;
use mbs_runtime::{
    BaselineStepper, BaumgarteSettings, Mechanism, Method, Settings, Simulation, State, System,
    mechanism, methods,
};
use mbs_tests::tampered::Tampered;

// By bodies: rotations, dampers in the joints, a row that depends on time, and one of velocities.
mechanism!(Whip {
    world: Spatial(
        gravity = [0.0, 0.0, -9.81_m_per_s2],
        coordinates = Reference
    ),
    link: Each(0..6, |k| Bar(
        mass = 1.0_kg,
        from = [k * 0.3_m, 0.0, 0.0],
        to = [(k + 1) * 0.3_m, 0.0, 0.0],
        radius = 0.05_m
    )),
    top: Revolute(ground, link[0], at = [0.0, 0.0, 0.0], axis = Y),
    joint: Each(1..6, |k| Revolute(
        link[k - 1],
        link[k],
        at = [k * 0.3_m, 0.0, 0.0],
        axis = if k % 2 == 0 { Y } else { Z }
    )),
    brake: Each(1..6, |k| TorsionSpring(
        joint[k],
        stiffness = 0.5_Nm,
        damping = 0.1_Nm_s
    )),
    motor: Drive(top.angle, value = 0.3 * (5.0_per_s * t).sin()),
    edge: Nonholonomic(dot(link[5].velocity_at(link[5].b), link[5].y)),
});

// By joints: the mass matrix of nine linkages on a free frame varies. The frame couples all of them.
mechanism!(Carriage {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Joint),
    frame: Body(mass = 5.0_kg, inertia = 8.0_kg_m2, rate = 0.2_rad_per_s),
    crank: Each(0..9, |k| Bar(
        mass = 0.4_kg,
        length = 0.4_m,
        angle = 60.0_deg + 5.0_deg * k,
        rate = 2.0_rad_per_s
    )),
    coupler: Each(0..9, |k| Bar(mass = 0.5_kg, length = 0.6_m)),
    rocker: Each(0..9, |k| Bar(
        mass = 0.3_kg,
        length = 0.5_m,
        angle = 80.0_deg
    )),
    left: Each(0..9, |k| Revolute(
        frame.point(k * 0.3_m, 0.0_m),
        crank[k].a
    )),
    right: Each(0..9, |k| Revolute(
        frame.point(k * 0.3_m + 0.5_m, 0.0_m),
        rocker[k].a
    )),
    upper: Each(0..9, |k| Revolute(crank[k].b, coupler[k].a)),
    lower: Each(0..9, |k| Revolute(coupler[k].b, rocker[k].b)),
    shock: SpringDamper(
        ground.point(0.0, 1.0),
        frame.origin,
        stiffness = 300.0_N_per_m,
        damping = 4.0_N_s_per_m,
        length = 0.5_m
    ),
});

mechanism!(Presses {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Reference),
    crank: Each(0..4, |k| Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        angle = 45.0_deg,
        rate = 2.8_rad_per_s + 0.1_rad_per_s * k
    )),
    rod: Each(0..4, |k| Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        angle = -45.0_deg,
        rate = -2.8_rad_per_s - 0.1_rad_per_s * k
    )),
    bearing: Each(0..4, |k| Revolute(
        ground.point(k * 3.0_m, 0.0_m),
        crank[k].a
    )),
    pin: Each(0..4, |k| Revolute(crank[k].b, rod[k].a)),
    guide: Each(0..4, |k| PointOnLine(rod[k].b, ground.origin, axis = X)),
    brake: Each(0..4, |k| TorsionSpring(
        ground,
        crank[k],
        damping = 1e-3_Nm_s
    )),
});

/// The states after these steps, with the planned elimination and with dense arrays, and that at the start.
fn both_ways<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: M,
    settings: Settings,
    steps: usize,
) -> [State<Q, N, R>; 3]
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    assert!(S::ELIMINATION.is_some_and(|plan| plan.kicks.is_none()));
    let system = mechanism.prepare().expect("parameters");
    let simulation = Simulation::with_any_method(mechanism, settings).expect("assembled");
    let start = simulation.state().clone();
    let dense = Tampered::new(system.clone(), "nothing");
    let mut planned = BaselineStepper::new(system, start.clone(), &settings).expect("settings");
    let mut dense = BaselineStepper::new(dense, start.clone(), &settings).expect("settings");
    for _ in 0..steps {
        planned.step(settings.step).expect("a step");
        dense.step(settings.step).expect("a step");
    }
    [planned.state().clone(), dense.state().clone(), start]
}

/// The largest difference of the mean accelerations of a short step, by the largest of them.
fn acceleration_difference<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: M,
) -> f64
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let settings = Settings {
        method: Method::Baumgarte(BaumgarteSettings::default()),
        step: 1e-2,
        ..Settings::default()
    };
    let [planned, dense, start] = both_ways(mechanism, settings, 1);
    let apart = (planned.velocities - dense.velocities).amax();
    apart / (dense.velocities - start.velocities).amax()
}

#[test]
fn accelerations_are_those_with_dense_arrays() {
    let differences = [
        acceleration_difference(Whip::default()),
        acceleration_difference(Carriage::default()),
    ];
    println!("{differences:?}");
    assert!(differences.iter().all(|&difference| difference < 1e-12));
}

/// The largest difference of positions and of velocities after forty steps, and how far the first has moved.
fn projected_difference<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: M,
    step: f64,
) -> [f64; 3]
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let settings = Settings {
        method: Method::Projected,
        order: 8,
        step,
        ..Settings::default()
    };
    let [planned, dense, start] = both_ways(mechanism, settings, 40);
    [
        (planned.positions - dense.positions).amax(),
        (planned.velocities - dense.velocities).amax(),
        (planned.positions - start.positions).amax(),
    ]
}

/// Of the thirty rows of Bricard's mechanism by bodies one is redundant, and left out.
#[test]
fn projected_steps_are_those_with_dense_arrays() {
    let differences = [
        projected_difference(Whip::default(), 5e-3),
        projected_difference(Carriage::default(), 5e-3),
        projected_difference(BricardReference::default(), 2e-2),
    ];
    for [positions, velocities, moved] in differences {
        println!("{positions:.1e} m, {velocities:.1e} m/s of {moved:.1} m");
        assert!(moved > 0.01);
        assert!(positions < 1e-11 && velocities < 1e-10);
    }
}

#[test]
fn a_step_allocates_nothing() {
    let settings = Settings {
        method: Method::Projected,
        step: 1e-3,
        ..Settings::default()
    };
    let whip = Simulation::with_methods(Whip::default(), settings, methods::Projected);
    let mut whip = whip.expect("assembled");
    let before = count();
    for _ in 0..20 {
        whip.step().expect("a step");
    }
    assert_eq!(count() - before, 0);
}

/// Four slider-cranks with equal rods, each singular twice in a turn at an instant of its own.
#[test]
fn singular_poses_are_passed() {
    let settings = Settings {
        method: Method::Projected,
        order: 8,
        ..Settings::for_tolerance(1e-8)
    };
    let presses = Simulation::with_methods(Presses::default(), settings, methods::Projected);
    let mut presses = presses.expect("assembled");
    presses.run_until(5.0).expect("the end");
    let report = presses.report();
    println!("{report:?}");
    assert!(report.rank_losses >= 8);
    assert!(report.regularised_solves < report.stages / 100);
    assert!(report.energy_error < 1e-6);
    assert!(report.holonomic_error < 1e-10 && report.velocity_error < 1e-10);
}
