//! The mechanisms of the paper's figures (Potosakis, Paraskevopoulos, Natsiavas 2020, section 7) with as many
//! coordinates and rows as in the paper's models: the ground, too, is a body, which six rows fix, and every joint is
//! rows in space.
//!
//! | | paper | here |
//! |---|---|---|
//! | pendulum | 12 + 11 | 12 + 11: ground, pendulum; one revolute joint |
//! | slider-crank | 24 + 26, 3 redundant | 24 + 26, 3 redundant: ground, two rods, slider; three revolute joints, one prismatic |
//! | double four-bar | 36 + 36, 1 redundant | 36 + 36, 1 redundant: ground, five rods; four revolute joints, one cylindrical, two spherical (seven revolute joints would be 35 rows beside those of the ground; the paper does not say which joints it has) |
//! | Bricard | 36 + 36, 1 redundant | 36 + 36, 1 redundant: ground, five rods; six revolute joints |
//! The centre of the ground's body is beside its joint: otherwise its rows would give its coordinates, and both would
//! be eliminated. Parts without mass in the paper (the pendulum's rod, the slider) have a small mass, which bodies in
//! space need.

use mbs_runtime::mechanism;

mechanism!(Pendulum {
    doc: "A point mass on a massless bar, in space: two bodies, 12 velocities and 11 rows.",
    world: Spatial(
        gravity = [0.0, -9.81_m_per_s2, 0.0],
        coordinates = Reference
    ),

    /// Length of the bar.
    length: Param(1.0_m),
    /// The point mass.
    mass: Param(1.0_kg),
    /// Moment of inertia of the bob about its centre, which a point does not have.
    inertia: Param(1e-4_kg_m2),

    base: Body(
        mass = 1.0_kg,
        inertia = diag(0.1_kg_m2, 0.1_kg_m2, 0.1_kg_m2),
        center_of_mass = [0.1_m, 0.0, 0.3],
    ),
    bob: Body(
        mass = mass,
        inertia = diag(inertia, inertia, inertia),
        at = [-length, 0.0_m, 0.0],
    ),
    ground_joint: Fixed(ground, base, at = [0.0_m, 0.0, 0.0]),
    pivot: Revolute(base, bob, at = [0.0_m, 0.0, 0.0], axis = Z),

    x: Output(bob.origin.x),
    y: Output(bob.origin.y),
});

mechanism!(SliderCrank {
    doc: "The slider-crank with two equal rods in space: four bodies, 24 velocities and 26 rows.",
    world: Spatial(
        gravity = [0.0, -9.81_m_per_s2, 0.0],
        coordinates = Reference
    ),

    /// Length of each rod.
    length: Param(1.0_m),
    /// Mass of each rod.
    mass: Param(1.0_kg),
    /// Mass of the slider, negligible in the paper.
    slider_mass: Param(1e-3_kg),

    start: Let(0.25 * pi),
    turning: Let(2.8284271247461903_rad_per_s),
    inertia: Let(mass * length * length / 12.0),
    axial: Let(1e-3 * inertia),
    slider_inertia: Let(1e-2 * slider_mass * length * length),
    knee: Point([length * start.cos(), length * start.sin(), 0.0_m]),
    end: Point([2.0 * length * start.cos(), 0.0_m, 0.0]),

    base: Body(
        mass = 1.0_kg,
        inertia = diag(0.1_kg_m2, 0.1_kg_m2, 0.1_kg_m2),
        center_of_mass = [0.1_m, 0.0, 0.3],
    ),
    crank: Body(
        mass = mass,
        inertia = diag(axial, inertia, inertia),
        center_of_mass = [0.5 * length, 0.0, 0.0],
        orientation = turn(Z, start),
        angular_velocity = [0.0, 0.0, turning],
    ),
    rod: Body(
        mass = mass,
        inertia = diag(axial, inertia, inertia),
        center_of_mass = [0.5 * length, 0.0, 0.0],
        at = [length * start.cos(), length * start.sin(), 0.0_m],
        orientation = turn(Z, -start),
        angular_velocity = [0.0, 0.0, -turning],
    ),
    slider: Body(
        mass = slider_mass,
        inertia = diag(slider_inertia, slider_inertia, slider_inertia),
        at = [2.0 * length * start.cos(), 0.0_m, 0.0],
    ),

    ground_joint: Fixed(ground, base, at = [0.0_m, 0.0, 0.0]),
    bearing: Revolute(base, crank, at = [0.0_m, 0.0, 0.0], axis = Z),
    pin: Revolute(crank, rod, at = knee, axis = Z),
    gudgeon: Revolute(rod, slider, at = end, axis = Z),
    guide: Prismatic(base, slider, at = end, axis = X),

    /// Angle of the crank, from −180° to 180°.
    theta: Output(atan2(rod.origin.y, rod.origin.x) * 180.0 / pi),
    p2: Output(rod.origin),
    p3: Output(slider.origin),
    /// Zero while the rods are mirror images; on the other branch they coincide and the slider stays at the bearing.
    branch: Output(slider.origin.x - 2.0 * rod.origin.x),
});

mechanism!(DoubleFourBar {
    doc: "The double four-bar in space: six bodies, 36 velocities and 36 rows.",
    world: Spatial(
        gravity = [0.0, -9.81_m_per_s2, 0.0],
        coordinates = Reference
    ),

    /// Length of each rod.
    length: Param(1.0_m),
    /// Mass of each rod.
    mass: Param(1.0_kg),
    /// Initial angular velocity of the cranks.
    turning: Param(-1.0_rad_per_s),

    inertia: Let(mass * length * length / 12.0),
    axial: Let(1e-3 * inertia),
    a0: Point([0.0_m, 0.0, 0.0]),
    a1: Point([length, 0.0_m, 0.0]),
    a2: Point([2.0 * length, 0.0_m, 0.0]),
    b0: Point([0.0_m, length, 0.0]),
    b1: Point([length, length, 0.0_m]),
    b2: Point([2.0 * length, length, 0.0_m]),

    base: Body(
        mass = 1.0_kg,
        inertia = diag(0.1_kg_m2, 0.1_kg_m2, 0.1_kg_m2),
        center_of_mass = [0.1_m, 0.0, 0.3],
    ),
    crank0: Body(
        mass = mass,
        inertia = diag(inertia, axial, inertia),
        center_of_mass = [0.0_m, 0.5 * length, 0.0],
        angular_velocity = [0.0, 0.0, turning],
    ),
    crank1: Body(
        mass = mass,
        inertia = diag(inertia, axial, inertia),
        center_of_mass = [0.0_m, 0.5 * length, 0.0],
        at = [length, 0.0_m, 0.0],
        angular_velocity = [0.0, 0.0, turning],
    ),
    crank2: Body(
        mass = mass,
        inertia = diag(inertia, axial, inertia),
        center_of_mass = [0.0_m, 0.5 * length, 0.0],
        at = [2.0 * length, 0.0_m, 0.0],
        angular_velocity = [0.0, 0.0, turning],
    ),
    coupler1: Body(
        mass = mass,
        inertia = diag(axial, inertia, inertia),
        center_of_mass = [0.5 * length, 0.0_m, 0.0],
        at = [0.0_m, length, 0.0],
        velocity = [-turning * length, 0.0, 0.0],
    ),
    coupler2: Body(
        mass = mass,
        inertia = diag(axial, inertia, inertia),
        center_of_mass = [0.5 * length, 0.0_m, 0.0],
        at = [length, length, 0.0_m],
        velocity = [-turning * length, 0.0, 0.0],
    ),

    ground_joint: Fixed(ground, base, at = a0),
    bearing0: Revolute(base, crank0, at = a0, axis = Z),
    pin0: Revolute(crank0, coupler1, at = b0, axis = Z),
    pin1: Spherical(crank1, coupler1, at = b1),
    bearing1: Revolute(base, crank1, at = a1, axis = Z),
    pin1b: Revolute(crank1, coupler2, at = b1, axis = Z),
    pin2: Spherical(crank2, coupler2, at = b2),
    bearing2: Cylindrical(base, crank2, at = a2, axis = Z),

    p1: Output(coupler1.origin),
    p1_velocity: Output(coupler1.origin.velocity),
    /// Zero while the couplers are level.
    branch: Output(coupler1.point(length, 0.0, 0.0).y - coupler1.origin.y),
});

mechanism!(Bricard {
    doc: "Bricard's mechanism: six bodies, 36 velocities and 36 rows.",
    world: Spatial(
        gravity = [0.0, -9.81_m_per_s2, 0.0],
        coordinates = Reference
    ),

    /// Length of each rod.
    side: Param(1.0_m),
    /// Mass of each rod.
    mass: Param(1.0_kg),
    /// Width of the square section.
    width: Param(0.1_m),

    p1: Point([0.0_m, 0.0, 0.0]),
    p2: Point([side, 0.0, 0.0]),
    p3: Point([side, -side, 0.0]),
    p4: Point([side, -side, side]),
    p5: Point([0.0, -side, side]),
    p6: Point([0.0, 0.0, side]),

    base: Body(
        mass = 1.0_kg,
        inertia = diag(0.1_kg_m2, 0.1_kg_m2, 0.1_kg_m2),
        center_of_mass = [0.1_m, 0.0, 0.3],
    ),
    rod1: Bar(
        mass = mass,
        from = p1,
        to = p2,
        inertia = Cuboid(side, width, width)
    ),
    rod2: Bar(
        mass = mass,
        from = p2,
        to = p3,
        inertia = Cuboid(side, width, width)
    ),
    rod3: Bar(
        mass = mass,
        from = p3,
        to = p4,
        inertia = Cuboid(side, width, width)
    ),
    rod4: Bar(
        mass = mass,
        from = p4,
        to = p5,
        inertia = Cuboid(side, width, width)
    ),
    rod5: Bar(
        mass = mass,
        from = p5,
        to = p6,
        inertia = Cuboid(side, width, width)
    ),

    ground_joint: Fixed(ground, base, at = p1),
    j1: Revolute(base, rod1, at = p1, axis = Y),
    j2: Revolute(rod1, rod2, at = p2, axis = Z),
    j3: Revolute(rod2, rod3, at = p3, axis = X),
    j4: Revolute(rod3, rod4, at = p4, axis = Y),
    j5: Revolute(rod4, rod5, at = p5, axis = Z),
    j6: Revolute(rod5, base, at = p6, axis = X),

    corner3: Output(rod2.b),
});
