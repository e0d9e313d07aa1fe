//! Of the plane.

use mbs_runtime::assembly;

assembly!(FourBar {
    doc: "A crank, a coupler and a rocker between two points.",
    world: Planar(),
    /// The bearing of the crank.
    left: Port(Point),
    /// The bearing of the rocker.
    right: Port(Point),
    /// Guess of the angle of the crank at the start; `Exactly(…)` holds it.
    angle: Port(Number, default = 60.0_deg),
    /// Guess of its rate; `Exactly(…)` holds it.
    rate: Port(Number, default = 0.0_rad_per_s),
    /// Guess of the direction from `left` to `right`.
    line: Port(Number, default = 0.0_deg),

    /// Length of the crank.
    crank_length: Param(0.3_m),
    /// Length of the coupler.
    coupler_length: Param(0.8_m),
    /// Length of the rocker.
    rocker_length: Param(0.6_m),
    /// Mass of all rods, by their length.
    mass: Param(1.0_kg_per_m),

    crank: Bar(
        mass = mass * crank_length,
        length = crank_length,
        angle = angle,
        rate = rate
    ),
    coupler: Bar(
        mass = mass * coupler_length,
        length = coupler_length,
        angle = line + 23.0_deg
    ),
    rocker: Bar(
        mass = mass * rocker_length,
        length = rocker_length,
        angle = line + 72.0_deg
    ),
    main: Revolute(left, crank.a),
    pin: Revolute(crank.b, coupler.a),
    top: Revolute(coupler.b, rocker.b),
    foot: Revolute(right, rocker.a),
});

assembly!(GearTrain {
    doc: "Spur wheels in a row, each in mesh with the next: neighbours turn in opposite senses.",
    world: Planar(),
    /// What bears the wheels; they stand along its x axis.
    carrier: Port(Part),
    /// How many wheels there are.
    count: Port(Number, default = 3),
    /// Rate of the first one at the start, against the carrier.
    rate: Port(Number, default = 0.0_rad_per_s),
    /// Angle of the carrier at the start.
    angle: Port(Number, default = 0.0_deg),
    /// Rate of the carrier at the start.
    turning: Port(Number, default = 0.0_rad_per_s),

    /// Pitch radius of each wheel.
    radius: Param(0.05_m),
    /// Mass of each wheel.
    mass: Param(0.4_kg),

    wheel: Each(0..count, |i| Body(
        mass = mass,
        inertia = 0.5 * mass * radius * radius,
        angle = angle,
        rate = turning + if i % 2 == 0 { rate } else { -rate }
    )),
    bearing: Each(0..count, |i| Revolute(
        carrier.point(2.0 * i * radius, 0.0_m),
        wheel[i].origin
    )),
    mesh: Each(1..count, |i| Coupling(
        wheel[i - 1].angle - carrier.angle,
        wheel[i].angle - carrier.angle,
        ratio = -1.0
    )),
});

assembly!(ScissorStage {
    doc: "Two arms of equal length, joined in their middle: a stage of a scissor lift. The next one stands on `falling.b` and",
    doc: "`rising.b`.",
    world: Planar(),
    /// Where the arm that rises to the right begins.
    left: Port(Point),
    /// Where the other one begins.
    right: Port(Point),
    /// Guess of the angle of the arm that rises; `Exactly(…)` holds it.
    angle: Port(Number, default = 40.0_deg),
    /// Guess of its rate; `Exactly(…)` holds it.
    rate: Port(Number, default = 0.0_rad_per_s),
    /// Guess of the direction from `left` to `right`.
    line: Port(Number, default = 0.0_deg),

    /// Length of the arms.
    length: Param(1.0_m),
    /// Mass of each.
    mass: Param(1.0_kg),

    rising: Bar(mass = mass, length = length, angle = angle, rate = rate),
    falling: Bar(
        mass = mass,
        length = length,
        angle = 180.0_deg + 2.0 * line - angle,
        rate = -rate
    ),
    foot: Revolute(left, rising.a),
    other_foot: Revolute(right, falling.a),
    pin: Revolute(rising.center, falling.center),
});

assembly!(Cylinder {
    doc: "A hydraulic cylinder between two points; the program moves it. `slide.stroke` is how far it is out.",
    world: Planar(),
    /// Where the barrel hangs.
    foot: Port(Point),
    /// Where the rod holds.
    head: Port(Point),
    /// Length between the points with the stroke 0; barrel and rod have 0.6 of it each.
    closed: Port(Number),
    /// Guess of the direction from foot to head.
    angle: Port(Number),

    /// Mass of the barrel.
    barrel_mass: Param(60.0_kg),
    /// Mass of the rod.
    rod_mass: Param(40.0_kg),
    /// How far it is out at `set_at`.
    stroke: Input(unit = m),
    /// How fast it goes out from then on.
    speed: Input(unit = m_per_s),
    /// The time of the two.
    set_at: Input(unit = s),

    barrel: Bar(mass = barrel_mass, length = 0.6 * closed, angle = angle),
    rod: Bar(mass = rod_mass, length = 0.6 * closed, angle = angle),
    hinge: Revolute(foot, barrel.a),
    pin: Revolute(head, rod.b),
    slide: Prismatic(barrel.point(0.4 * closed, 0.0_m), rod.a),
    oil: Drive(slide.stroke, value = stroke, rate = speed, since = set_at),
});
