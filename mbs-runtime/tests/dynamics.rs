//! The equations of motion as matrices, at any state, without allocation.

use crate::common::alloc::count;
use mbs_runtime::nalgebra::{SMatrix, SVector};
use mbs_runtime::{Mechanism, Simulation, System, mechanism};

mechanism!(SliderCrank {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    torque: Input(0.3_N_m),
    crank: Bar(
        mass = 1.0_kg,
        length = 0.4_m,
        angle = 40.0_deg,
        rate = 2.0_rad_per_s
    ),
    rod: Bar(mass = 0.5_kg, length = 1.0_m, angle = -15.0_deg),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),
    motor: Torque(crank, value = torque),
    spring: SpringDamper(
        ground.origin,
        rod.b,
        stiffness = 40.0_N_per_m,
        damping = 2.0_N_s_per_m,
        length = 1.0_m
    ),
});

mechanism!(Linkage {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    arm: Body(
        mass = 2.0_kg,
        inertia = Cylinder(0.1_m, 0.5_m, X),
        at = [0.25, 0.0, 0.0],
        angular_velocity = [0.3, 0.5, 1.0]
    ),
    forearm: Body(
        mass = 1.0_kg,
        inertia = Cylinder(0.05_m, 0.4_m, X),
        at = [0.7, 0.0, 0.0]
    ),
    shoulder: Spherical(ground, arm, at = [0.0, 0.0, 0.0]),
    elbow: Revolute(arm, forearm, at = [0.5, 0.0, 0.0], axis = Y),
    rope: Distance(
        ground.point(1.5, 0.4, 0.2),
        forearm.origin,
        length = 0.916515138991168_m
    ),
});

fn size(x: &[f64]) -> f64 {
    x.iter().fold(1.0, |size: f64, x| size.max(x.abs()))
}

/// M v̇ + Γvv = f + Aᵀλ and A v̇ + γ = 0, at the start and at a state beside it.
fn holds<M, S, const Q: usize, const N: usize, const R: usize>(mechanism: M)
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let simulation = Simulation::new(mechanism).unwrap();
    let mut dynamics = simulation.dynamics().unwrap();
    let mut gamma = vec![SMatrix::<f64, N, N>::zeros(); N];
    for shift in [0.0, 0.2] {
        let way = SVector::from_fn(|i, _| shift * (1.0 + i as f64).sin());
        let q = simulation
            .system()
            .advance(simulation.positions(), &way, 1.0);
        let v = simulation.velocities() + 3.0 * way;
        let before = count();
        dynamics.evaluate(0.5, &q, &v).unwrap();
        assert_eq!(count(), before, "evaluating allocates");
        let gamma: &mut [SMatrix<f64, N, N>; N] = gamma.as_mut_slice().try_into().unwrap();
        gamma.iter_mut().for_each(|slice| slice.fill(0.0));
        dynamics.affinities(gamma);
        let inertial = SVector::<f64, N>::from_fn(|i, _| (v.transpose() * gamma[i] * v)[0]);
        let (acceleration, lambda) = (dynamics.accelerations(), dynamics.multipliers());
        let driving = dynamics.applied_forces() + dynamics.constraint_jacobian() * lambda;
        let rest = dynamics.mass_matrix() * acceleration + inertial - driving;
        assert!(rest.amax() < 1e-12 * size(driving.as_slice()), "{rest}");
        let rows =
            dynamics.constraint_jacobian().tr_mul(acceleration) + dynamics.convective_terms();
        assert!(
            rows.amax() < 1e-11 * size(dynamics.convective_terms().as_slice()),
            "{rows}"
        );
    }
}

#[test]
fn in_the_plane() {
    holds(SliderCrank::default());
}

#[test]
fn in_space() {
    holds(Linkage::default());
}

/// Ȧ v is γ where no row depends on time.
#[test]
fn the_rate_of_the_jacobian_is_that_of_its_rows() {
    let simulation: LinkageSimulation = Simulation::new(Linkage::default()).unwrap();
    let dynamics = simulation.dynamics().unwrap();
    let product = dynamics
        .constraint_jacobian_rate()
        .tr_mul(simulation.velocities());
    assert!(product.amax() > 0.1);
    assert!((product - dynamics.convective_terms()).amax() < 1e-13);
    assert_eq!(dynamics.rheonomic_terms().amax(), 0.0);
    assert!(dynamics.residuals().amax() < 1e-12);
}

/// The accelerations are those of the motion.
#[test]
fn a_short_step_follows_the_accelerations() {
    let mut simulation = Simulation::new(SliderCrank::default()).unwrap();
    let (acceleration, v) = (
        *simulation.dynamics().unwrap().accelerations(),
        *simulation.velocities(),
    );
    simulation.run_until(1e-5).unwrap();
    let mean = (simulation.velocities() - v) / 1e-5;
    assert!(
        (mean - acceleration).amax() < 1e-2 * acceleration.amax(),
        "{mean} {acceleration}"
    );
}

mechanism!(Carrier {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    load: Param(1.0_kg),
    arm: Bar(mass = 1.0_kg + load, length = 0.5_m, angle = 0.0_deg),
    shoulder: Revolute(ground.origin, arm.a),
});

#[test]
fn equations_that_are_kept_have_the_parameters_of_now() {
    let mut simulation = Simulation::new(Carrier::default()).unwrap();
    let mut kept = simulation.dynamics().unwrap();
    simulation.set_parameters(Carrier { load: 4.0 }).unwrap();
    simulation.run_until(0.1).unwrap();
    simulation.update(&mut kept).unwrap();
    let expected = simulation.reaction("shoulder", "fy").unwrap();
    let reaction = kept.reaction("shoulder", "fy").unwrap();
    assert!(
        (reaction - expected).abs() < 1e-9,
        "{reaction} for {expected}"
    );
    assert_eq!(
        kept.mass_matrix(),
        simulation.dynamics().unwrap().mass_matrix()
    );
}
