//! With a tolerance, what rests in equilibrium stays there in long steps: differences of steps are then round-off.

use mbs_runtime::{BaumgarteSettings, Mechanism, Method, Settings, Simulation, System, mechanism};

mechanism!(Hanging {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Natural),
    bar: Bar(mass = 1.0_kg, length = 1.0_m, angle = -90.0_deg),
    pivot: Revolute(ground.origin, bar.a),
});

mechanism!(Double {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Natural),
    upper: Bar(mass = 1.0_kg, length = 1.0_m, angle = -90.0_deg),
    lower: Bar(mass = 2.0_kg, length = 0.7_m, angle = -90.0_deg),
    pivot: Revolute(ground.origin, upper.a),
    hinge: Revolute(upper.b, lower.a),
});

mechanism!(HangingJoint {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Joint),
    upper: Bar(mass = 1.0_kg, length = 1.0_m, angle = -90.0_deg),
    lower: Bar(mass = 2.0_kg, length = 0.7_m, angle = -90.0_deg),
    pivot: Revolute(ground.origin, upper.a),
    hinge: Revolute(upper.b, lower.a),
});

mechanism!(Beam {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    beam: Bar(
        mass = 3.0_kg,
        length = 2.0_m,
        from = [0.0, 0.0],
        to = [2.0_m, 0.0]
    ),
    pin: Revolute(ground.origin, beam.a),
    roller: PointOnLine(beam.b, ground.origin, axis = X),
});

mechanism!(Weight {
    world: Planar(gravity = [0.0, -10.0_m_per_s2]),
    weight: Particle(mass = 1.0_kg, at = [0.0, -1.1_m]),
    spring: SpringDamper(
        ground.origin,
        weight.origin,
        stiffness = 100.0_N_per_m,
        length = 1.0_m
    ),
});

mechanism!(Truss {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Natural),
    base: Point([1.0_m, 0.0]),
    left: Bar(mass = 1.0_kg, from = [0.0, 0.0], to = [0.5_m, 0.8_m]),
    right: Bar(mass = 1.0_kg, from = [1.0_m, 0.0], to = [0.5_m, 0.8_m]),
    top: Bar(mass = 1.0_kg, from = [0.5_m, 0.8_m], to = [1.5_m, 0.8_m]),
    brace: Bar(mass = 1.0_kg, from = [1.0_m, 0.0], to = [1.5_m, 0.8_m]),
    a: Revolute(ground.origin, left.a),
    b: Revolute(base, right.a),
    c: Revolute(left.b, right.b),
    d: Revolute(left.b, top.a),
    e: Revolute(base, brace.a),
    f: Revolute(top.b, brace.b),
});

mechanism!(Plumb {
    world: Spatial(
        gravity = [0.0, 0.0, -9.81_m_per_s2],
        coordinates = Reference
    ),
    body: Body(
        mass = 1.0_kg,
        inertia = diag(0.1, 0.2, 0.15),
        at = [0.0, 0.0, -1.0_m]
    ),
    pivot: Revolute(ground.origin, body.point(0.0, 0.0, 1.0_m), axis = Y),
});

const UNTIL: f64 = 10.0;

fn rests<M, S, const Q: usize, const N: usize, const R: usize>(mechanism: impl Fn() -> M)
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    for exponent in 2..=10 {
        let tolerance = 10.0_f64.powi(-exponent);
        let settings = Settings::for_tolerance(tolerance);
        let mut simulation = Simulation::with_settings(mechanism(), settings).expect("assembles");
        let start = *simulation.positions();
        simulation
            .run_until(UNTIL)
            .unwrap_or_else(|error| panic!("{} {tolerance:e}: {error}", S::MODEL.name));
        let moved = (simulation.positions() - start).amax();
        let report = simulation.report();
        println!(
            "{} {tolerance:e}: {moved:e} {}",
            S::MODEL.name,
            report.steps
        );
        assert!(moved < 1e-9, "{} {tolerance:e}: {moved:e}", S::MODEL.name);
        assert!(
            report.steps < 2000,
            "{} {tolerance:e}: {report:?}",
            S::MODEL.name
        );
    }
}

#[test]
fn a_hanging_bar() {
    rests(Hanging::default);
}

#[test]
fn a_hanging_double_pendulum() {
    rests(Double::default);
}

#[test]
fn a_hanging_double_pendulum_in_joint_coordinates() {
    rests(HangingJoint::default);
}

#[test]
fn a_beam_on_two_supports() {
    rests(Beam::default);
}

#[test]
fn a_weight_on_its_spring() {
    rests(Weight::default);
}

#[test]
fn a_truss() {
    rests(Truss::default);
}

#[test]
fn a_body_below_its_pivot() {
    rests(Plumb::default);
}

mechanism!(Locked {
    world: Spatial(gravity = [-0.09, 0.0, -9.81_m_per_s2], coordinates = Joint),
    body: Body(
        mass = 1.1_kg,
        inertia = diag(0.27, 0.33, 0.28),
        at = [-0.346_m, 0.887, 0.917],
        center_of_mass = [-0.02, -0.007, 0.08],
        orientation = turn([0.0, -0.564, -0.742], 1.678_rad)
    ),
    pivot: Universal(
        ground,
        body,
        at = [-0.376, 0.891, 0.182],
        axis = [0.0, 1.0, 0.2],
        second_axis = [1.0, 0.0, 0.0]
    ),
    close: Planar(
        ground,
        body,
        at = [0.065, 0.58, 0.273],
        axis = [0.798, -0.486, 0.54]
    ),
    anchor: Point([-0.942_m, 0.366, -0.455]),
    spring: SpringDamper(
        anchor,
        body.origin,
        stiffness = 20.0,
        damping = 0.5,
        length = 0.4
    ),
    push: Force(body.origin, value = [4.8_N, 2.4, -3.0]),
});

/// Velocities are round-off there, which was held to the tolerance: steps of a billionth.
#[test]
fn a_locked_body_in_explicit_steps_with_error_control() {
    for tolerance in [1e-4, 1e-8, 1e-10] {
        let baumgarte = BaumgarteSettings {
            adaptive: Some(tolerance),
            ..BaumgarteSettings::default()
        };
        let settings = Settings {
            method: Method::Baumgarte(baumgarte),
            ..Settings::default()
        };
        let mut simulation = Simulation::with_any_method(Locked::default(), settings).unwrap();
        let start = *simulation.positions();
        simulation.run_until(0.4).unwrap();
        let (moved, report) = ((simulation.positions() - start).amax(), simulation.report());
        println!("{tolerance:e}: {moved:e}, {report:?}");
        assert!(moved < 1e-9, "{tolerance:e}: {moved:e}");
        assert!(report.stages < 20 * 400, "{tolerance:e}: {report:?}");
    }
}
