//! Poses in space given by others: points, parts, quaternions and axes; and laws with parameters.

use mbs_runtime::nalgebra::Vector3;
use mbs_runtime::{Simulation, mechanism};

/// 3 N/m and 1 N s/m.
fn fixed_pull([length, rate]: [f64; 2]) -> (f64, [f64; 2]) {
    (3.0 * length + rate, [3.0, 1.0])
}

fn pull([length, rate, k, c]: [f64; 4]) -> (f64, [f64; 4]) {
    (k * length + c * rate, [k, c, length, rate])
}

mechanism!(Poses {
    world: Spatial(),
    stiffness: Param(3.0_N_per_m),
    turned: Body(
        mass = 1.0_kg,
        inertia = 1.0_kg_m2,
        at = [1.0, 2.0, 3.0],
        orientation = turn([1.0, 2.0, 2.0], 0.7)
    ),
    same: Body(
        mass = 1.0_kg,
        inertia = 1.0_kg_m2,
        at = turned.point(1.0, 0.0, 0.0),
        orientation = quaternion(
            6.0 * cos(0.35),
            2.0 * sin(0.35),
            4.0 * sin(0.35),
            4.0 * sin(0.35)
        )
    ),
    hinge: Revolute(turned, same, at = same.origin, axis = Z),
    upright: Body(
        mass = 1.0_kg,
        inertia = 1.0_kg_m2,
        orientation = axes([3.0, 0.0, 4.0], Y)
    ),
    further: Body(
        mass = 1.0_kg,
        inertia = 1.0_kg_m2,
        orientation = [upright, turn(X, 0.2)]
    ),
    first: SpringDamper(
        upright.origin,
        ground.point(1.0, 1.0, 1.0),
        law = fixed_pull
    ),
    second: SpringDamper(
        further.origin,
        ground.point(1.0, 1.0, 1.0),
        law = pull(stiffness, 1.0_N_s_per_m)
    ),
    held: SpringDamper(turned.origin, ground.origin, stiffness = 1.0_N_per_m),
    x: Output(turned.x - same.x),
    y: Output(turned.y - same.y),
    place: Output(same.origin - turned.origin - 1.0_m * turned.x),
    along: Output(upright.x),
    across: Output(upright.y),
    turn: Output(dot(upright.y, further.y)),
    lead: Output(upright.origin - further.origin),
    fallen: Output(upright.origin),
});

fn vector(components: [f64; 3]) -> Vector3<f64> {
    components.into()
}

#[test]
fn poses_are_those_of_others() {
    let mut simulation = Simulation::new(Poses::default()).expect("it assembles");
    let outputs = simulation.outputs();
    for gap in [outputs.x, outputs.y, outputs.place] {
        assert!(gap.norm() < 1e-15, "{gap}");
    }
    assert!((outputs.along - vector([0.6, 0.0, 0.8])).norm() < 1e-15);
    assert!((outputs.across - vector([0.0, 1.0, 0.0])).norm() < 1e-15);
    assert!((outputs.turn - f64::cos(0.2)).abs() < 1e-15);
    // The law with parameters pulls as that without.
    simulation.run_until(0.5).expect("it runs");
    assert!(simulation.outputs().fallen.x > 0.1);
    assert!(simulation.outputs().lead.norm() < 1e-12);
}
