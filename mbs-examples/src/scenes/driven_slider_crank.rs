//! A slider-crank whose crank is driven at constant speed: a rheonomic row. Reference: kinematics, and the equations of
//! Newton and Euler, which give every joint force and the driving torque.

use crate::scene::{Reference, Scene};
use mbs_runtime::{Mechanism, mechanism};

mechanism!(DrivenSliderCrank {
    doc: "Slider-crank with a crank driven at constant speed, and a slider with mass.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    /// Length of the crank.
    crank_length: Param(0.15_m),
    /// Mass of the crank.
    crank_mass: Param(0.38_kg),
    /// Length of the rod.
    rod_length: Param(0.30_m),
    /// Mass of the rod.
    rod_mass: Param(0.76_kg),
    /// Mass of the slider.
    slider_mass: Param(0.152_kg),
    /// Angular velocity of the crank.
    speed: Param(150.0_rad_per_s),

    crank: Bar(mass = crank_mass, length = crank_length, rate = speed),
    rod: Bar(
        mass = rod_mass,
        length = rod_length,
        angle = 0.0,
        rate = -speed * crank_length / rod_length,
    ),
    slider: Particle(mass = slider_mass),

    main_bearing: Revolute(ground.origin, crank.a),
    crank_pin: Revolute(crank.b, rod.a),
    gudgeon_pin: Revolute(rod.b, slider.origin),
    guide: PointOnLine(slider.origin, ground.origin, axis = X),
    drive: Drive(crank.angle, value = speed * t),

    slider_x: Output(slider.origin.x),
    slider_vx: Output(slider.velocity.x),
    // The rod does not turn round: its direction is enough, and no turns are counted.
    rod_angle: Output(atan2(rod.x.y, rod.x.x)),
});

/// The scene.
pub const SCENE: Scene = Scene {
    name: "driven-slider-crank",
    title: "Slider-crank with a driven crank",
    source: "geometry and speed of the slider-crank of the IVP test set (Simeon 1998), with rigid uniform rods",
    model: DrivenSliderCrank::MODEL,
    duration: 0.1,
    step: 1e-4,
    reference: Some(Reference {
        file: "driven_slider_crank.csv",
        columns: &[
            ("slider_x", "slider_x_m"),
            ("slider_vx", "slider_vx_m_per_s"),
            ("rod_angle", "phi_rad"),
        ],
    }),
    build: crate::build_scene!(DrivenSliderCrank),
};
