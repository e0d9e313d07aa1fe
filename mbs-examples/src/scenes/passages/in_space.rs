//! A parallelogram in space, in joint coordinates and by bodies.

use mbs_runtime::mechanism;

/// Two cranks and a coupler in space, on four parallel hinges.
macro_rules! in_space {
    ($name:ident, $coordinates:ident) => {
        mechanism!($name {
            doc: "A parallelogram in space: three rows are redundant, and one more is lost when it is level.",
            world: Spatial(gravity = [0.0, -9.81_m_per_s2, 0.0], coordinates = $coordinates),
            phase: Param(40.0_deg),
            rate: Param(1.0_rad_per_s),
            damping: Param(0.0),
            reach: Let(1.0_m * [cos(phase), sin(phase), 0.0]),
            turning: Let([0.0, 0.0, rate]),
            crank0: Body(
                mass = 1.0_kg,
                inertia = diag(0.01, 0.08, 0.08),
                at = 0.5 * reach,
                orientation = turn([0.0, 0.0, 1.0], phase),
                velocity = 0.5 * cross(turning, reach),
                angular_velocity = turning
            ),
            crank1: Body(
                mass = 1.0_kg,
                inertia = diag(0.01, 0.08, 0.08),
                at = 0.5 * reach + [2.0_m, 0.0, 0.0],
                orientation = turn([0.0, 0.0, 1.0], phase),
                velocity = 0.5 * cross(turning, reach),
                angular_velocity = turning
            ),
            coupler: Body(
                mass = 2.0_kg,
                inertia = diag(0.02, 0.6, 0.6),
                at = reach + [1.0_m, 0.0, 0.0],
                velocity = cross(turning, reach)
            ),
            bearing0: Revolute(ground, crank0, at = [0.0, 0.0, 0.0], axis = Z),
            bearing1: Revolute(ground, crank1, at = [2.0_m, 0.0, 0.0], axis = Z),
            pin0: Revolute(crank0, coupler, at = reach, axis = Z),
            pin1: Revolute(crank1, coupler, at = reach + [2.0_m, 0.0, 0.0], axis = Z),
            brake: TorsionSpring(bearing0, damping = damping),
            astray: Output(crank1.origin.y - crank0.origin.y),
        });
    };
}
in_space!(ParallelogramInSpace, Auto);
in_space!(ParallelogramByBodies, Reference);
