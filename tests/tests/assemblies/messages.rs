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
