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
//! | 1e-2 | 1e-3 | 0 | 6.88 s, step underflow | 0.41 J | 54 |
//! | 1e-3 | 1e-3 | 0 | 20 s | 2.4 J | 25 |
//! | 1e-3 | 1e-4 (default) | 0 | 3.93 s, step underflow | 5.1e-4 J | 21 |
//! | 1e-3 | 1e-5 | 0 | 0.393 s, the first singular pose, step underflow | 1.1e-5 J | 21 |
//! | 1e-3 | 1e-4 | 20 /s | 3.94 s, step underflow | 3.1e-2 J | 28 |
//! | 1e-4 | 1e-4 | 0 | 20 s | 2.9 J | 23057 |
//! | 1e-6 | 1e-4 | 0 | 20 s | 0.64 J | 732 |
//! | 1e-6 | 1e-6 | 0 | 10.2 s, step underflow | 0.26 J | 3472 |

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
