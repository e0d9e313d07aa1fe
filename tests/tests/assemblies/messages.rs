//! What is wrong with assemblies, and with their uses.

use crate::common::expansion::{accepted, expanded, refused};

#[test]
fn entries_of_assemblies() {
    accepted(
        "
assembly!(A { world: Planar(), p: Particle(mass = 1.0_kg, free = true) });
mechanism!(M { world: Planar(), a: Assembly(A), o: Output(a.p.origin.x) });
        ",
    );
    refused(
        "
assembly!(A { world: Planar(), p: Particle(mass = 1.0_kg, free = true) });
mechanism!(M { world: Planar(), a: Assembly(A), o: Output(a.q.origin.x) });
                                                          ~~~ the assembly `A` has no entry or port `q`
        ",
    );
}

#[test]
fn one_value_for_two_arguments() {
    refused(
        "
assembly!(A { world: Planar(), l: Port(Number), k: Port(Number), p: Particle(mass = 1.0_kg, at = [l * 1.0_m, k * 1.0_m], free = true) });
mechanism!(M { world: Planar(), a: Assembly(A, l = k = 1.0), o: Output(a.p.origin.x) });
                                                   ~~~~~~~ each argument has a value of its own: write `l = 1.0, k = 1.0`
        ",
    );
    refused(
        "
assembly!(A { world: Planar(), l: Port(Number), k: Port(Number), p: Particle(mass = 1.0_kg, at = [l * 1.0_m, k * 1.0_m], free = true) });
mechanism!(M { world: Planar(), a: Assembly(A, l = k = m = 1.0), o: Output(a.p.origin.x) });
                                                   ~~~~~~~~~~~ each argument has a value of its own: write `l = 1.0, k = 1.0, m = 1.0`
        ",
    );
}

#[test]
fn defaults_of_ports() {
    refused(
        "
assembly!(A {
    world: Planar(),
    far: Port(Number, default = size),
                                ~~~~ the default of `far` needs the value of `size`, which is not known before; name ports that are declared before it
    size: Port(Number, default = size / 2.0),
                                 ~~~~ the default of `size` needs the value of `size`, which is not known before; name ports that are declared before it
    p: Particle(mass = 1.0_kg, at = [far, size]),
});
        ",
    );
}

#[test]
fn one_name_for_an_assembly_and_another_entry() {
    let second = |entry: &str, name: &str| {
        let before = "mechanism!(M { world: Planar(), a: Assembly(A), o: Output(a.p.origin.x), ";
        let (column, under) = (" ".repeat(before.len()), "~".repeat(name.len()));
        refused(&format!(
            "
assembly!(A {{ world: Planar(), p: Particle(mass = 1.0_kg, free = true), x: Output(p.origin.x) }});
{before}{entry}, q: Particle(mass = 1.0_kg, free = true) }});
{column}{under} `{name}` is declared twice; rename one of them
            "
        ));
    };
    second("a: Assembly(A)", "a");
    second("a: Bar(mass = 1.0_kg, length = 1.0_m)", "a");
    second("a: Param(1.0_kg)", "a");
    second("a: Input(1.0_N)", "a");
    second("a: Output(1.0)", "a");
    second("a: Let(2.0)", "a");
    second(
        "a: Each(0..2, |i| Particle(mass = 1.0_kg, free = true))",
        "a",
    );
    second("o: Each(0..2, |i| Output(1.0))", "o");
    second("o: Assembly(A)", "o");
}

#[test]
fn a_family_declared_twice_is_one_mistake() {
    refused(
        "
mechanism!(M {
    world: Planar(),
    p: Each(0..2, |i| Particle(mass = 1.0_kg, free = true)),
    p: Each(0..3, |i| Particle(mass = 1.0_kg, free = true)),
    ~ `p` is declared twice; rename one of them
});
        ",
    );
}

#[test]
fn entries_outside_are_not_seen() {
    refused(
        "
assembly!(A { world: Planar(), p: Particle(mass = outer, free = true), q: Particle(mass = Outer, free = true) });
                                                  ~~~~~ the assembly `A` has no entry or port `outer`
                                                                                          ~~~~~ the assembly `A` has no entry or port `Outer`
mechanism!(M { world: Planar(), outer: Param(1.0_kg), Outer: Param(1.0_kg), a: Assembly(A), m: Output(outer + Outer) });
        ",
    );
    // Words of the language are none of them.
    accepted(
        "
assembly!(A {
    world: Planar(),
    Upper: Param(1.0_kg),
    mass: Port(Number),
    curve: Table([0.0, 1.0], [1.0, 2.0], interpolation = Linear, beyond = Constant),
    p: Bar(mass = Upper + mass, length = 1.0_m, coordinates = Reference),
    joint: Revolute(ground.origin, p.a),
    f: Force(p.b, value = [curve(p.a.x) * 1.0_N, 0.0]),
});
mechanism!(M {
    world: Planar(),
    Linear: Param(1.0_kg),
    Reference: Let(2.0 * Linear),
    a: Assembly(A, mass = Reference),
    b: Each(0..2, |i| Assembly(A, mass = i * Linear)),
});
        ",
    );
}

#[test]
fn names_of_assemblies() {
    let named = |name: &str, message: &str| {
        let under = "~".repeat(name.len());
        refused(&format!(
            "
assembly!({name} {{ world: Planar(), p: Particle(mass = 1.0_kg, free = true) }});
          {under} {message}
            "
        ));
    };
    named(
        "f64",
        "`f64` is a type of Rust; choose another name for the assembly",
    );
    named(
        "CraneOutputs",
        "a mechanism `Crane` would have a type `CraneOutputs` beside its own; choose another name for this assembly",
    );
    named(
        "r#fn",
        "names are written without `r#`; choose another name",
    );
    named("gen", "`gen` is a word of Rust; choose another name");
}

#[test]
fn words_of_rust() {
    refused(
        "
mechanism!(gen { world: Planar(), gen: Particle(mass = 1.0_kg, free = true) });
           ~~~ `gen` is a word of Rust; choose another name
                                  ~~~ `gen` is a word of Rust; choose another name
        ",
    );
}

#[test]
fn members_that_depend_on_a_port() {
    accepted(
        "
assembly!(A {
    world: Planar(),
    n: Port(Number),
    size: Port(Number, default = 1.0_m),
    b: Each(0..3, |i| Particle(mass = if i < n { 1.0_kg } else { 2.0_kg }, at = [i * size, 0.0_m], free = true)),
    c: Each([n, 2], |k| Particle(mass = if k < 2 { 1.0_kg } else { k * 1.0_kg }, free = true)),
    d: Each([size, 2.0 * size], |x| Particle(mass = 1.0_kg, at = [x, 0.0_m], free = true)),
    e: Each(0..3, |n| Param(n * 1.0_kg)),
    f: Each(0..3, |i| Particle(mass = e[i], free = true)),
    g: Each(0..n, |i| Input(1.0_N)),
    h: Each(0..n, |i| Force(b[i].origin, value = [g[i], 0.0])),
});
mechanism!(M { world: Planar(), a: Assembly(A, n = 2), o: Output(a.b[2].origin.x) });
        ",
    );
    refused(
        "
assembly!(A { world: Planar(), m: Param(1.0_kg), p: Particle(mass = m, free = true) });
assembly!(B { world: Planar(), a: Assembly(A) });
assembly!(C {
    world: Planar(),
    n: Port(Number),
    size: Port(Number, default = 1.0_m),
    m: Each(0..n, |i| Param(1.0_kg)),
    ~ the members of `m` have parameters, which are fields of `C` and the same wherever it is used: they cannot depend on the port `n`; write numbers in its place
    b: Each((0..2, 0..n), |i, j| Assembly(B)),
    ~ the members of `b` have parameters, which are fields of `C` and the same wherever it is used: they cannot depend on the port `n`; write numbers in its place
    l: Each([size, 2.0 * size], |x| Param(x)),
             ~~~~ in `l[0]`: `size` is a port, whose value each use gives: the default of a parameter is a number; write one, or declare a port instead of a parameter
                         ~~~~ in `l[1]`: `size` is a port, whose value each use gives: the default of a parameter is a number; write one, or declare a port instead of a parameter
    k: Param(2.0 * size),
                   ~~~~ `size` is a port, whose value each use gives: the default of a parameter is a number; write one, or declare a port instead of a parameter
    f: Input(2.0 * size),
                   ~~~~ `size` is a port, whose value each use gives: the default of an input is a number; write one, or declare a port instead of an input
    a: Assembly(A, m = n * 2.0_kg),
                       ~ in `a.m`: `n` is a port, whose value each use gives: the default of a parameter is a number; write one, or declare a port instead of a parameter
});
        ",
    );
}

#[test]
fn parameters_given_in_other_units() {
    refused(
        "
assembly!(A {
    world: Planar(),
    length: Param(1.0_m),
    stiffness: Param(1.0, unit = N_per_m),
    p: Particle(mass = 1.0_kg, at = [length, stiffness * 1.0_m2_per_N], free = true),
});
assembly!(B { world: Planar(), a: Assembly(A, length = 2.0_s) });
                                                       ~~~~~ the parameter `length` of `A` is a length (m), but this is a time (s)
        ",
    );
    refused(
        "
assembly!(A {
    world: Planar(),
    length: Param(1.0_m),
    stiffness: Param(1.0, unit = N_per_m),
    p: Particle(mass = 1.0_kg, at = [length, stiffness * 1.0_m2_per_N], free = true),
});
mechanism!(M {
    world: Planar(),
    a: Assembly(A, length = 0.5_kg, stiffness = 2.0_N),
                            ~~~~~~ the parameter `length` of `A` is a length (m), but this is a mass (kg)
                                                ~~~~~ the parameter `stiffness` of `A` is a stiffness (N/m), but this is a force (N)
    b: Each(0..2, |i| Assembly(A, length = i * 0.5_N)),
                                           ~~~~~~~~~ in `b[0]`: the parameter `length` of `A` is a length (m), but this is a force (N) (and the same in another member)
});
        ",
    );
}

#[test]
fn indices_of_assemblies() {
    refused(
        "
assembly!(A { world: Planar(), p: Each(0..2, |i| Particle(mass = 1.0_kg, free = true)) });
mechanism!(M {
    world: Planar(),
    a: Each(0..2, |i| Assembly(A)),
    o: Output(a[2].p[0].origin.x),
              ~~~~ there is no `a[2]`; the members of `a` go from `a[0]` to `a[1]`
    q: Output(a.p[0].origin.x),
              ~ `a` is a family: name a member, `a[i]`, from `a[0]` to `a[1]`
    r: Output(a[-1].p[0].origin.x),
              ~~~~~ there is no `a[-1]`; the members of `a` go from `a[0]` to `a[1]`
    s: Output(a[0].p[2].origin.x),
              ~~~~~~~~~ there is no `a[0].p[2]`; the members of `a[0].p` go from `a[0].p[0]` to `a[0].p[1]`
    u: Output(a[0].p[0].origin[0]),
              ~~~~~~~~~~~~~~~~~~~ an index follows the name of a family, as in `crank[3].b`
});
        ",
    );
}

/// Where it is declared, also if nobody uses it.
#[test]
fn what_is_wrong_with_the_entries_of_an_assembly() {
    refused(
        "
fn friction(_: [f64; 3]) -> (f64, [f64; 3]) { (0.0, [0.0; 3]) }
assembly!(A {
    world: Spatial(),
    size: Port(Number, default = lenght),
                                 ~~~~~~ the assembly `A` has no entry or port `lenght`; did you mean `length`?
    length: Param(1.0_m),
    dry: Param(2.0),
    b: Body(mass = 1.0_kg, inertia = 1.0_kg_m2, at = [size, 0.0, length]),
    h: Revolute(ground, b, at = [0.0, 0.0, 0.0], axis = Z),
    s: TorsionSpring(h, law = friction(dri)),
                                       ~~~ the assembly `A` has no entry or port `dri`; did you mean `dry`?
    c: Each(0..2, |i| Particle(mass = j * 1.0_kg, free = true)),
                                      ~ the assembly `A` has no entry or port `j`
});
        ",
    );
    refused(
        "
assembly!(A {
    world: Spatial(),
    b: Body(mass = 1.0_kg, inertia = 1.0_kg_m2, foo = 3),
                                                ~~~ `Body` has no argument `foo` (arguments: mass, inertia, center_of_mass, at, orientation, velocity, angular_velocity, shape, coordinates, free)
    c: Each(0..2, |i| Particle(mass = i * 1.0_kg, foo = 3)),
                                                  ~~~ in `c[0]`: `Particle` has no argument `foo` (arguments: mass, at, velocity, position, free) (and the same in another member)
});
        ",
    );
}

#[test]
fn what_is_no_assembly() {
    refused(
        "
mechanism!(M { world: Planar(), a: Assembly(mechanism), b: Assembly(mbs_runtime::assembly), p: Particle(mass = 1.0_kg, free = true) });
                                            ~~~~~~~~~ expected the path of an assembly, as `assembly!` declares it
                                                                    ~~~~~~~~~~~~~~~~~~~~~ expected the path of an assembly, as `assembly!` declares it
        ",
    );
}

#[test]
fn a_family_of_two_assemblies() {
    refused(
        "
assembly!(A { world: Planar(), p: Particle(mass = 1.0_kg, free = true) });
assembly!(B { world: Planar(), p: Particle(mass = 1.0_kg, free = true) });
mechanism!(M { world: Planar(), a: Each(0..3, |i| if i == 1 { Assembly(A) } else { Assembly(B) }) });
                                                                       ~ a family of assemblies is an array in your program: its members are all of one assembly; make two families
        ",
    );
}

/// So that the program around a wrong declaration has no errors of its own.
#[test]
fn what_is_given_to_a_wrong_declaration_keeps_its_type() {
    let outputs = expanded(
        "
assembly!(A { world: Planar(), at: Port(Point), p: Particle(mass = 1.0_kg, free = true), o: Output(at) });
mechanism!(M { world: Planar(), place: Point([1.0_m, 2.0_m]), a: Assembly(A, at = place), q: Particle(mass = wrong, free = true) });
        ",
    );
    let code = outputs[1].to_string().replace(' ', "");
    assert!(
        code.contains("pubo:::mbs_runtime::nalgebra::SVector<f64,2usize>"),
        "{code}"
    );
}

/// The memory was full before anything was said.
#[test]
fn entries_of_which_there_are_too_many() {
    refused(
        "
assembly!(Row { world: Planar(), p: Each(0..10000, |i| Particle(mass = 1.0_kg, free = true)) });
mechanism!(Net { world: Planar(), row: Each(0..10000, |i| Assembly(Row)) });
                                  ~~~ with this assembly there are more than 100000 entries and assemblies; declare fewer
        ",
    );
}

/// The second struct of outputs had the name of the first one.
#[test]
fn assemblies_whose_names_begin_alike() {
    let text = expanded(
        "
assembly!(Corner { world: Planar(), p: Particle(mass = 1.0_kg, free = true), x: Output(p.origin.x) });
assembly!(Corner2 { world: Planar(), p: Particle(mass = 1.0_kg, free = true), y: Output(p.origin.y) });
mechanism!(Car { world: Planar(), rear: Assembly(Corner2), front: Assembly(Corner) });
        ",
    );
    let text: String = text.iter().map(ToString::to_string).collect();
    for name in ["CarOutputsOfCorner2", "CarOutputsOfCorner"] {
        let count = text.matches(&format!("struct {name} ")).count();
        assert_eq!(count, 1, "{name}");
    }
}

/// What is held is an initial value by itself; what would hold nothing is refused.
#[test]
fn ports_that_are_held() {
    accepted(
        "
assembly!(A {
    world: Planar(),
    angle: Port(Number, default = 0.0_deg),
    place: Port(Number, default = 0.0_m),
    rod: Each(0..2, |i| Bar(mass = 1.0_kg, length = 1.0_m, angle = angle)),
    hinge: Each(0..2, |i| Revolute(ground.point(1.0_m * i, 0.0), rod[i].a)),
    x: Each(0..2, |i| Coordinate(place)),
    block: Each(0..2, |i| Particle(mass = 1.0_kg, position = [x[i], 0.0_m])),
    double: Output(2.0 * angle),
});
mechanism!(M {
    world: Planar(),
    a: Assembly(A, angle = Exactly(0.3_rad), place = Exactly(0.1_m)),
    o: Output(a.rod[0].angle),
});
        ",
    );
    refused(
        "
assembly!(A {
    world: Planar(),
    rate: Port(Number, default = 0.0_rad_per_s),
    rod: Bar(mass = 1.0_kg, length = 1.0_m, rate = 2.0 * rate),
    hinge: Revolute(ground.origin, rod.a),
});
mechanism!(M {
    world: Planar(),
    a: Assembly(A, rate = Exactly(0.3_rad_per_s)),
                          ~~~~~~~~~~~~~~~~~~~~~~ no initial value of `A` is `rate` alone, and `Exactly(…)` would hold nothing: leave it out
    o: Output(a.rod.angle),
});
        ",
    );
}

/// What was given to it had no effect.
#[test]
fn a_port_that_nothing_names() {
    refused(
        "
assembly!(A {
    world: Planar(),
    p: Port(Point),
    n: Port(Number),
    ~ nothing in the assembly `A` names its port `n`, so that what it is given would be ignored; use it or remove it
    b: Bar(mass = 1.0_kg, length = 1.0_m),
    j: Revolute(p, b.a),
});
        ",
    );
    // By another port, for an assembly inside, as a table, in a range.
    accepted(
        "
assembly!(Inner { world: Planar(), place: Port(Vector), free: Particle(mass = 1.0_kg, position = place, free = true) });
assembly!(A {
    world: Planar(),
    n: Port(Number),
    double: Port(Number, default = 2.0 * n),
    p: Port(Vector),
    curve: Port(Table),
    law: Port(Table),
    count: Port(Number),
    inner: Assembly(Inner, place = p),
    out: Output(curve(double)),
    pull: SpringDamper(ground.origin, inner.free.origin, law = law, length = 1.0_m),
    outs: Each(0..count, |i| Output(1.0 * i)),
});
        ",
    );
}

#[test]
fn a_member_of_a_family_of_assemblies_alone() {
    let inner = "assembly!(B { world: Planar(), p: Port(Point), b: Bar(mass = 1.0_kg, length = 1.0_m), j: Revolute(p, b.a) });";
    refused(&format!(
        "
{inner}
mechanism!(M {{
    world: Planar(),
    a: Each(0..2, |i| Assembly(B, p = ground.origin)),
    c: Bar(mass = 1.0_kg, length = 1.0_m),
    k: Revolute(a[1], c.a),
                ~~~~ `a[1]` is an assembly; name one of its entries, as in `a[1].b`
    l: Output(a[0]),
              ~~~~ `a[0]` is an assembly; name one of its entries, as in `a[0].b`
    m: Output(a[2]),
              ~~~~ there is no `a[2]`; the members of `a` go from `a[0]` to `a[1]`
}});
        "
    ));
    refused(&format!(
        "
{inner}
assembly!(C {{
    world: Planar(),
    b: Each(0..2, |i| Assembly(B, p = ground.origin)),
    o: Output(b[0]),
              ~~~~ in `c.o`: `c.b[0]` is an assembly; name one of its entries, as in `c.b[0].b`
}});
mechanism!(M {{
    world: Planar(),
    c: Assembly(C),
}});
        "
    ));
}
