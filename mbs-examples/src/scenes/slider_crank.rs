//! The slider-crank with two equal rods (paper, section 7.2): each half turn it passes a pose where both rods coincide
//! and the constraint Jacobian loses a rank.
//!
//! Reference: the smooth branch, on which the rods stay mirror images, as an ordinary differential equation in the crank
//! angle.
//!
//! # The paper's own scheme on this scene
//!
//! `--method alf3f-paper` runs Algorithm 1 to the letter. The impulse of a step acts along A at mid-step while the row is
//! tested with A at its end; where a step straddles the singular pose the two have opposite signs, and no multiplier can
//! satisfy the row to a tight tolerance. What happens then depends on two tolerances, that of ψ̇ and that of the outer
//! loop over q, which the paper leaves open. Measured over 20 s at h = 1e-3 s (`cargo run --release -p mbs-examples
//! --example paper_tolerances`):
//!
//! | ψ̇ | outer loop | ω of k̄, c̄ | reached | energy error | halved steps |
//! |---|---|---|---|---|---|
//! | 1e-2 | 1e-3 | 0 | 5.71 s, step underflow | 5.3e-2 J | 21 |
//! | 1e-3 | 1e-3 | 0 | 20 s | 3.1 J | 40 |
//! | 1e-3 | 1e-4 (default) | 0 | 20 s | 1.4e-3 J | 0 |
//! | 1e-3 | 1e-5 | 0 | 1.28 s, step underflow | 2.6e-4 J | 44 |
//! | 1e-3 | 1e-4 | 20 /s | 20 s | 0.41 J | 0 |
//! | 1e-4 | 1e-4 | 0 | 20 s | 3.4 J | 154 |
//! | 1e-6 | 1e-4 | 0 | 0.953 s, step underflow | 1.6e-2 J | 577 |
//! | 1e-6 | 1e-6 | 0 | 0.392 s, the first singular pose, step underflow | 6e-6 J | 135 |

use crate::scene::{Reference, Scene};
use mbs_runtime::{Mechanism, mechanism};

mechanism!(SliderCrank {
    doc: "Slider-crank with two equal rods and a massless slider; it passes a singular pose each half turn.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    /// Length of each rod.
    length: Param(1.0_m),
    /// Mass of each rod.
    mass: Param(1.0_kg),
    /// Initial angle of the crank.
    start: Param(45.0_deg),
    /// Initial speed of the slider, towards the crank's bearing.
    speed: Param(4.0_m_per_s),

    turning: Let(speed / (2.0 * length * start.sin())),
    crank: Bar(mass = mass, length = length, angle = start, rate = turning),
    rod: Bar(
        mass = mass,
        length = length,
        angle = -start,
        rate = -turning
    ),

    main_bearing: Revolute(ground.origin, crank.a),
    crank_pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),

    p1: Output(crank.b),
    p2: Output(rod.b),
});

/// The scene.
pub const SCENE: Scene = Scene {
    name: "slider-crank",
    title: "Slider-crank through its singular pose",
    source: "Potosakis, Paraskevopoulos, Natsiavas 2020, section 7.2",
    model: SliderCrank::MODEL,
    duration: 10.0,
    step: 1e-3,
    reference: Some(Reference {
        file: "slider_crank_singular_gravity.csv",
        columns: &[("p1.x", "p1x_m"), ("p1.y", "p1y_m"), ("p2.x", "p2x_m")],
    }),
    build: crate::build_scene!(SliderCrank),
};
