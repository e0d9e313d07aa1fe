//! Bricard's linkage of threefold symmetry with twists of 60 degrees, whose motion has a bifurcation.
//!
//! Y. Chen, Z. You, T. Tarnai, Threefold-symmetric Bricard linkages for deployable structures, International Journal of
//! Solids and Structures 42 (2005) 2287–2301.

use mbs_runtime::mechanism;

mechanism!(Threefold {
    doc: "Six equal links between hinges whose axes are 60 degrees apart: where all links fold onto one, two motions cross.",
    world: Spatial(gravity = [2.0_m_per_s2, 3.0, -9.0]),
    phase: Param(40.0_deg),
    rate: Param(1.0_rad_per_s),
    damping: Param(0.0),
    // Axes of odd hinges rise by `phase`, those of even ones by `other`; both are zero in the folded pose. Along the motion
    // cos(phase) cos(other)/2 + sin(phase) sin(other) = cos(60°), which has two solutions: near the pose
    // other = (2 ∓ √3) phase. This is the first.
    rise: Let(hypot(0.5 * cos(phase), sin(phase))),
    other: Let(atan2(sin(phase), 0.5 * cos(phase)) - acos(0.5 / rise)),
    // Links are common normals of the axes: heights and radii of the hinges, over the height of the odd ones.
    outer: Let(4.0 / 3.0 * (tan(other) - 0.5 * tan(phase))),
    inner: Let(0.5 * outer - tan(phase)),
    height: Let(1.0_m / sqrt(1.0 + 0.75 * outer * outer + tan(phase) * tan(phase))),
    turn0: Let([1.0, 0.0, 0.0]),
    turn1: Let([cos(60.0_deg), sin(60.0_deg), 0.0]),
    turn2: Let([cos(120.0_deg), sin(120.0_deg), 0.0]),
    up: Let([0.0, 0.0, 1.0]),
    p0: Point(height * (inner * turn0 + up)),
    p1: Point(height * outer * turn1),
    p2: Point(height * (inner * turn2 + up)),
    p3: Point(-height * outer * turn0),
    p4: Point(height * (up - inner * turn1)),
    p5: Point(-height * outer * turn2),
    axis0: Let(cos(phase) * turn0 + sin(phase) * up),
    rod0: Bar(
        mass = 1.0_kg,
        from = p0,
        to = p1,
        inertia = Cuboid(1.0_m, 0.1_m, 0.1_m),
        angular_velocity = rate * axis0
    ),
    rod1: Bar(
        mass = 1.0_kg,
        from = p1,
        to = p2,
        inertia = Cuboid(1.0_m, 0.1_m, 0.1_m)
    ),
    rod2: Bar(
        mass = 1.0_kg,
        from = p2,
        to = p3,
        inertia = Cuboid(1.0_m, 0.1_m, 0.1_m)
    ),
    rod3: Bar(
        mass = 1.0_kg,
        from = p3,
        to = p4,
        inertia = Cuboid(1.0_m, 0.1_m, 0.1_m)
    ),
    rod4: Bar(
        mass = 1.0_kg,
        from = p4,
        to = p5,
        inertia = Cuboid(1.0_m, 0.1_m, 0.1_m)
    ),
    hinge0: Revolute(ground, rod0, at = p0, axis = axis0),
    hinge1: Revolute(
        rod0,
        rod1,
        at = p1,
        axis = cos(other) * turn1 + sin(other) * up
    ),
    hinge2: Revolute(
        rod1,
        rod2,
        at = p2,
        axis = cos(phase) * turn2 + sin(phase) * up
    ),
    hinge3: Revolute(
        rod2,
        rod3,
        at = p3,
        axis = sin(other) * up - cos(other) * turn0
    ),
    hinge4: Revolute(
        rod3,
        rod4,
        at = p4,
        axis = sin(phase) * up - cos(phase) * turn1
    ),
    hinge5: Revolute(
        rod4,
        ground,
        at = p5,
        axis = sin(other) * up - cos(other) * turn2
    ),
    brake: TorsionSpring(hinge0, damping = damping),
});
