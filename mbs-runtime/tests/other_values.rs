//! Other parameters and inputs during a run: the fields that Algorithm 1 carries from step to step are those of the new values.

use mbs_runtime::{Method, Settings, Simulation, mechanism};

mechanism!(SliderCrank {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Natural),
    mass: Param(1.0_kg),
    crank: Bar(
        mass = mass,
        length = 0.15_m,
        angle = 60.0_deg,
        rate = 2.0_rad_per_s
    ),
    rod: Bar(mass = 0.5_kg, length = 0.4_m, angle = -20.0_deg),
    main_bearing: Revolute(ground.origin, crank.a),
    crank_pin: Revolute(crank.b, rod.a),
    liner: PointOnLine(rod.b, ground.origin, axis = X),
    spring: SpringDamper(
        ground.point(1.0_m, 0.0_m),
        rod.b,
        stiffness = 100.0_N_per_m,
        length = 0.3_m
    ),
});

mechanism!(Driven {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    speed: Input(1.0_rad_per_s),
    crank: Bar(
        mass = 1.0_kg,
        length = 0.15_m,
        angle = 60.0_deg,
        rate = 1.0_rad_per_s
    ),
    rod: Bar(mass = 0.5_kg, length = 0.4_m, angle = -20.0_deg),
    main_bearing: Revolute(ground.origin, crank.a),
    crank_pin: Revolute(crank.b, rod.a),
    liner: PointOnLine(rod.b, ground.origin, axis = X),
    motor: Drive(crank.rate, value = speed),
});

fn settings(name: &str) -> Settings {
    Settings {
        method: Method::by_name(name).unwrap(),
        ..Settings::default()
    }
}

/// The momentum of the old mass was taken for that of the new one: velocities changed by 1.9 in the next step.
#[test]
fn velocities_stay_with_other_masses() {
    for name in ["two-level", "alf3f-paper", "m-alf"] {
        let start = SliderCrank::default();
        let mut simulation = Simulation::with_any_method(start, settings(name)).unwrap();
        simulation.run_until(0.1).unwrap();
        simulation
            .set_parameters(SliderCrank { mass: 3.0 })
            .unwrap();
        let before = *simulation.velocities();
        simulation.step().unwrap();
        let change = (simulation.velocities() - before).amax();
        println!("{name}: {change:e}");
        assert!(change < 0.2, "{name}: {change:e}");
    }
}

/// The energy of a jump was booked twice.
#[test]
fn a_drive_that_jumps_has_its_work() {
    for name in ["two-level", "alf3f-paper", "m-alf"] {
        let mut simulation =
            Simulation::with_any_method(Driven::default(), settings(name)).unwrap();
        simulation.run_until(0.1).unwrap();
        simulation.set_input("speed", 3.0).unwrap();
        simulation.step().unwrap();
        let error = simulation.energy().error;
        println!("{name}: {error:e} J");
        assert!(error.abs() < 2e-3, "{name}: {error:e} J");
    }
}
