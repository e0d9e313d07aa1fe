//! Every initial value that may be held, in the plane and in space.

use super::near;
use mbs_runtime::{Simulation, mechanism};

mechanism!(Rig {
    doc: "Every initial value of the plane.",
    world: Planar(),
    spread: Coordinate(Exactly(0.3_m), rate = Exactly(0.2_m_per_s)),
    turn: Coordinate(Exactly(0.3_rad), rate = Exactly(0.2_rad_per_s)),
    follower: Body(
        mass = 1.0_kg,
        inertia = 0.1_kg_m2,
        frame = Frame([spread, 0.0], turn)
    ),
    rod: Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        from = Exactly([1.0, 2.0]),
        to = [1.8_m, 2.7],
        free = true
    ),
    beam: Bar(
        mass = 1.0_kg,
        from = [3.0_m, 0.0],
        to = Exactly([4.0_m, 1.0]),
        free = true
    ),
    slab: Body(
        mass = 1.0_kg,
        inertia = 0.1_kg_m2,
        center_of_mass = [0.1_m, 0.2],
        at = Exactly([5.0_m, 1.0]),
        angle = Exactly(1.0_rad),
        velocity = Exactly([1.0_m_per_s, 2.0]),
        rate = Exactly(3.0_rad_per_s),
        free = true,
    ),
    bob: Particle(
        mass = 1.0_kg,
        at = Exactly([7.0_m, 8.0]),
        velocity = Exactly([1.0_m_per_s, 0.5]),
        free = true,
    ),
    values: Output(spread),
    turned: Output(turn),
    rod_end: Output(rod.a),
    beam_end: Output(beam.b),
    slab_place: Output(slab.origin),
    slab_velocity: Output(slab.velocity),
    slab_rate: Output(slab.rate),
    bob_place: Output(bob.origin),
    bob_velocity: Output(bob.velocity),
});

#[test]
fn every_initial_value_of_the_plane_may_be_held() -> Result<(), Box<dyn std::error::Error>> {
    let rig = Simulation::new(Rig::default())?;
    let found = rig.output_values();
    let wanted = [
        0.3, 0.3, 1.0, 2.0, 4.0, 1.0, 5.0, 1.0, 1.0, 2.0, 3.0, 7.0, 8.0, 1.0, 0.5,
    ];
    assert_eq!(found.len(), wanted.len());
    found
        .iter()
        .zip(wanted)
        .for_each(|(found, wanted)| near(*found, wanted));
    Ok(())
}

mechanism!(SpaceRig {
    doc: "Every initial value of space.",
    world: Spatial(),
    slab: Body(
        mass = 1.0_kg,
        inertia = diag(0.1, 0.2, 0.25),
        center_of_mass = [0.1_m, 0.2, 0.3],
        at = Exactly([5.0_m, 1.0, 2.0]),
        orientation = turn(X, 30.0_deg),
        velocity = Exactly([1.0_m_per_s, 2.0, 3.0]),
        angular_velocity = Exactly([0.3_rad_per_s, 0.2, 0.1]),
        free = true,
    ),
    rod: Bar(
        mass = 1.0_kg,
        from = Exactly([0.0_m, 1.0, 0.0]),
        to = Exactly([1.0_m, 1.0, 0.0]),
        free = true,
    ),
    bob: Particle(
        mass = 1.0_kg,
        at = Exactly([7.0_m, 8.0, 9.0]),
        velocity = Exactly([1.0_m_per_s, 0.5, 0.2]),
        free = true,
    ),
    slab_place: Output(slab.origin),
    slab_velocity: Output(slab.velocity),
    slab_spin: Output(slab.angular_velocity),
    rod_end: Output(rod.b),
    bob_place: Output(bob.origin),
    bob_velocity: Output(bob.velocity),
});

#[test]
fn every_initial_value_of_space_may_be_held() -> Result<(), Box<dyn std::error::Error>> {
    let rig = Simulation::new(SpaceRig::default())?;
    let found = rig.output_values();
    let wanted = [
        5.0, 1.0, 2.0, 1.0, 2.0, 3.0, 0.3, 0.2, 0.1, 1.0, 1.0, 0.0, 7.0, 8.0, 9.0, 1.0, 0.5, 0.2,
    ];
    assert_eq!(found.len(), wanted.len());
    found
        .iter()
        .zip(wanted)
        .for_each(|(found, wanted)| near(*found, wanted));
    Ok(())
}
