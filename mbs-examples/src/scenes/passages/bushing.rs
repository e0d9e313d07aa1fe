//! A body on a stiff bushing in space.

use mbs_runtime::mechanism;

mechanism!(OnBushing {
    doc: "A body on a bushing at the end of a pendulum in space: fast vibrations in six directions beside a slow motion.",
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    phase: Param(40.0_deg),
    rate: Param(1.0_rad_per_s),
    stiffness: Param(1.0e4_N_per_m),
    damping: Param(0.0_N_s_per_m),
    arm: Let([cos(phase), 0.0, sin(phase)]),
    turning: Let(rate * [-sin(phase), 0.0, cos(phase)]),
    // Vibrations in turning are about as fast as those in displacement.
    radius2: Let(0.01_m * 1.0_m),
    pendulum: Body(
        mass = 1.0_kg,
        inertia = diag(0.05, 0.05, 0.05),
        at = 0.5_m * arm,
        velocity = cross(turning, 0.5_m * arm),
        angular_velocity = turning
    ),
    bob: Body(
        mass = 1.0_kg,
        inertia = diag(0.02, 0.01, 0.015),
        at = 1.0_m * arm,
        velocity = cross(turning, 1.0_m * arm),
        angular_velocity = turning
    ),
    pivot: Spherical(ground, pendulum, at = [0.0, 0.0, 0.0]),
    mount: Bushing(
        pendulum,
        bob,
        at = 1.0_m * arm,
        stiffness = stiffness,
        damping = damping,
        torsion_stiffness = stiffness * radius2,
        torsion_damping = damping * radius2
    ),
});
