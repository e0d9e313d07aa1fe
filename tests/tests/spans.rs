//! Positions of errors: a line of a declaration, and `~` under the wrong tokens.

use mbs_macros_core::analyse;

/// Entries before the lines, to which they may refer.
const BEFORE: &str = "world: Planar(gravity = [0.0, -9.81_m_per_s2]),
bar: Bar(mass = 1.0_kg, length = 1.0_m),
pivot: Revolute(ground.origin, bar.a),
";

/// With these two lines (an entry, and marks under it) the only message contains `message` and is about the marked
/// tokens.
fn points_at(lines: &str, message: &str) {
    points_at_after(BEFORE, lines, message);
}

/// Entries before the lines, in space.
const IN_SPACE: &str = "world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
arm: Body(mass = 1.0_kg, inertia = 0.1_kg_m2),
hinge: Revolute(ground, arm, at = [0.0, 0.0, 0.0], axis = X),
rod: Bar(mass = 1.0_kg, to = [1.0, 0.0, 0.0]),
ball: Spherical(ground.origin, rod.a),
";

fn points_at_in_space(lines: &str, message: &str) {
    points_at_after(IN_SPACE, lines, message);
}

fn points_at_after(before: &str, lines: &str, message: &str) {
    let mut lines = lines.lines().filter(|line| !line.trim().is_empty());
    let (line, marks) = (
        lines.next().expect("an entry"),
        lines.next().expect("marks"),
    );
    let text = format!("Marked {{\n{before}{line}\n}}");
    let (_, outcome) = analyse(text.parse().expect("these are tokens"));
    let failure = outcome.err().unwrap_or_else(|| panic!("accepted: {line}"));
    let messages = failure.messages();
    let [(found, span)] = messages.as_slice() else {
        panic!("expected one message, found {messages:#?}");
    };
    assert_eq!(
        span.start.line,
        before.lines().count() + 2,
        "another line: {found}"
    );
    let columns = span.start.column..span.end.column;
    let underlined: String = (0..columns.end)
        .map(|column| if columns.contains(&column) { '~' } else { ' ' })
        .collect();
    assert_eq!(
        underlined,
        marks.trim_end(),
        "\n{line}\n{underlined}\n{found}"
    );
    assert!(found.contains(message), "the message is: {found}");
}

#[test]
fn names() {
    points_at(
        "
        out: Output(bra.b.x),
                    ~~~",
        "nothing here is named `bra`; did you mean `bar`?",
    );
    points_at(
        "
        out: Output(bar.b.volocity.x),
                          ~~~~~~~~",
        "did you mean `velocity`?",
    );
    points_at(
        "
        out: Output(bar.angle.cso()),
                              ~~~",
        "did you mean `cos`?",
    );
    points_at(
        "
        out: Outptu(bar.b),
             ~~~~~~",
        "did you mean `Output`?",
    );
    points_at(
        "
        ground: Particle(mass = 1.0_kg),
        ~~~~~~",
        "`ground` is reserved",
    );
    points_at(
        "
        out: Output(pivot),
                    ~~~~~",
        "an output is a number, vector or point, but this is the joint `pivot`",
    );
}

#[test]
fn arguments() {
    points_at(
        "
        rod: Distance(bar.b, ground.origin),
             ~~~~~~~~",
        "`Distance` needs `length`: the distance kept",
    );
    points_at(
        "
        rod: Distance(bar.b, ground.origin, lenght = 1.0_m),
                                            ~~~~~~",
        "did you mean `length`?",
    );
    points_at(
        "
        rod: Distance(bar.b, ground.origin, 1.0_m + 2.0_m),
                                            ~~~~~~~~~~~~~",
        "takes 2 positional arguments (`parent`, `child`)",
    );
    points_at(
        "
        out: Output(),
             ~~~~~~",
        "`Output` needs `value`",
    );
    points_at(
        "
        push: Force(on = bar.b, value = [1.0_N, 0.0_N], on = bar.a),
                                                        ~~",
        "`on` is given twice",
    );
    points_at(
        "
        push: Force(on = bar.b, value = [1.0_N, 0.0_N], bar.a),
                                                        ~~~~~",
        "positional arguments come before named ones",
    );
}

#[test]
fn dimensions() {
    points_at(
        "
        push: Force(on = bar.b, value = [1.0_N * 2.0_m, 0.0_Nm]),
                                        ~~~~~~~~~~~~~~~~~~~~~~~",
        "`value` is a force (N), but this is a torque or energy (N m)",
    );
    points_at(
        "
        out: Output(bar.b.x + 2.0 * bar.rate),
                            ~",
        "a length (m) against a rate (rad/s)",
    );
    points_at(
        "
        out: Output(exp(2.0 * bar.b.x)),
                        ~~~~~~~~~~~~~",
        "`exp` takes a pure number or an angle, but this is a length (m)",
    );
    points_at(
        "
        load: Input(1.0_N, unit = Nm),
                                  ~~",
        "this unit is that of a torque or energy (N m), but the value is a force (N)",
    );
    points_at(
        "
        rod: Distance(bar.b, ground.origin, length = 2.0_m_per_min2),
                                                     ~~~~~~~~~~~~~~",
        "`length` is a length (m), but this is an acceleration (m/s²)",
    );
    points_at(
        "
        swing: Coupling(bar.angle, bar.b.x, ratio = 2.0_kg),
                                                    ~~~~~~",
        "the ratio takes a pure number or angle to a length (m)",
    );
}

#[test]
fn conditions() {
    points_at(
        "
        slip: Holonomic(bar.b.x - 2.0_s * bar.b.velocity.x),
                                          ~~~~~~~~~~~~~~~~",
        "a holonomic condition has no velocities",
    );
    points_at(
        "
        slip: Nonholonomic([bar.b.velocity.x, bar.b.x]),
                                              ~~~~~~~",
        "needs velocities",
    );
    points_at(
        "
        slip: Nonholonomic([bar.rate, norm(bar.b.velocity)]),
                                      ~~~~~~~~~~~~~~~~~~~~",
        "affine in the velocities",
    );
    points_at(
        "
        turn: Drive(bar.angle, value = sin(bar.angle) + 1.0_rad_per_s * t),
                                           ~~~~~~~~~",
        "a drive follows time, parameters and inputs only",
    );
    points_at(
        "
        held: PointOnLine(bar.a, ground.origin, axis = Y),
        ~~~~",
        "other joints already fix all that `held` holds",
    );
    points_at(
        "
        rod: Distance(bar.b, ground.origin, length = bar.b.x),
                                                     ~~~~~~~",
        "must be known before the motion starts",
    );
}

#[test]
fn examples_fit_what_they_are_given_for() {
    points_at(
        "
        deny: redundant,
              ~~~~~~~~~",
        "for example `deny: Redundant()`",
    );
    points_at(
        "
        rod: Bar(from = 2.0 * bar.b, mass = 1.0_kg, length = 1.0_m),
                              ~~~~~",
        "a place that several entries share is a `Point`",
    );
}

#[test]
fn parts() {
    points_at(
        "
        bob: Particle(mass = 0.0_kg, free = true),
        ~~~",
        "`bob` moves without mass",
    );
    points_at(
        "
        bob: Particle(mass = 1.0_kg),
        ~~~",
        "`bob` is connected to nothing",
    );
    points_at(
        "
        rod: Bar(mass = 1.0_kg, from = [0.0, 0.0], free = true),
        ~~~",
        "`rod` has no length",
    );
    points_at(
        "
        rod: Bar(mass = 1.0_kg, length = 1.0_m - 1.0_m, free = true),
                                         ~~~~~~~~~~~~~",
        "a bar has a positive length",
    );
    points_at(
        "
        weld: Fixed(ground.origin, bar),
                                   ~~~",
        "`child` is a point: name one of `bar`",
    );
    points_at(
        "
        motor: Torque(on = bar.b, value = 1.0_Nm),
                           ~~~~~",
        "`on` is a part or `ground`, but this is the point `bar.b`",
    );
}

#[test]
fn syntax() {
    points_at(
        "
        lever: 2.0 * 1.0_m,
               ~~~~~~~~~~~",
        "expected `lever: Kind(…)`",
    );
    points_at(
        "
        lever = Param(1.0_m),
        ~~~~~",
        "expected `:` after `lever`",
    );
    points_at(
        "
        Param(1.0_m),
        ~~~~~",
        "this `Param` has no name",
    );
    points_at(
        "
        lever: Param(1.0_m) Param(1.0_m),
                            ~~~~~",
        "expected `,` between entries",
    );
    points_at(
        "
        out: Output([bar.b.x, if true { 1.0 } else { 2.0 }]),
                              ~~~~~~~~~~~~~~~~~~~~~~~~~~~~",
        "an `if` decides by indices alone",
    );
    points_at(
        "
        doc: concat!(\"two\", \"texts\"),
             ~~~~~~~~~~~~~~~~~~~~~~~",
        "`doc:` takes a text in quotes",
    );
}

#[test]
fn places_of_space() {
    points_at_in_space(
        "
        stick: Bar(mass = 1.0_kg, from = arm.origin + [hinge.angle * 1.0_m, 0.0, 0.0], to = [1.0, 0.0, 0.0]),
                                                       ~~~~~~~~~~~
        ",
        "it may use numbers, parameters, and points and axes of parts, which are then those of the home pose",
    );
    points_at_in_space(
        "
        stick: Bar(mass = 1.0_kg, from = [0.0, 0.0, 0.0], to = stick.a + [1.0_m, 0.0, 0.0]),
                                                               ~~~~~
        ",
        "`stick` depends on itself; let it name only entries that do not lead back to it",
    );
    points_at_in_space(
        "
        pin: Revolute(arm, ground, at = rod.b, axis = rod.b - rod.a),
                                                      ~~~~~~~~~~~~~
        ",
        "`axis` is a pure number or angle, but this is a length (m)",
    );
}

#[test]
fn joints_of_space() {
    points_at_in_space(
        "
        out: Output(ball.angle),
                         ~~~~~
        ",
        "a `Spherical` leaves no single motion to name",
    );
    points_at_in_space(
        "
        out: Output(hinge.stroke),
                          ~~~~~~
        ",
        "a `Revolute` does not slide (it has: angle, rate)",
    );
    points_at_in_space(
        "
        pin: Revolute(ground.origin, rod.a, axis = X),
                                     ~~~~~
        ",
        "`rod` is a slender bar",
    );
    points_at_in_space(
        "
        pin: Universal(ground.origin, arm.origin, axis = X, second_axis = [1.0, 1.0, 0.0]),
                                                                          ~~~~~~~~~~~~~~~
        ",
        "cross at right angles, but these at 45.000°",
    );
    points_at_in_space(
        "
        pin: Revolute(arm.frame([0.0, 0.0, 0.0], 0.0 * X), ground.origin),
                                                 ~~~~~~~
        ",
        "this axis has no length; give it a direction, such as X or [1.0, 1.0, 0.0]",
    );
    points_at_in_space(
        "
        pin: Prismatic(arm.origin, ground.point(0.0, 0.5, 0.0), axis = X),
        ~~~
        ",
        "0.500 m apart in directions that this `Prismatic` holds",
    );
    points_at_in_space(
        "
        coil: TorsionSpring(ground, arm, stiffness = 1.0_Nm),
                                    ~~~
        ",
        "`TorsionSpring` takes one positional argument",
    );
    points_at_in_space(
        "
        mount: Bushing(arm, rod, at = [0.0, 0.0, 0.0], stiffness = 1.0_N_per_m),
                            ~~~
        ",
        "`rod` is a slender bar",
    );
    points_at_in_space(
        "
        rope: Distance(arm.origin, rod.b, length = 0.0_m),
                                                   ~~~~~
        ",
        "to hold two points together use `Spherical`",
    );
}

#[test]
fn parts_of_space() {
    points_at_in_space(
        "
        out: Output(rod.y),
                        ~
        ",
        "a slender bar has no axes across it",
    );
    points_at_in_space(
        "
        out: Output(arm.rate),
                        ~~~~
        ",
        "in space parts have `angular_velocity`",
    );
    points_at_in_space(
        "
        lump: Body(mass = 1.0_kg, inertia = Ball(0.1_m), free = true),
                                            ~~~~
        ",
        "there is no function `Ball`",
    );
    points_at_in_space(
        "
        lump: Body(mass = 1.0_kg, inertia = Spere(0.1_m), free = true),
                                            ~~~~~
        ",
        "there is no shape `Spere`; did you mean `Sphere`?",
    );
    points_at_in_space(
        "
        beam: Bar(mass = 1.0_kg, from = [1.0, 0.0, 0.0], to = [1.0, 0.0, 0.0], free = true),
                                                              ~~~~~~~~~~~~~~~
        ",
        "a bar has a positive length",
    );
    points_at_in_space(
        "
        out: Output(arm.velocity_at(2.0 * arm.x)),
                                    ~~~~~~~~~~~
        ",
        "`velocity_at` takes a point",
    );
}

#[test]
fn what_only_numbers_tell() {
    points_at_in_space(
        "
        rope: Distance(ground.point(0.0, 0.0, 9.0), rod.b, length = 1.0_m),
        ~~~~
        ",
        "this loop cannot close",
    );
    points_at(
        "
        rope: Distance(ground.point(9.0, 0.0), bar.b, length = 1.0_m),
        ~~~~
        ",
        "this loop cannot close",
    );
}
