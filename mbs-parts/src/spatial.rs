//! Of space.

use mbs_runtime::assembly;

assembly!(Leg {
    doc: "A leg between a base and a platform: two tubes that slide, a universal joint below and a",
    doc: "spherical one above. `slide.stroke` is how much it has become longer; `force` pushes its ends",
    doc: "apart.",
    world: Spatial(),
    /// The part below.
    base: Port(Part),
    /// The part above.
    platform: Port(Part),
    /// The joint with the base in the home pose, in the ground's axes.
    foot: Port(Vector),
    /// The joint with the platform in the home pose, in the ground's axes.
    head: Port(Vector),

    /// Mass of each tube.
    mass: Param(1.0_kg),
    /// Radius of each tube.
    radius: Param(0.03_m),
    /// Force of the drive along the leg.
    force: Input(0.0_N),

    along: Let(unit(head - foot)),
    level: Let(cross(Z, head - foot)),
    // Of a vertical leg it is Y.
    across: Let(unit(
        level + [0.0_m, 1.0_m * step(1e-6_m - norm(level)), 0.0_m]
    )),
    lower: Bar(
        mass = mass,
        from = foot,
        to = foot + 0.5 * (head - foot),
        radius = radius
    ),
    upper: Bar(
        mass = mass,
        from = foot + 0.5 * (head - foot),
        to = head,
        radius = radius
    ),
    hip: Universal(
        base,
        lower,
        at = foot,
        axis = across,
        second_axis = cross(along, across)
    ),
    slide: Prismatic(lower, upper, at = 0.5 * (foot + head), axis = along),
    ball: Spherical(upper, platform, at = head),
    push: Force(upper.b, value = [force, 0.0, 0.0], axes = lower),
    reaction: Force(lower.a, value = [-force, 0.0, 0.0], axes = lower),
});

assembly!(Hexapod {
    doc: "The six legs of a Stewart–Gough platform, in pairs; `foot` and `head` are where they stand in the home pose,",
    doc: "with the base in the plane of X and Y and the platform above it.",
    world: Spatial(),
    /// The part below.
    base: Port(Part),
    /// The part above.
    platform: Port(Part),
    /// Radius of the circle of the feet.
    base_radius: Port(Number, default = 1.0_m),
    /// Radius of the circle of the heads.
    platform_radius: Port(Number, default = 0.5_m),
    /// Height of the heads above the feet.
    height: Port(Number, default = 1.0_m),

    low: Each(0..6, |i| Let(
        i * 60.0_deg + if i % 2 == 0 { 0.1 } else { -0.1 }
    )),
    high: Each(0..6, |i| Let(
        i * 60.0_deg + if i % 2 == 0 { 0.3 } else { -0.3 }
    )),
    foot: Each(0..6, |i| Let([
        base_radius * cos(low[i]),
        base_radius * sin(low[i]),
        0.0_m
    ])),
    head: Each(0..6, |i| Let([
        platform_radius * cos(high[i]),
        platform_radius * sin(high[i]),
        height
    ])),
    leg: Each(0..6, |i| Assembly(
        Leg,
        base = base,
        platform = platform,
        foot = foot[i],
        head = head[i]
    )),
});

assembly!(DoubleWishbone {
    doc: "A double wishbone: two arms that carry an upright, a tie rod, and a spring with its damper.",
    world: Spatial(),
    /// What carries it.
    chassis: Port(Part),
    /// The centre of the wheel in the home pose, in the ground's axes; X is ahead, Z up.
    at: Port(Vector),
    /// 1 for a wheel on the side of Y, −1 for its mirror image.
    side: Port(Number, default = 1.0),
    /// The upper end of the spring, a point of the chassis.
    mount: Port(Point),
    /// The inner end of the tie rod, a point of the chassis or of a rack.
    rack: Port(Point),

    /// Stiffness of the spring.
    stiffness: Param(30e3_N_per_m),
    /// Damping beside it.
    damping: Param(2e3_N_s_per_m),
    /// Length of the spring without force.
    free_length: Param(0.5_m),
    /// Length of the tie rod.
    tie_rod: Param(0.35_m),
    /// Mass of upright and wheel.
    unsprung_mass: Param(25.0_kg),

    lower: Body(
        mass = 4.0_kg,
        inertia = Cuboid(0.2_m, 0.35_m, 0.03_m),
        at = at + [0.0_m, -0.225 * side, -0.15]
    ),
    upper: Body(
        mass = 2.0_kg,
        inertia = Cuboid(0.15_m, 0.25_m, 0.03_m),
        at = at + [0.0_m, -0.175 * side, 0.15]
    ),
    upright: Body(
        mass = unsprung_mass,
        inertia = Cylinder(0.3_m, 0.2_m, Y),
        at = at
    ),
    lower_pivot: Revolute(
        chassis,
        lower,
        at = at + [0.0_m, -0.4 * side, -0.15],
        axis = X
    ),
    upper_pivot: Revolute(
        chassis,
        upper,
        at = at + [0.0_m, -0.3 * side, 0.15],
        axis = X
    ),
    lower_ball: Spherical(lower, upright, at = at + [0.0_m, -0.05 * side, -0.15]),
    upper_ball: Spherical(upper, upright, at = at + [0.0_m, -0.05 * side, 0.15]),
    tie: Distance(
        rack,
        upright.point(-0.12_m, -0.05_m * side, 0.0_m),
        length = tie_rod
    ),
    spring: SpringDamper(
        mount,
        lower.point(0.0_m, 0.075_m * side, 0.0_m),
        stiffness = stiffness,
        damping = damping,
        length = free_length
    ),
    wheel_center: Output(upright.origin),
});

assembly!(McPhersonStrut {
    doc: "A McPherson strut: an arm below, an upright that slides on a strut, a tie rod, and a spring",
    doc: "around the strut.",
    world: Spatial(),
    /// What carries it.
    chassis: Port(Part),
    /// The centre of the wheel in the home pose, in the ground's axes; X is ahead, Z up.
    at: Port(Vector),
    /// 1 for a wheel on the side of Y, −1 for its mirror image.
    side: Port(Number, default = 1.0),
    /// The inner end of the tie rod, a point of the chassis or of a rack.
    rack: Port(Point),

    /// Stiffness of the spring.
    stiffness: Param(25e3_N_per_m),
    /// Damping beside it.
    damping: Param(1.5e3_N_s_per_m),
    /// Length of the spring without force.
    free_length: Param(0.5_m),
    /// Length of the tie rod.
    tie_rod: Param(0.35_m),
    /// Mass of upright and wheel.
    unsprung_mass: Param(25.0_kg),

    arm: Body(
        mass = 4.0_kg,
        inertia = Cuboid(0.2_m, 0.35_m, 0.03_m),
        at = at + [0.0_m, -0.225 * side, -0.15]
    ),
    upright: Body(
        mass = unsprung_mass,
        inertia = Cylinder(0.3_m, 0.2_m, Y),
        at = at
    ),
    rod: Body(
        mass = 1.5_kg,
        inertia = Cylinder(0.02_m, 0.4_m, Z),
        at = at + [0.0_m, -0.1 * side, 0.4]
    ),
    pivot: Revolute(
        chassis,
        arm,
        at = at + [0.0_m, -0.4 * side, -0.15],
        axis = X
    ),
    ball: Spherical(arm, upright, at = at + [0.0_m, -0.05 * side, -0.15]),
    strut: Prismatic(upright, rod, at = at + [0.0_m, -0.1 * side, 0.2], axis = Z),
    top: Spherical(chassis, rod, at = at + [0.0_m, -0.1 * side, 0.6]),
    tie: Distance(
        rack,
        upright.point(-0.12_m, -0.05_m * side, 0.0_m),
        length = tie_rod
    ),
    spring: SpringDamper(
        rod.point(0.0_m, 0.0_m, 0.2_m),
        upright.point(0.0_m, -0.1_m * side, 0.15_m),
        stiffness = stiffness,
        damping = damping,
        length = free_length
    ),
    wheel_center: Output(upright.origin),
});
