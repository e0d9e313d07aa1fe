//! Entries that are not written as entries are, and where this is said.

use crate::common::expansion::{accepted, expanded, refused};

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

/// The argument was accepted, and nothing was read: a mechanism without gravity, and outputs and events that did not exist.
#[test]
fn the_value_by_its_name() {
    let [named, plain] = ["value = ", ""].map(|name| {
        let output = expanded(&format!(
            "
mechanism!(M {{
    world: Planar(gravity = g),
    g: Let({name}[0.0, -9.81_m_per_s2]),
    masses: Param({name}[1.0_kg, 2.0_kg]),
    p: Particle(mass = masses[0], free = true),
    q: Particle(mass = masses[1], free = true),
    o: Output({name}p.origin.x),
    e: Event({name}q.origin.y),
}});
            "
        ));
        output.iter().map(ToString::to_string).collect::<String>()
    });
    // The declaration itself is part of what is generated.
    assert_eq!(named.replace("value = ", ""), plain);
}

#[test]
fn what_goes_with_a_drive() {
    refused(
        "
mechanism!(M {
    world: Planar(),
    bar: Bar(mass = 1.0_kg, length = 1.0_m),
    pin: Revolute(ground.origin, bar.a),
    turn: Drive(bar.angle, value = 1.0_rad, since = nothing * 3.0_kg),
                                                    ~~~~~~~~~~~~~~~~ `since =` is the time of `rate =` and `acceleration =`; give one of them, or leave it out
});
        ",
    );
}

/// The unit was dropped: `powi(200_cm)` was a square.
#[test]
fn an_exponent_with_a_unit() {
    refused(
        "
mechanism!(M {
    world: Planar(),
    p: Particle(mass = 1.0_kg, free = true),
    o: Output((p.origin.x / 1.0_m).powi(2_m)),
                                        ~~~ an exponent is a number without unit, but this is a length (m)
});
        ",
    );
}

/// `powi(2.5)` was `powf(2.5)`.
#[test]
fn a_fraction_as_a_whole_exponent() {
    refused(
        "
mechanism!(M {
    world: Planar(),
    p: Particle(mass = 1.0_kg, free = true),
    o: Output((p.origin.x / 1.0_m).powi(2.5)),
                                        ~~~ `powi` takes a whole number; write `powf(2.5)`
    w: Output((p.origin.x / 1.0_m).powi(4.0 / 2.0) + (p.origin.x / 1.0_m).powf(2.5)),
});
        ",
    );
}

#[test]
fn a_constant_of_rust_alone() {
    refused(
        "
mechanism!(M {
    world: Planar(),
    m: Param(crate::MASS),
             ~~~~~~~~~~~ the compiler does not know the value of this constant: give about its value, with its unit, as in `Param(crate::MASS, nominal = 1.0_kg)`
    p: Particle(mass = m, free = true),
});
        ",
    );
}

/// Its text was left out.
#[test]
fn documentation_that_is_no_text() {
    refused(
        "
mechanism!(M {
    world: Planar(),
    #[doc = include_str!(\"p.md\")]
            ~~~~~~~~~~~~~~~~~~~~ expected a text in quotes: documentation is read where the declaration is
    p: Particle(mass = 1.0_kg, free = true),
});
        ",
    );
}

/// A joint of space has the name of a world.
#[test]
fn partners_of_a_planar_joint_by_name() {
    accepted(
        "
mechanism!(M {
    world: Spatial(),
    puck: Body(mass = 1.0_kg, inertia = diag(0.1, 0.1, 0.1), at = [0.0, 0.0, 0.0]),
    slide: Planar(parent = ground, child = puck, at = [0.0, 0.0, 0.0], axis = Z),
});
        ",
    );
}

/// Written out, the formula of `a40` has some 10¹² terms.
#[test]
fn a_formula_that_is_exponentially_long() {
    let chain = (1..=40).map(|i| format!("a{i}: Let(tanh(a{0}) + sqrt(a{0})),\n", i - 1));
    let chain: String = chain.collect();
    accepted(&format!(
        "
mechanism!(M {{
    world: Planar(),
    a0: Param(0.5),
    {chain}
    arm: Bar(mass = 1.0_kg, length = 1.0_m),
    pin: Revolute(ground.origin, arm.a),
    push: Force(arm.point(a40 * 0.1_m, 0.0), value = [a40 * 1.0_N, 0.0]),
    other: Force(arm.point(a39 * 0.1_m, 0.0), value = [a40 * 1.0_N, 0.0]),
}});
        "
    ));
}

/// Both would have a type `PendulumFixedStepSimulation`.
#[test]
fn a_name_that_ends_like_a_type() {
    refused(
        "
mechanism!(PendulumFixedStep {
           ~~~~~~~~~~~~~~~~~ a mechanism `Pendulum` would have a type `PendulumFixedStepSimulation`, as a mechanism `PendulumFixedStep` has; choose another name for this mechanism
    world: Planar(),
    p: Particle(mass = 1.0_kg, free = true),
});
        ",
    );
}
