//! Entries that are not written as entries are, and where this is said.

use crate::common::expansion::refused;

#[test]
fn attributes_inside_an_entry() {
    refused(
        "
mechanism!(M {
    world: Planar(),
    p: Particle(#[cfg(any())] mass = 1.0_kg, free = true),
                ~~~~~~~~~~~~~ no documentation and no attributes stand inside an entry; leave this out
    q: Particle(mass = 1.0_kg, free = #[foo] true),
                                      ~~~~~~ no documentation and no attributes stand inside an entry; leave this out
});
        ",
    );
}

#[test]
fn closures_with_more_than_parameters() {
    refused(
        "
mechanism!(M {
    world: Planar(),
    p: Each(0..2, async move |i| -> u8 { Particle(mass = 1.0_kg, free = true) }),
                  ~~~~~~~~~~~~~~~~~~~~ the closure of a family has parameters and what each member is, as in `|i| Kind(…)`; leave this out
    q: Each((0..2, 0..2), |i, i| Particle(mass = i * 1.0_kg, free = true)),
                              ~ this closure has two parameters `i`; rename one of them
    r: Each([(1.0_kg, 2.0_kg)], |(a, a)| Particle(mass = a, free = true)),
                                     ~ this closure has two parameters `a`; rename one of them
});
        ",
    );
}

#[test]
fn entries_that_end_too_early() {
    refused(
        "
mechanism!(M {
    world: Planar(),
    p: Particle(mass = 1.0_kg, free = true) +,
                                            ~ unexpected end of input, expected an expression
    q: Particle(mass = 1.0_kg, free = true).,
                                           ~ unexpected end of input, expected identifier or integer
    r: -,
       ~ unexpected end of input, expected an expression
    s: if,
        ~ unexpected end of input, expected an expression
    /// What follows.
    ~~~~~~~~~~~~~~~~~ documentation stands before its entry, and nothing follows here
});
        ",
    );
}

#[test]
fn arguments_after_a_colon() {
    refused(
        "
mechanism!(M {
    world: Planar(),
    p: Particle(mass: 1.0_kg, free: true),
                    ~ arguments are given by `=`, as in `mass = …`
    // A path has two colons.
    q: Particle(mass = law(crate::mass::of, t), free = true),
});
        ",
    );
}

#[test]
fn a_wrong_world_is_one_mistake() {
    refused(
        "
mechanism!(M {
    /// The plane.
    world: Planar,
           ~~~~~~ expected `world: Kind(…)`, for example `world: Planar()`
    p: Particle(mass = 1.0_kg, free = true),
});
        ",
    );
}

#[test]
fn ports_in_families() {
    refused(
        "
assembly!(A { world: Planar(), q: Each(0..2, |i| Port(Number)), p: Particle(mass = 1.0_kg, free = true) });
                                                 ~~~~ in `q[0]`: a port is no member of a family; give each port of an assembly a name of its own (and the same in another member)
        ",
    );
}

#[test]
fn public_entries() {
    refused(
        "
mechanism!(M {
    world: Planar(),
    pub m: Param(1.0_kg),
    ~~~ what an entry gives is public anyway; leave `pub` out
    pub(crate) n: Param(1.0_kg),
    ~~~ what an entry gives is public anyway; leave `pub` out
    p: Particle(mass = 1.0_kg, free = true),
});
        ",
    );
}
