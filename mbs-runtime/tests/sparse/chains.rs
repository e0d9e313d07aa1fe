//! Chains of bodies in space: rotations, velocity forces, holonomic rows.

use super::{apart, have_the_same_limit, run, settings};
use mbs_runtime::{Flow, Simulation, State, mechanism};

mechanism!(Chain {
    world: Spatial(
        gravity = [0.0, 0.0, -9.81_m_per_s2],
        coordinates = Reference
    ),
    damping: Param(0.0_N_m_s),
    link: Each(0..10, |k| Bar(
        mass = 1.0_kg,
        from = [k * 0.1_m, 0.0, 0.0],
        to = [(k + 1) * 0.1_m, 0.0, 0.0],
        radius = 0.01_m
    )),
    top: Revolute(ground, link[0], at = [0.0, 0.0, 0.0], axis = Y),
    joint: Each(1..10, |k| Revolute(
        link[k - 1],
        link[k],
        at = [k * 0.1_m, 0.0, 0.0],
        axis = if k % 2 == 0 { Y } else { Z }
    )),
    damper: Each(1..10, |k| TorsionSpring(
        joint[k],
        stiffness = 0.05_Nm,
        damping = damping
    )),
    push: Force(link[9].b, value = [0.0, 0.2_N, 0.0]),
});

/// The same chain without velocity forces, so that other flows, with dense arrays, can have it.
mod conservative {
    use mbs_runtime::mechanism;

    mechanism!(Free {
        world: Spatial(
            gravity = [0.0, 0.0, -9.81_m_per_s2],
            coordinates = Reference
        ),
        link: Each(0..10, |k| Bar(
            mass = 1.0_kg,
            from = [k * 0.1_m, 0.0, 0.0],
            to = [(k + 1) * 0.1_m, 0.0, 0.0],
            radius = 0.01_m
        )),
        top: Revolute(ground, link[0], at = [0.0, 0.0, 0.0], axis = Y),
        joint: Each(1..10, |k| Revolute(
            link[k - 1],
            link[k],
            at = [k * 0.1_m, 0.0, 0.0],
            axis = if k % 2 == 0 { Y } else { Z }
        )),
        push: Force(link[9].b, value = [0.0, 0.2_N, 0.0]),
    });
}

#[test]
fn sparse_and_dense_factors_have_the_same_limit() {
    have_the_same_limit([8e-3, 4e-3], Flow::Trapezoid, |step, flow| {
        run(conservative::Free {}, settings(step, flow), 0.16)
    });
}

#[test]
fn a_damped_chain_converges_with_the_square_of_the_step() {
    let ends =
        [8e-3, 4e-3, 2e-3].map(|step| run(Chain { damping: 1e-3 }, settings(step, None), 0.16));
    let [coarse, middle, fine] = &ends;
    assert!(fine.rows < 1e-11, "{}", fine.rows);
    assert!(fine.energy_error < 2e-5, "{}", fine.energy_error);
    let ratio = apart(coarse, middle) / apart(middle, fine);
    assert!((3.0..5.5).contains(&ratio), "{ratio}");
}

/// Also in the middle of the steps that share factors.
#[test]
fn a_run_resumes_bit_for_bit() {
    let mut whole: ChainSimulation =
        Simulation::with_settings(Chain { damping: 1e-3 }, settings(1e-3, None)).unwrap();
    let shared = |state: &State<_, _, _>| state.factors.as_ref().unwrap().renewal.steps;
    while shared(whole.state()) < 3 {
        assert!(whole.time() < 0.1, "no factors were kept for three steps");
        whole.step().unwrap();
    }
    let mut resumed = Simulation::resume(
        Chain { damping: 1e-3 },
        settings(1e-3, None),
        whole.state().clone(),
    )
    .unwrap();
    let end = whole.time() + 0.02;
    whole.run_until(end).unwrap();
    resumed.run_until(end).unwrap();
    assert_eq!(whole.state(), resumed.state());
}
