//! A cardan shaft: two universal joints between parallel shafts, with their yokes in phase. So the angle of the output
//! equals that of the input, while the angle of the shaft between them oscillates about it. Closed form: with the input
//! at θ the middle shaft is at tan θ₂ = cos β tan θ. As the kinetic energy is constant, so is ω² (J₁ + J₃ + J₂
//! (dθ₂/dθ)²).

use crate::scene::Scene;
use mbs_runtime::{Mechanism, mechanism};

mechanism!(CardanShaft {
    doc: "Two universal joints between parallel shafts, in phase: the second cancels what the first does.",
    world: Spatial(),

    /// Angle between the middle shaft and the others.
    bend: Param(35.0_deg),
    /// Length of the middle shaft.
    length: Param(0.6_m),
    /// Length of the input and output shafts.
    stub: Param(0.3_m),
    /// Mass of each shaft.
    mass: Param(2.0_kg),
    /// Radius of each shaft.
    radius: Param(0.05_m),
    /// Rate of the input at the start.
    rate: Param(10.0_rad_per_s),

    first: Point([stub, 0.0, 0.0]),
    second: Point([stub + length * cos(bend), length * sin(bend), 0.0]),

    input: Bar(
        mass = mass,
        from = [0.0_m, 0.0, 0.0],
        to = first,
        radius = radius,
        angular_velocity = [rate, 0.0, 0.0],
    ),
    middle: Bar(
        mass = mass,
        from = first,
        to = second,
        radius = radius,
        angular_velocity = rate * cos(bend) * [cos(bend), sin(bend), 0.0],
    ),
    output: Bar(
        mass = mass,
        from = second,
        to = [2.0 * stub + length * cos(bend), length * sin(bend), 0.0],
        radius = radius,
        angular_velocity = [rate, 0.0, 0.0],
    ),

    front: Revolute(ground, input, at = [0.0_m, 0.0, 0.0], axis = X),
    cross1: Universal(
        input,
        middle,
        at = first,
        axis = Z,
        second_axis = [-sin(bend), cos(bend), 0.0]
    ),
    cross2: Universal(
        middle,
        output,
        at = second,
        axis = [-sin(bend), cos(bend), 0.0],
        second_axis = Z
    ),
    rear: Revolute(ground, output, at = second, axis = X),

    input_angle: Output(front.angle),
    output_angle: Output(rear.angle),
    input_rate: Output(front.rate),
    middle_rate: Output(dot(middle.angular_velocity, middle.x)),
});

/// The scene.
pub const SCENE: Scene = Scene {
    name: "cardan-shaft",
    title: "Cardan shaft with two universal joints in phase",
    source: "closed form; Seherr-Thoss, Schmelz, Aucktor: Universal Joints and Driveshafts",
    model: CardanShaft::MODEL,
    duration: 2.0,
    step: 1e-3,
    reference: None,
    build: crate::build_scene!(CardanShaft),
};
