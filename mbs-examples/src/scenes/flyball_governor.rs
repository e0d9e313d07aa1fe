//! A flyball governor whose springs are so stiff (8·10⁵ N/m) that explicit methods need very short steps. IFToMM
//! benchmark A05. A shaft turns freely. Two arms with balls hang from it, and two spring-dampers connect them with a
//! slider on the shaft. Each arm with its ball is one body. The slider on one spring would oscillate at √(K/m) = 516
//! rad/s; its dampers stop it in 38 µs. The implicit flow is stable with steps of 20 ms; with 1 ms the height is within
//! 2.4e-5 m over ten seconds.
//!
//! Reference: three coordinates, integrated with high precision.

use crate::scene::{Reference, Scene};
use mbs_runtime::{Mechanism, mechanism};

mechanism!(FlyballGovernor {
    doc: "Shaft, slider and two arms with balls, coupled by stiff spring-dampers.",
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),

    /// Length of the shaft and of the arms.
    length: Param(1.0_m),
    /// Width of the shaft and of the arms.
    width: Param(0.01_m),
    /// Mass of the shaft and of each arm.
    rod_mass: Param(0.3_kg),
    /// Mass of each ball.
    ball_mass: Param(5.0_kg),
    /// Edge of the slider, a cube.
    edge: Param(0.1_m),
    /// Mass of the slider.
    slider_mass: Param(3.0_kg),
    /// Stiffness of each spring.
    stiffness: Param(8.0e5_N_per_m),
    /// Damping of each spring.
    damping: Param(4.0e4_N_s_per_m),
    /// Free length of each spring.
    free_length: Param(0.5_m),
    /// Angle of the arms below the horizontal at the start.
    angle: Param(30.0_deg),
    /// Rate of turning at the start.
    rate: Param(6.283185307179586_rad_per_s),

    hinge: Let(0.5 * edge),
    arm_mass: Let(rod_mass + ball_mass),
    // centre of mass and inertia of an arm with its ball
    reach: Let((0.5 * rod_mass + ball_mass) / arm_mass * length),
    axial: Let(rod_mass * width.powi(2) / 6.0),
    transverse: Let(rod_mass * (length.powi(2) + width.powi(2)) / 12.0
        + rod_mass * (reach - 0.5 * length).powi(2)
        + ball_mass * (length - reach).powi(2)),

    shaft: Bar(
        mass = rod_mass,
        from = [0.0_m, 0.0, 0.0],
        to = [0.0, 0.0, length],
        inertia = Cuboid(length, width, width),
        angular_velocity = [0.0, 0.0, rate],
    ),
    slider: Body(
        mass = slider_mass,
        inertia = Cuboid(edge, edge, edge),
        at = [0.0, 0.0, 0.5 * length],
        angular_velocity = [0.0, 0.0, rate],
    ),
    right: Body(
        mass = arm_mass,
        inertia = diag(axial, transverse, transverse),
        center_of_mass = [reach, 0.0, 0.0],
        at = [hinge, 0.0, length],
        orientation = turn(Y, angle),
        angular_velocity = [0.0, 0.0, rate],
    ),
    left: Body(
        mass = arm_mass,
        inertia = diag(axial, transverse, transverse),
        center_of_mass = [reach, 0.0, 0.0],
        at = [-hinge, 0.0, length],
        orientation = [turn(Z, pi), turn(Y, angle)],
        angular_velocity = [0.0, 0.0, rate],
    ),

    bearing: Revolute(ground, shaft, at = [0.0_m, 0.0, 0.0], axis = Z),
    guide: Prismatic(shaft, slider, at = [0.0, 0.0, 0.5 * length], axis = Z),
    right_hinge: Revolute(shaft, right, at = [hinge, 0.0, length], axis = Y),
    left_hinge: Revolute(shaft, left, at = [-hinge, 0.0, length], axis = Y),

    right_spring: SpringDamper(
        slider.point(hinge, 0.0, 0.0),
        right.point(0.5 * length, 0.0, 0.0),
        stiffness = stiffness,
        damping = damping,
        length = free_length,
    ),
    left_spring: SpringDamper(
        slider.point(-hinge, 0.0, 0.0),
        left.point(0.5 * length, 0.0, 0.0),
        stiffness = stiffness,
        damping = damping,
        length = free_length,
    ),

    right_ball: Let(right.point(length, 0.0, 0.0)),
    left_ball: Let(left.point(length, 0.0, 0.0)),

    ball: Output(right_ball),
    other_ball: Output(left_ball),
    height: Output(slider.origin.z),
    shaft_angle: Output(bearing.angle),
    shaft_rate: Output(bearing.rate),
});

/// The scene.
pub const SCENE: Scene = Scene {
    name: "flyball-governor",
    title: "Stiff flyball governor",
    source: "IFToMM benchmark A05",
    model: FlyballGovernor::MODEL,
    duration: 10.0,
    step: 1e-3,
    reference: Some(Reference {
        file: "a05_flyball_governor.csv",
        columns: &[
            ("height", "s_m"),
            ("ball.x", "ball1_x_m"),
            ("ball.y", "ball1_y_m"),
            ("ball.z", "ball1_z_m"),
            ("shaft_angle", "shaft_angle_rad"),
            ("shaft_rate", "shaft_omega_rad_per_s"),
        ],
    }),
    build: crate::build_scene!(FlyballGovernor),
};
