//! The slider-crank with two equal rods (paper, section 7.2): each half turn it passes a singular pose, where both rods
//! coincide and the rank of the constraint Jacobian is lower by one.
//!
//! Reference: the smooth branch, on which the rods stay mirror images, as an ordinary differential equation in the
//! crank angle. `--method alf3f-paper` runs Algorithm 1 of the paper on it; figures 3 to 5 of the book show Algorithm 1
//! on a model of the same size as in the paper.

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
