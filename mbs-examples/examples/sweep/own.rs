//! Mechanisms that are no scenes, each with a difficulty of its own.

use crate::case::{Build, Case};
use mbs_runtime::{Mechanism, mechanism};

#[path = "../../../mbs-runtime/tests/common/bennett.rs"]
mod by_bodies_text;

/// The linkage by bodies.
mod by_bodies {
    super::by_bodies_text::bennett!(Reference);
}

/// The linkage by joints.
mod by_joints {
    super::by_bodies_text::bennett!(Joint);
}

mechanism!(Bob {
    doc: "A particle on a spring of any stiffness.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    stiffness: Param(1e4_N_per_m),
    stretch: Param(1e-2_m),
    bob: Particle(mass = 1.0_kg, at = [1.0_m + stretch, 0.0]),
    spring: SpringDamper(
        ground.origin,
        bob.origin,
        stiffness = stiffness,
        length = 1.0_m
    ),
});

/// All of them.
pub fn cases() -> Vec<Case> {
    let case = |name: &str, model, step, build: Build, parameters: &[(&str, f64)]| Case {
        name: name.to_owned(),
        model,
        parameters: parameters
            .iter()
            .map(|(name, value)| ((*name).to_owned(), *value))
            .collect(),
        step,
        duration: 10.0,
        build,
    };
    let bob: Build = mbs_examples::build_scene!(Bob);
    let mut cases = vec![
        case(
            "bennett-bodies",
            by_bodies::Bennett::MODEL,
            1e-3,
            mbs_examples::build_scene!(by_bodies::Bennett),
            &[],
        ),
        case(
            "bennett-joints",
            by_joints::Bennett::MODEL,
            1e-3,
            mbs_examples::build_scene!(by_joints::Bennett),
            &[],
        ),
    ];
    for (name, stiffness, stretch) in [
        ("bob-1e4", 1e4, 1e-2),
        ("bob-1e8", 1e8, 1e-4),
        ("bob-1e12", 1e12, 0.0),
    ] {
        let parameters = [("stiffness", stiffness), ("stretch", stretch)];
        cases.push(case(name, Bob::MODEL, 1e-3, bob, &parameters));
    }
    cases
}
