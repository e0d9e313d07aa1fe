//! A fast rotor on a slow pendulum.

use mbs_runtime::mechanism;

mechanism!(FastRotor {
    doc: "A rotor of 1000 rad/s on a pendulum.",
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    phase: Param(40.0_deg),
    rate: Param(1.0_rad_per_s),
    damping: Param(0.0),
    arm: Let([cos(phase), 0.0, sin(phase)]),
    pendulum: Body(
        mass = 1.0_kg,
        inertia = diag(0.05, 0.05, 0.05),
        at = 0.5_m * arm,
        velocity = [0.0, 0.5_m * rate, 0.0]
    ),
    rotor: Body(
        mass = 1.0_kg,
        inertia = diag(0.02, 0.01, 0.01),
        at = 1.0_m * arm,
        orientation = turn([0.0, 1.0, 0.0], -phase),
        angular_velocity = 1000.0_rad_per_s * arm,
        velocity = [0.0, rate * 1.0_m, 0.0]
    ),
    pivot: Spherical(ground, pendulum, at = [0.0, 0.0, 0.0]),
    shaft: Revolute(pendulum, rotor, at = 1.0_m * arm, axis = arm),
    brake: TorsionSpring(shaft, damping = 1.0e-3 * damping),
    astray: Output(norm(rotor.origin) - 1.0_m),
});
