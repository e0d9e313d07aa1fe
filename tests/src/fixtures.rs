//! Mechanisms that between them use every kind and every function of the language. They need not be sensible machines,
//! and they need not be assembled: derivatives hold everywhere.

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
        bead.origin.y - 0.2 * weight.origin.x,
        value = 0.3_m + 0.1_m_per_s * t
    ),
    ramp: Holonomic(cross(coupler.x, rocker.x) - 0.1 * (1.0_per_s * t).sin()),

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
