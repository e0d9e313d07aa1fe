//! Messages that say what to write instead, where a habit of Rust or of other programs was followed.

use crate::common::expansion::{accepted, messages, refused};

/// Constants of Rust.
#[test]
fn a_constant_is_no_misspelling_of_the_parameter_that_reads_it() {
    refused(
        "
mechanism!(M {
    world: Planar(),
    mass: Param(MASS),
                ~~~~ nothing here is named `MASS`; a constant of Rust is the default of a parameter: `mass: Param(MASS, nominal = …)`, with about its value and its unit
    p: Particle(mass = mass, free = true),
});
        ",
    );
    refused(
        "
mechanism!(M {
    world: Planar(),
    mass: Param(1.0_kg),
    p: Particle(mass = mass, free = true),
    q: Particle(mass = MASS, free = true),
                       ~~~~ nothing here is named `MASS`; did you mean `mass`?
});
        ",
    );
    refused(
        "
assembly!(A { world: Planar(), mass: Param(MASS), p: Particle(mass = mass, free = true) });
                                           ~~~~ the assembly `A` has no entry or port `MASS`; a constant of Rust is the default of a parameter of a mechanism: where an assembly is used its path would mean another one; give a number here
        ",
    );
}

/// A name is looked up before it is taken as a constant of Rust.
#[test]
fn parameters_of_assemblies_are_given_numbers() {
    refused(
        "
assembly!(A { world: Planar(), l: Param(1.0_m), p: Particle(mass = 1.0_kg, at = [l, 0.0_m], free = true) });
mechanism!(M {
    world: Planar(),
    k: Param(2.0_m),
    x: Assembly(A, l = k),
                       ~ in `x.l`: the default of a parameter is a number; to give a quantity of the mechanism, let `l` be a port of the assembly
    y: Assembly(A, l = 2.0 * k),
                       ~~~~~~~ in `y.l`: the default of a parameter is a number; to give a quantity of the mechanism, let `l` be a port of the assembly
    o: Output(k),
});
        ",
    );
    refused(
        "
assembly!(A { world: Planar(), l: Param(1.0), p: Particle(mass = 1.0_kg, at = [l * 1.0_m, 0.0_m], free = true) });
mechanism!(M {
    world: Planar(),
    k: Param(2.0),
    x: Assembly(A, l = k),
                       ~ in `x.l`: the default of a parameter is a number; to give a quantity of the mechanism, let `l` be a port of the assembly
    y: Assembly(A, l = j),
                       ~ in `y.l`: nothing here is named `j`
    z: Assembly(A, l = FACTOR),
                       ~~~~~~ in `z.l`: a constant of Rust is the default of a parameter of a mechanism: where an assembly is used its path would mean another one; give a number here
    o: Output(k),
});
        ",
    );
}

#[test]
fn equations_and_comparisons() {
    refused(
        "
mechanism!(M {
    world: Planar(),
    b: Bar(mass = 1.0_kg, length = 1.0_m),
    h: Holonomic(b.b.x == 0.1_m),
                       ~~ quantities are not compared: write the difference `a - b` in place of `a == b`; a condition holds it at zero, and an event is where it passes through zero
    e: Event(b.angle > 0.0),
                     ~ quantities are not compared: write the difference `a - b` in place of `a > b`; a condition holds it at zero, and an event is where it passes through zero
    n: Nonholonomic([b.b.velocity.x = 0.1_m_per_s]),
                                    ~ quantities are not compared: write the difference `a - b` in place of `a = b`; a condition holds it at zero, and an event is where it passes through zero
    f: Force(b.b, value = [b.a.x ** 2 * 1.0_N_per_m2, 0.0]),
                                  ~~~ for powers use x.powi(2) or x.powf(1.5)
});
        ",
    );
    refused(
        "
mechanism!(M {
    world: Planar(),
    b: Bar(mass = 1.0_kg, length = 1.0_m),
    h: Holonomic(b.b.x = 0.1_m),
                 ~~~~~ expected `name = value`; for an equation write the difference of its sides, as in `b.b.x - 0.1_m`
});
        ",
    );
}

#[test]
fn kinds_by_one_of_their_words() {
    let asked = |kind: &str, meant: &str| {
        let under = "~".repeat(kind.len());
        refused(&format!(
            "
mechanism!(M {{
    world: Planar(),
    b: Bar(mass = 1.0_kg, length = 1.0_m),
    s: {kind}(ground.origin, b.b),
       {under} there is no kind `{kind}`; did you mean `{meant}`?
}});
            "
        ));
    };
    asked("Spring", "SpringDamper");
    asked("Damper", "SpringDamper");
    asked("Torsion", "TorsionSpring");
    asked("Pinion", "RackPinion");
    asked("point", "Point");
    asked("Revolut", "Revolute");
}

#[test]
fn events_that_never_occur() {
    refused(
        "
mechanism!(M {
    world: Planar(),
    k: Param(2.0),
    push: Input(1.0_N),
    b: Particle(mass = 1.0_kg, free = true),
    f: Force(b.origin, value = [push, 0.0]),
    one: Event(1.0),
               ~~~ this depends on parameters only, so that the event never occurs: name what changes in a run, such as a position
    two: Event(k - 1.0),
               ~~~~~~~ this depends on parameters only, so that the event never occurs: name what changes in a run, such as a position
    three: Event(k - t * 1.0_per_s),
    four: Event(push),
    five: Event(b.origin.x),
});
        ",
    );
}

/// It was 0: a controller lost the rate of its target without a message.
#[test]
fn inputs_have_no_rate() {
    refused(
        "mechanism!(Arm {
    world: Planar(),
    target: Input(unit = rad),
    arm: Bar(mass = 1.0_kg, length = 1.0_m),
    pivot: Revolute(ground.origin, arm.a),
    pd: Torque(arm, value = 1.0_N_m_s * rate(target - arm.angle)),
                                             ~~~~~~ this follows an input, whose rate is unknown: take it out of the rate(…), and give its rate by an `Input` of its own
});",
    );
}

/// A world that is there has its own error alone.
#[test]
fn worlds_without_their_name() {
    refused(
        "
mechanism!(M {
    Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    ~~~~~~~ the name of a world is `world`; write `world: Spatial(…)`
    p: Particle(mass = 1.0_kg, free = true),
});
        ",
    );
    refused(
        "
mechanism!(M {
    Planar(gravity =-[0.0, 9.81_m_per_s2], coordinates = Reference),
    ~~~~~~ the name of a world is `world`; write `world: Planar(…)`
    p: Particle(mass = 1.0_kg, free = true),
});
        ",
    );
    refused(
        "
mechanism!(M {
    doc: \"x\" world: Spatial(),
             ~~~~~ expected `,` between entries
    p: Particle(mass = 1.0_kg, free = true),
});
        ",
    );
    refused(
        "
assembly!(A { Planar(), p: Particle(mass = 1.0_kg, free = true) });
              ~~~~~~ the name of a world is `world`; write `world: Planar(…)`
        ",
    );
    // With partners it is a joint, and there is no world.
    refused(
        "
mechanism!(M {
           ~ this mechanism has no world; write `world: Planar(gravity = [0.0, -9.81_m_per_s2]),` as its first entry
    Planar(ground, p),
    ~~~~~~ this `Planar` has no name; write `name: Planar(…)`
    p: Particle(mass = 1.0_kg, free = true),
});
        ",
    );
}

/// What reads a value that is missing is not wrong.
#[test]
fn parameters_and_inputs_without_a_value() {
    refused(
        "
mechanism!(M {
    world: Planar(),
    l: Param(),
       ~~~~~ `Param` needs `value`: default value; its unit fixes the dimension. With `nominal =` the path of a constant of Rust, an `f64` in SI units
    k: Param(vlaue = 1.0_m),
             ~~~~~ `Param` has no argument `vlaue`; did you mean `value`? (arguments: value, nominal, unit)
    c: Param(nominal = 1.0_m),
       ~~~~~ `Param` needs `value`: default value; its unit fixes the dimension. With `nominal =` the path of a constant of Rust, an `f64` in SI units
    i: Input(vlaue = 1.0_N),
             ~~~~~ `Input` has no argument `vlaue`; did you mean `value`? (arguments: value, unit)
    b: Bar(mass = 1.0_kg, length = l, free = true),
    d: Bar(mass = 1.0_kg, length = k + c, free = true),
    f: Force(b.b, value = [1.0_N * (1.0_N / i), i]),
});
        ",
    );
}

/// Of two names of three letters few are misspellings of each other.
#[test]
fn short_names() {
    let function = |call: &str, meant: &str| {
        let (name, _) = call.split_once('(').expect("a call");
        let (under, list) = (
            "~".repeat(name.len()),
            "sin, cos, tan, asin, acos, atan, exp, ln, sinh, cosh, tanh, sqrt, abs, sign, step, dot, cross, norm, unit, reject, rate, atan2, hypot, min, max, law, powi, powf",
        );
        refused(&format!(
            "
mechanism!(M {{
    world: Planar(),
    p: Particle(mass = 1.0_kg, free = true),
    o: Output({call}),
              {under} there is no function `{name}`{} (functions: {list})
}});
            ",
            hint(meant)
        ));
    };
    function("log(2.0)", "ln");
    function("der(p.origin.x)", "rate");
    function("diff(p.origin.x)", "rate");
    function("sgn(2.0)", "sign");
    function("pow(2.0, 3.0)", "powf");
    function("cso(2.0)", "cos");
    function("deg(2.0)", "");
    function("int(2.0)", "");
    function("foo(1.0)", "");
    let unit = |suffix: &str, meant: &str| {
        let under = "~".repeat(suffix.len() + 4);
        refused(&format!(
            "
mechanism!(M {{
    world: Planar(),
    p: Particle(mass = 1.0_kg, free = true),
    k: Param(1.0_{suffix}),
             {under} there is no unit `{suffix}`{} (units: m, km, cm, mm, kg, g, t, s, ms, min, h, rad, deg, rev, rpm, N, kN, MN, Nm, kNm, J, kJ, W, kW, Pa, A, V, ohm; joined by `_`, divided after `per`, as in `9.81_m_per_s2`)
    o: Output(k),
}});
            ",
            hint(meant)
        ));
    };
    unit("sec", "s");
    unit("deg_per_sec2", "deg_per_s2");
    unit("kgm2", "kg_m2");
    unit("Ns", "N_s");
    unit("kgs", "kg");
    unit("KG", "kg");
    unit("degree", "deg");
    unit("m0", "");
    let kind = |kind: &str, meant: &str| {
        let under = "~".repeat(kind.len());
        refused(&format!(
            "
mechanism!(M {{
    world: Planar(),
    p: {kind}(mass = 1.0_kg),
       {under} there is no kind `{kind}`; did you mean `{meant}`?
}});
            "
        ));
    };
    kind("Out", "Output");
    kind("Rev", "Revolute");
    kind("Rod", "Bar");
    kind("Link", "Bar");
    kind("Bra", "Bar");
    let found = messages("mechanism!(M { world: Planar(), p: Var(1.0) });");
    assert!(
        found[0].0.starts_with("there is no kind `Var` (kinds: "),
        "{found:?}"
    );
    // Words of a name are no beginning of it.
    refused(
        "
mechanism!(M {
    world: Planar(),
    rod_mass: Param(1.0_kg),
    crankpin: Particle(mass = rod_mass, free = true),
    o: Output(rod.b),
              ~~~ nothing here is named `rod`
    e: Output(crank_pin.origin),
              ~~~~~~~~~ nothing here is named `crank_pin`; did you mean `crankpin`?
});
        ",
    );
}

fn hint(meant: &str) -> String {
    match meant {
        "" => String::new(),
        meant => format!("; did you mean `{meant}`?"),
    }
}

#[test]
fn negatives_of_points() {
    accepted(
        "
mechanism!(M {
    world: Planar(),
    b: Bar(mass = 1.0_kg, length = 1.0_m, free = true),
    f: SpringDamper(b.b, ground.origin, stiffness = 1.0_N_per_m),
    o: Output(-b.b),
    p: Point(-[1.0_m, 0.0_m]),
    d: Output(-p + b.a),
});
        ",
    );
    accepted(
        "
mechanism!(M {
    world: Spatial(),
    b: Body(mass = 1.0_kg, inertia = -diag(-1.0_kg_m2, -1.0_kg_m2, -1.0_kg_m2), free = true),
    o: Output(-b.origin),
});
        ",
    );
    refused(
        "
mechanism!(M {
    world: Planar(),
    b: Bar(mass = 1.0_kg, length = 1.0_m, free = true),
    o: Output(-b),
              ~~ a part has no negative
});
        ",
    );
}

#[test]
fn values_that_are_held_are_one() {
    refused(
        "
mechanism!(M {
    world: Planar(),
    b: Bar(mass = 1.0_kg, length = 1.0_m, free = true, angle = Exactly(0.1, 0.2)),
                                                               ~~~~~~~ `Exactly` takes one value, not 2; a vector is a list, as in `at = Exactly([0.1_m, 0.2_m])`
    c: Bar(mass = 1.0_kg, length = 1.0_m, free = true, angle = Exactly()),
                                                               ~~~~~~~ `Exactly` takes one value, not 0; a vector is a list, as in `at = Exactly([0.1_m, 0.2_m])`
});
        ",
    );
}

#[test]
fn values_that_were_forgotten() {
    refused(
        "
mechanism!(M {
    world: Planar(),
    b: Bar(mass = length = 0.1_m, free = true),
                  ~~~~~~ the value of `mass` is missing: write `mass = …, length = …`
    o: Output(b.b),
});
        ",
    );
    refused(
        "
mechanism!(M {
    world: Spatial(),
    b: Bar(mass = length = 0.1_m, free = true),
                  ~~~~~~ the value of `mass` is missing: write `mass = …, length = …`
    c: Bar(mass = 1.0_kg, lenght = 0.1_m, free = true),
                          ~~~~~~ `Bar` has no argument `lenght`; did you mean `length`? (arguments: mass, length, from, to, radius, inertia, velocity, angular_velocity, coordinates, free)
});
        ",
    );
    refused(
        "
mechanism!(M {
    world: Planar(),
    b: Each(0..3, |i| Bar(mass = length = 0.1_m, free = true)),
                                 ~~~~~~ in `b[0]`: the value of `mass` is missing: write `mass = …, length = …` (and the same in 2 other members)
});
        ",
    );
}
