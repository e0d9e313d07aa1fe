//! What is wrong with assemblies, and with their uses.

use crate::common::expansion::{accepted, refused};

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
                                                  ~~~~~ in `a.p`: the assembly `A` has no entry or port `outer`
                                                                                          ~~~~~ in `a.q`: the assembly `A` has no entry or port `Outer`
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
