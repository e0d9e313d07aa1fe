//! A spherical linkage that folds flat.

/// Four hinges whose axes meet in a point, with opposite arcs of equal length.
macro_rules! spherical {
    ($name:ident, $coordinates:ident) => {
        ::mbs_runtime::mechanism!($name {
            doc: "A spherical linkage of four hinges with equal opposite arcs, which folds flat twice a turn.",
            world: Spatial(gravity = [-4.0_m_per_s2, 3.0, -8.0], coordinates = $coordinates),
            phase: Param(40.0_deg),
            rate: Param(1.0_rad_per_s),
            damping: Param(0.0),
            // Axes of the ground, 60 degrees apart, and of the cranks, 35 degrees from these. A half turn about the
            // middle of the linkage takes each hinge to the opposite one.
            a: Let([0.0, 0.0, 1.0]),
            d: Let([sin(60.0_deg), 0.0, cos(60.0_deg)]),
            b: Let([sin(35.0_deg) * cos(phase), sin(35.0_deg) * sin(phase), cos(35.0_deg)]),
            m: Let(unit(b + d)),
            c: Let(2.0 * dot(m, a) * m - a),
            crank: Body(mass = 1.0_kg, inertia = diag(0.02, 0.03, 0.025), at = 0.5_m * (a + b), angular_velocity = rate * a),
            rocker: Body(mass = 1.0_kg, inertia = diag(0.02, 0.03, 0.025), at = 0.5_m * (c + d)),
            coupler: Body(mass = 1.0_kg, inertia = diag(0.02, 0.03, 0.025), at = 0.5_m * (b + c)),
            bearing: Revolute(ground, crank, at = [0.0, 0.0, 0.0], axis = a),
            pin: Revolute(crank, coupler, at = [0.0, 0.0, 0.0], axis = b),
            other: Revolute(rocker, coupler, at = [0.0, 0.0, 0.0], axis = c),
            end: Revolute(ground, rocker, at = [0.0, 0.0, 0.0], axis = d),
            brake: TorsionSpring(bearing, damping = damping),
            // The half turn takes b to d and c to a, so that both sums lie along its axis. On the other branch they do not.
            on_crank: Let(0.5_m * (b - a)),
            on_rocker: Let(0.5_m * (c - d)),
            pin_axis: Let(crank.point(on_crank.x, on_crank.y, on_crank.z)),
            other_axis: Let(rocker.point(on_rocker.x, on_rocker.y, on_rocker.z)),
            astray: Output(norm(cross(pin_axis + 1.0_m * d, other_axis + 1.0_m * a))),
        });
    };
}
pub(crate) use spherical;
