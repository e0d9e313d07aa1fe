//! Mechanisms that together use every kind and every function of the language. They need not be useful machines, and
//! the tests need no assembled pose: derivatives are right in every pose. (But the compiler refuses a mechanism that
//! has no assembled pose.)

use crate::laws;
use mbs_runtime::mechanism;

mechanism!(Press {
    doc: "Reference bodies: gears, a slide, a drive, torques, and a point on a moving line.",
    world: Planar(gravity = [0.3_m_per_s2, -9.81_m_per_s2]),

    /// Radius of the driving pin.
    radius: Param(0.15_m),
    /// Mass of each wheel.
    mass: Param(2.0_kg),
    /// Speed of the motor.
    speed: Param(3.0_rad_per_s),
    /// Torque of the brake.
    brake: Input(0.4_N_m),
    /// Load on the ram.
    load: Input(12.0_N),

    pedestal: Point([0.5_m, 0.1_m]),

    wheel: Body(
        mass = mass,
        inertia = 0.5 * mass * radius * radius,
        center_of_mass = [0.02_m, -0.01_m]
    ),
    pinion: Body(mass = 0.3_kg, inertia = 0.002_kg_m2, at = [0.5_m, 0.1_m]),
    ram: Body(
        mass = 1.5_kg,
        inertia = 0.03_kg_m2,
        at = [0.6_m, 0.0_m],
        center_of_mass = [0.1_m, 0.05_m]
    ),
    plate: Body(mass = 0.7_kg, inertia = 0.01_kg_m2, at = [0.7_m, 0.1_m]),

    bearing: Revolute(ground.origin, wheel.point(0.01_m, 0.0_m)),
    shaft: Revolute(pedestal, pinion.origin),
    mesh: Gear(wheel, pinion, ratio = -2.5, offset = 0.3),
    slide: Prismatic(
        ground.origin,
        ram.origin,
        axis = [0.8, 0.6],
        angle = 10.0_deg
    ),
    slot: PointOnLine(wheel.point(radius, 0.0_m), plate.origin, axis = Y),
    weld: Fixed(
        ram.point(0.1_m, 0.0_m),
        plate.point(0.0_m, -0.05_m),
        angle = 0.2
    ),
    motor: Drive(wheel.angle, value = speed * t + 0.1 * (2.0_per_s * t).sin()),

    friction: Torque(pinion, value = -brake * pinion.rate * 1.0_s, from = wheel),
    push: Force(
        ram.point(0.0_m, 0.1_m),
        value = [
            -load,
            3.0_N * (4.0_per_s * t).cos() - 2.0_N_s_per_m * ram.velocity.y
        ]
    ),
    return_spring: SpringDamper(
        ground.point(1.5_m, 0.2_m),
        ram.origin,
        stiffness = 120.0_N_per_m,
        damping = 3.0_N_s_per_m,
        length = 0.4_m
    ),
    leaf: TorsionSpring(
        ground,
        pinion,
        stiffness = 0.8_N_m,
        damping = 0.05_N_m_s,
        angle = 0.1
    ),
    rubber: TorsionSpring(ram, wheel, law = laws::saturating),

    pressed: Event(ram.origin.x - 0.6_m),
    tip: Output(plate.point(0.1_m, 0.2_m)),
    turning: Output(pinion.angle),
});

mechanism!(Truss {
    doc: "Natural bars: merged ends, a drive of a bar's angle, distances, couplings, a slender pendulum with a law.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    /// Length of the bars.
    length: Param(1.2_m),
    /// Mass of the bars.
    mass: Param(0.8_kg),

    crank: Bar(mass = mass, length = length, angle = 40.0_deg),
    rocker: Bar(
        mass = 2.0 * mass,
        from = [2.0_m, 0.0_m],
        to = [2.1_m, 1.1_m]
    ),
    coupler: Bar(mass = mass, length = 1.4_m, angle = 10.0_deg),
    strut: Bar(length = 0.7_m, angle = -60.0_deg),
    weight: Particle(mass = 0.5_kg),
    bead: Particle(mass = 0.2_kg, at = [0.4_m, 0.9_m]),
    ballast: Particle(mass = 0.1_kg, at = [0.3_m, 0.2_m]),

    left: Revolute(ground.origin, crank.a),
    right: Revolute(ground.point(2.0_m, 0.0_m), rocker.a),
    top: Revolute(crank.b, coupler.a),
    other: Revolute(rocker.b, coupler.b),
    hang: Revolute(coupler.b, strut.a),
    end: Revolute(strut.b, weight.origin),
    rope: Distance(crank.b, bead.origin, length = 0.6_m),
    level: Coupling(crank.b.y, bead.origin.x, ratio = 0.7, offset = 0.05_m),
    motor: Drive(crank.angle, value = 0.6 + 1.5_rad_per_s * t),
    lift: Drive(
        bead.origin.y - 0.2 * weight.origin.x + 0.1 * ballast.origin.y,
        value = 0.3_m + 0.1_m_per_s * t
    ),
    ramp: Holonomic(cross(coupler.x, strut.x) - 0.1 * (1.0_per_s * t).sin()),

    cord: SpringDamper(weight.origin, bead.origin, law = laws::stiffening),
    drag: Force(
        weight.origin,
        value = -0.4_N_s2_per_m2 * norm(weight.velocity) * weight.velocity
    ),

    speed: Output(weight.velocity),
    lean: Output(rocker.angle),
    swing: Output(coupler.rate),
});

mechanism!(Sled {
    doc: "Nonholonomic rows: one plain, one with a part that depends on time.",
    world: Planar(gravity = [0.0, -1.0_m_per_s2]),

    /// Mass.
    mass: Param(3.0_kg),

    sled: Body(
        mass = mass,
        inertia = 0.4_kg_m2,
        center_of_mass = [0.2_m, 0.0_m],
        rate = 0.5_rad_per_s
    ),
    caster: Body(mass = 0.5_kg, inertia = 0.05_kg_m2),
    pin: Revolute(sled.point(-0.4_m, 0.1_m), caster.origin),

    edge: Nonholonomic(dot(sled.velocity, sled.y)),
    belt: Nonholonomic(
        dot(caster.velocity_at(caster.point(0.1_m, 0.0_m)), caster.y)
            - 0.3_m_per_s * (2.0_per_s * t).cos() * caster.angle.sin()
    ),
    thrust: Force(sled.origin, value = 2.0_N * sled.x),
    spring: SpringDamper(
        ground.point(3.0_m, 1.0_m),
        sled.origin,
        stiffness = 5.0_N_per_m,
        damping = 0.7_N_s_per_m
    ),
});

mechanism!(Chain {
    doc: "Parts that follow coordinates: M depends on them. A row and forces besides.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    /// Length of the links.
    length: Param(0.6_m),

    slide: Coordinate(0.3_m),
    first: Coordinate(30.0_deg),
    second: Coordinate(0.2, rate = 0.4_rad_per_s),

    cart: Body(
        mass = 1.0_kg,
        inertia = 0.1_kg_m2,
        frame = Frame([slide, 0.0_m], 0.0)
    ),
    upper: Bar(
        mass = 0.8_kg,
        length = length,
        frame = Frame([slide, 0.0_m], first)
    ),
    lower: Body(
        mass = 0.5_kg,
        inertia = 0.02_kg_m2,
        center_of_mass = [0.1_m, 0.03_m],
        frame = Frame(
            [slide + length * first.cos(), length * first.sin()],
            first + second
        )
    ),
    bob: Particle(
        mass = 0.2_kg,
        position = [
            slide + length * first.cos() + 0.5_m * (first + second).cos(),
            length * first.sin() + 0.5_m * (first + second).sin()
        ]
    ),
    loose: Particle(mass = 0.3_kg, at = [0.2_m, -0.8_m]),

    rope: Distance(bob.origin, loose.origin, length = 0.5_m),
    motor: Torque(
        upper,
        value = 0.5_N_m * second.sin() - 0.1_N_m_s * first.rate
    ),
    spring: SpringDamper(
        ground.origin,
        bob.origin,
        stiffness = 30.0_N_per_m,
        damping = 0.4_N_s_per_m,
        length = 0.2_m
    ),
    wind: Force(lower.origin, value = [1.0_N * (3.0_per_s * t).sin(), 0.0_N]),
});

mechanism!(Functions {
    doc: "Every function, in forces and outputs.",
    world: Planar(),

    /// A parameter with which constants are made.
    size: Param(1.3),

    x: Coordinate(0.4),
    y: Coordinate(0.7),
    half: Let(0.45 * (x + 2.0 * y).sin()),
    above: Let(1.5 + x * x + y * y),

    wheel: Body(
        mass = 1.0_kg,
        inertia = 1.2_kg_m2,
        frame = Frame([0.0_m, 0.0_m], x)
    ),
    flywheel: Body(
        mass = 1.0_kg,
        inertia = 0.7_kg_m2,
        frame = Frame([0.0_m, 0.0_m], y)
    ),

    trigonometric: Torque(
        wheel,
        value = 1.0_N_m
            * (x.sin() * y.cos() + (0.3 * x).tan() + half.asin() - half.acos() + (x * y).atan())
    ),
    hyperbolic: Torque(
        flywheel,
        value =
            1.0_N_m * (half.sinh() + (x - y).cosh() + (size * y).tanh() + half.exp() - above.ln())
    ),
    rough: Torque(
        wheel,
        value = 1.0_N_m * ((x - 2.0).abs() + (y + 3.0).sign() * x + (y + 2.0).step() * y)
            + 0.1_N_m_s * min(x.rate, 3.0_rad_per_s) * 1.0
    ),
    powers: Torque(
        flywheel,
        value = 1.0_N_m
            * (above.sqrt() + above.powf(1.7) - above.powi(3) / 10.0
                + above.powf(-0.5)
                + size.powf(0.3))
    ),
    pairs: Torque(
        wheel,
        value = 1.0_N_m * (y.atan2(above) + hypot(x, above) + max(x, y - 9.0) + min(x, y - 9.0))
    ),
    vectors: Torque(
        flywheel,
        value = 1.0_N_m
            * (dot([x, y], [y, 2.0]) + cross([x, above], unit([y, above])) + norm([above, y]))
    ),
    fitted: Torque(
        wheel,
        value = 1.0_N_m * law(laws::blend, x, y * size, x.rate * 1.0_s)
    ),

    out: Output(rate(half * above)),
    crossing: Event(x - y),
});

mechanism!(Workshop {
    doc: "Every joint and force of space, in one machine that nobody would build.",
    world: Spatial(gravity = [0.3_m_per_s2, -0.2, -9.6]),

    span: Param(0.4_m),
    load: Param(1.5_kg),
    stiff: Param(300.0_N_per_m),
    push: Input(2.0_N),
    twist: Coordinate(0.3, rate = 0.2),

    table: Body(
        mass = 4.0 * load,
        inertia = Cuboid(span, 0.3_m, 0.1_m),
        center_of_mass = [0.02, 0.01, 0.03],
        at = [0.1, 0.2, 0.3],
        orientation = [turn(Z, 0.3), turn([1.0, 2.0, 0.5], 0.4)],
        velocity = [0.1_m_per_s, 0.0, 0.2],
        angular_velocity = [0.3_rad_per_s, 0.1, 0.5],
    ),
    spindle: Bar(
        mass = load,
        from = [0.1, 0.2, 0.3],
        to = [0.1, 0.6, 0.7],
        radius = 0.04_m
    ),
    wheel: Body(
        mass = load,
        inertia = Cylinder(0.2_m, 0.05_m, Y),
        at = [0.1, 0.6, 0.7]
    ),
    nut: Body(mass = load, inertia = Sphere(0.1_m), at = [0.5, 0.0, 0.2]),
    carriage: Body(
        mass = load,
        inertia = [
            [0.03_kg_m2, 0.002, 0.001],
            [0.002, 0.04, 0.003],
            [0.001, 0.003, 0.05]
        ],
        at = [0.6, 0.1, 0.2],
    ),
    drum: Body(
        mass = load,
        inertia = diag(0.02, 0.03, 0.025) * load * span.powi(2),
        at = [-0.3, 0.1, 0.0]
    ),
    plate: Body(mass = load, inertia = 0.02_kg_m2, at = [-0.3, 0.4, 0.1]),
    shaft: Bar(
        mass = load,
        from = [-0.3, 0.4, 0.1],
        to = [-0.6, 0.5, 0.3],
        radius = 0.03_m
    ),
    link: Bar(
        mass = 0.5 * load,
        from = [-0.6, 0.5, 0.3],
        to = [-0.8, 0.2, 0.1]
    ),
    rod: Bar(from = [-0.8, 0.2, 0.1], to = [-1.0, 0.0, 0.4]),
    bob: Particle(mass = 0.2 * load, at = [-1.0, 0.0, 0.4]),
    rider: Particle(
        mass = load,
        position = span * [cos(twist), 0.5 * sin(twist), 0.2 * twist]
    ),

    hinge: Revolute(ground, table, at = [0.1, 0.2, 0.3], axis = [1.0, 2.0, 0.5]),
    swivel: Revolute(table.origin, spindle.a, axis = [0.2, 1.0, 0.3]),
    yokes: Universal(
        spindle,
        wheel,
        at = [0.1, 0.6, 0.7],
        axis = X,
        second_axis = Y
    ),
    thread: Screw(ground, nut, at = [0.5, 0.0, 0.2], axis = X, pitch = 0.02_m),
    slide: Prismatic(nut, carriage, at = [0.6, 0.1, 0.2], axis = [0.0, 1.0, 1.0]),
    sleeve: Cylindrical(
        ground.frame([-0.3, 0.1, 0.0], Y),
        drum.frame([0.0, 0.0, 0.0], Y)
    ),
    floor: Planar(drum, plate, at = [-0.3, 0.4, 0.1], axis = [1.0, 0.0, 1.0]),
    homokinetic: ConstantVelocity(plate, shaft, at = [-0.3, 0.4, 0.1], axis = [-0.3, 0.1, 0.2]),
    ball: Spherical(shaft.b, link.a),
    eye: Spherical(link.b, rod.a),
    knot: Spherical(rod.b, bob),
    weld: Fixed(carriage, tool, at = [0.7, 0.1, 0.2]),
    tool: Body(mass = load, inertia = 0.01_kg_m2, at = [0.7, 0.1, 0.2]),
    gear: Gear(hinge, sleeve, ratio = -1.5),
    rack: RackPinion(swivel, slide, radius = 0.05_m, offset = 0.01_m),
    wire: PointOnLine(
        wheel.origin,
        table.point(0.1, 0.2, 0.0),
        axis = [0.3, 1.0, 0.2]
    ),
    ledge: PointOnPlane(bob, table.origin, normal = [0.1, 0.2, 1.0]),
    strut: Distance(wheel.point(0.1, 0.0, 0.1), shaft.b, length = 0.9_m),
    skid: Nonholonomic(dot(tool.velocity_at(tool.point(0.1, 0.0, 0.0)), tool.y)),
    height: Holonomic(norm(cross(plate.x, link.x)) - 0.8),

    coil: SpringDamper(
        wheel.origin,
        plate.point(0.1, 0.1, 0.0),
        stiffness = stiff,
        damping = 3.0_N_s_per_m,
        length = 0.2_m
    ),
    torsion: TorsionSpring(swivel, stiffness = 2.0_Nm, damping = 0.1_Nm_s, angle = 0.2),
    mount: Bushing(
        ground,
        drum,
        at = [-0.3, 0.1, 0.0],
        stiffness = [100.0_N_per_m, 200.0, 300.0],
        damping = 4.0_N_s_per_m,
        torsion_stiffness = [[3.0_Nm, 0.2, 0.1], [0.2, 2.0, 0.3], [0.1, 0.3, 1.0]],
        torsion_damping = [0.1_Nm_s, 0.2, 0.3],
        cross_stiffness = 0.5_N,
    ),
    wind: Force(
        bob,
        value = [push, 0.3 * push, -push * sin(2.0_rad_per_s * t)]
    ),
    thrust: Force(wheel.origin, value = [push, 0.0, 1.0], axes = wheel),
    jet: Wrench(
        nut.point(0.1, 0.1, 0.0),
        force = [1.0_N, 0.2, 0.1],
        torque = [0.3_Nm, 0.1, -push * 0.1_m],
        axes = drum
    ),
    motor: Torque(hinge, value = 0.4_Nm * cos(3.0_rad_per_s * t)),
    stir: Torque(
        wheel,
        value = [0.1_Nm, 0.2, 0.3],
        from = plate,
        axes = table
    ),

    turned: Output(hinge.angle + 2.0 * sleeve.angle),
    pace: Output(hinge.rate - swivel.rate),
    shifted: Output(slide.stroke),
    quickness: Output(slide.speed),
    spot: Output(wheel.point(0.0, 0.2, 0.0)),
    turn_rate: Output(reject(wheel.angular_velocity, wheel.y)),
    rider_place: Output(rider.origin),
});

mechanism!(Whip {
    doc: "Affinities whose code is too long: a ball joint and hinges about axes in turn.",
    world: Spatial(gravity = [0.0, 0.3, -9.81_m_per_s2], coordinates = Joint),

    handle: Bar(
        mass = 0.5_kg,
        from = [0.0, 0.0, 0.0],
        to = [0.0, 0.0, -0.3],
        radius = 0.02_m
    ),
    lash0: Bar(
        mass = 0.4_kg,
        from = [0.0, 0.0, -0.3],
        to = [0.0, 0.1, -0.6],
        radius = 0.02_m
    ),
    lash1: Bar(
        mass = 0.3_kg,
        from = [0.0, 0.1, -0.6],
        to = [0.1, 0.1, -0.9],
        radius = 0.02_m
    ),
    lash2: Bar(
        mass = 0.2_kg,
        from = [0.1, 0.1, -0.9],
        to = [0.1, 0.2, -1.2],
        radius = 0.02_m
    ),
    grip: Spherical(ground, handle, at = [0.0, 0.0, 0.0]),
    hinge0: Revolute(handle, lash0, at = [0.0, 0.0, -0.3], axis = X),
    hinge1: Revolute(lash0, lash1, at = [0.0, 0.1, -0.6], axis = Y),
    hinge2: Revolute(lash1, lash2, at = [0.1, 0.1, -0.9], axis = X),
    tip: Output(lash2.b),
});

mechanism!(Vice {
    doc: "Screws that are coordinates, one of each hand, and one declared from the part that it carries.",
    world: Spatial(gravity = [0.2, 0.3, -9.81_m_per_s2], coordinates = Joint),
    lift: Param(0.4_m),

    bed: Body(
        mass = 2.0_kg,
        inertia = diag(0.1, 0.2, 0.15),
        at = [0.3, 0.2, 0.1],
        center_of_mass = [0.1, 0.0, 0.05]
    ),
    jaw: Body(
        mass = 1.0_kg,
        inertia = diag(0.05, 0.04, 0.06),
        at = [0.5, 0.2, 0.1],
        orientation = turn([1.0, 2.0, 0.5], 0.7),
        center_of_mass = [0.02, -0.03, 0.05]
    ),
    handle: Body(
        mass = 0.6_kg,
        inertia = diag(0.01, 0.02, 0.025),
        at = [0.6, 0.4, 0.2],
        center_of_mass = [0.05, 0.02, 0.0]
    ),
    hinge: Revolute(ground, bed, at = [0.0, 0.0, 0.0], axis = [0.0, 1.0, 0.3]),
    thread: Screw(
        bed,
        jaw,
        at = [0.5, 0.2, 0.3],
        axis = [0.3, 0.2, 1.0],
        pitch = lift
    ),
    left: Screw(
        handle,
        jaw,
        at = [0.5, 0.3, 0.2],
        axis = [1.0, 0.0, 0.2],
        pitch = -0.3_m
    ),
    wind: TorsionSpring(left, stiffness = 3.0_Nm, angle = 0.5),
    turned: Output(thread.angle),
    sliding: Output(left.speed),
});

// A chain whose forces and tangents are too long for one function each: links, stays and discs repeat.
mechanism!(Spine {
    doc: "Ten links in space between stays with a law and discs.",
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),

    link0: Body(
        at = [0.0_m, 0.0, 0.0],
        mass = 1.0_kg,
        inertia = diag(0.02, 0.03, 0.01) * 1.0_kg_m2,
        center_of_mass = [0.25_m, 0.0, 0.0],
    ),
    link1: Body(
        at = [0.5_m, 0.0, 0.0],
        mass = 1.1_kg,
        inertia = diag(0.02, 0.03, 0.01) * 1.0_kg_m2,
        center_of_mass = [0.25_m, 0.0, 0.0],
    ),
    link2: Body(
        at = [1.0_m, 0.0, 0.0],
        mass = 1.2_kg,
        inertia = diag(0.02, 0.03, 0.01) * 1.0_kg_m2,
        center_of_mass = [0.25_m, 0.0, 0.0],
    ),
    link3: Body(
        at = [1.5_m, 0.0, 0.0],
        mass = 1.3_kg,
        inertia = diag(0.02, 0.03, 0.01) * 1.0_kg_m2,
        center_of_mass = [0.25_m, 0.0, 0.0],
    ),
    link4: Body(
        at = [2.0_m, 0.0, 0.0],
        mass = 1.4_kg,
        inertia = diag(0.02, 0.03, 0.01) * 1.0_kg_m2,
        center_of_mass = [0.25_m, 0.0, 0.0],
    ),
    link5: Body(
        at = [2.5_m, 0.0, 0.0],
        mass = 1.5_kg,
        inertia = diag(0.02, 0.03, 0.01) * 1.0_kg_m2,
        center_of_mass = [0.25_m, 0.0, 0.0],
    ),
    link6: Body(
        at = [3.0_m, 0.0, 0.0],
        mass = 1.6_kg,
        inertia = diag(0.02, 0.03, 0.01) * 1.0_kg_m2,
        center_of_mass = [0.25_m, 0.0, 0.0],
    ),
    link7: Body(
        at = [3.5_m, 0.0, 0.0],
        mass = 1.7_kg,
        inertia = diag(0.02, 0.03, 0.01) * 1.0_kg_m2,
        center_of_mass = [0.25_m, 0.0, 0.0],
    ),
    link8: Body(
        at = [4.0_m, 0.0, 0.0],
        mass = 1.8_kg,
        inertia = diag(0.02, 0.03, 0.01) * 1.0_kg_m2,
        center_of_mass = [0.25_m, 0.0, 0.0],
    ),
    link9: Body(
        at = [4.5_m, 0.0, 0.0],
        mass = 1.9_kg,
        inertia = diag(0.02, 0.03, 0.01) * 1.0_kg_m2,
        center_of_mass = [0.25_m, 0.0, 0.0],
    ),
    joint0: Revolute(ground, link0, at = [0.0_m, 0.0, 0.0], axis = Y),
    joint1: Revolute(link0, link1, at = [0.5_m, 0.0, 0.0], axis = Z),
    joint2: Revolute(link1, link2, at = [1.0_m, 0.0, 0.0], axis = Y),
    joint3: Revolute(link2, link3, at = [1.5_m, 0.0, 0.0], axis = Z),
    joint4: Revolute(link3, link4, at = [2.0_m, 0.0, 0.0], axis = Y),
    joint5: Revolute(link4, link5, at = [2.5_m, 0.0, 0.0], axis = Z),
    joint6: Revolute(link5, link6, at = [3.0_m, 0.0, 0.0], axis = Y),
    joint7: Revolute(link6, link7, at = [3.5_m, 0.0, 0.0], axis = Z),
    joint8: Revolute(link7, link8, at = [4.0_m, 0.0, 0.0], axis = Y),
    joint9: Revolute(link8, link9, at = [4.5_m, 0.0, 0.0], axis = Z),
    stay3: SpringDamper(
        ground.point(1.8_m, 1.0, 0.5),
        link3.center,
        law = laws::stiffening
    ),
    stay6: SpringDamper(
        ground.point(3.3_m, 1.0, 0.5),
        link6.center,
        law = laws::stiffening
    ),
    stay9: SpringDamper(
        ground.point(4.8_m, 1.0, 0.5),
        link9.center,
        law = laws::stiffening
    ),
    disc2: Bushing(
        link1,
        link3,
        at = [1.2_m, 0.0, 0.0],
        stiffness = [100.0_N_per_m, 200.0, 300.0],
        damping = [1.0_N_s_per_m, 2.0, 3.0],
        torsion_stiffness = 10.0_Nm,
        torsion_damping = 0.1_N_m_s,
    ),
    disc5: Bushing(
        link4,
        link6,
        at = [2.7_m, 0.0, 0.0],
        stiffness = [100.0_N_per_m, 200.0, 300.0],
        damping = [1.0_N_s_per_m, 2.0, 3.0],
        torsion_stiffness = 10.0_Nm,
        torsion_damping = 0.1_N_m_s,
    ),
    disc8: Bushing(
        link7,
        link9,
        at = [4.2_m, 0.0, 0.0],
        stiffness = [100.0_N_per_m, 200.0, 300.0],
        damping = [1.0_N_s_per_m, 2.0, 3.0],
        torsion_stiffness = 10.0_Nm,
        torsion_damping = 0.1_N_m_s,
    ),
    tip: Output(link9.point(0.5_m, 0.0, 0.0)),
});
