//! Parts whose place is an expression of coordinates, or of another part.

use mbs_runtime::{Mechanism, Simulation, System, mechanism};

mechanism!(Bead {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    turn: Coordinate(0.0_rad),
    bead: Particle(
        mass = 1.0_kg,
        position = [0.5_m * cos(turn), 0.5_m * sin(turn), 0.2_m * turn]
    ),
});

mechanism!(Lift {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    turn: Coordinate(0.0_rad),
    height: Coordinate(1.0_m),
    load: Particle(
        mass = 2.0_kg,
        position = [0.5_m * cos(turn), 0.5_m * sin(turn), height]
    ),
});

fn accelerations<M, S, const Q: usize, const N: usize, const R: usize>(mechanism: M) -> Vec<f64>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let simulation = Simulation::new(mechanism).expect("it assembles");
    let dynamics = simulation.dynamics().expect("it has a mass");
    dynamics.accelerations().as_slice().to_vec()
}

/// The mass of the third direction was left out: m R² in place of m (R² + c²), and nothing along the height.
#[test]
fn a_point_on_a_helix() {
    let [turn] = accelerations(Bead::default())[..] else {
        panic!("one coordinate");
    };
    let right = -9.81 * 0.2 / (0.5 * 0.5 + 0.2 * 0.2);
    assert!((turn - right).abs() < 1e-12, "{turn} for {right}");
    let lift = Simulation::new(Lift::default()).expect("it assembles");
    let dynamics = lift.dynamics().expect("it has a mass");
    let mass = dynamics.mass_matrix();
    assert!((mass[(0, 0)] - 0.5).abs() < 1e-15 && (mass[(1, 1)] - 2.0).abs() < 1e-15);
    assert_eq!(mass[(0, 1)], 0.0);
}

macro_rules! carried {
    ($name:ident, $coordinates:ident) => {
        mechanism!($name {
            world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = $coordinates),
            arm: Body(mass = 1.0_kg, inertia = 0.1_kg_m2, at = [0.5_m, 0.0]),
            pivot: Revolute(ground.origin, arm.point(-0.5_m, 0.0)),
            load: Particle(mass = 5.0_kg, position = arm.point(0.5_m, 0.0)),
            slid: Coordinate(0.1_m, rate = 0.3_m_per_s),
            rider: Particle(mass = 2.0_kg, position = arm.origin + slid * arm.x),
            angular: Output(pivot.rate),
            far: Output(load.origin),
            near: Output(rider.origin),
        });
    };
}
carried!(ByJoints, Joint);
carried!(ByBodies, Reference);

mechanism!(Load {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Joint),
    arm: Body(mass = 1.0_kg, inertia = 0.1_kg_m2, at = [0.5_m, 0.0]),
    pivot: Revolute(ground.origin, arm.point(-0.5_m, 0.0)),
    load: Particle(mass = 5.0_kg, position = arm.point(0.5_m, 0.0)),
});

/// In joint coordinates the load had a weight and no mass.
#[test]
fn what_follows_a_part_has_its_mass() {
    let [turn] = accelerations(Load::default())[..] else {
        panic!("one coordinate");
    };
    let right = -9.81 * (0.5 + 5.0) / (0.1 + 0.25 + 5.0);
    assert!((turn - right).abs() < 1e-12, "{turn} for {right}");
    let mut joints = Simulation::with_accuracy(ByJoints::default(), 1e-9).expect("it assembles");
    let mut bodies = Simulation::with_accuracy(ByBodies::default(), 1e-9).expect("it assembles");
    joints.run_until(1.0).expect("it runs");
    bodies.run_until(1.0).expect("it runs");
    let (joints, bodies) = (joints.output_values(), bodies.output_values());
    for (one, other) in joints.iter().zip(&bodies) {
        assert!((one - other).abs() < 1e-6, "{joints:?} {bodies:?}");
    }
}

macro_rules! plate {
    ($name:ident, $coordinates:ident, $($load:tt)*) => {
        mechanism!($name {
            world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2], coordinates = $coordinates),
            plate: Body(
                mass = 1.0_kg,
                inertia = diag(0.1, 0.2, 0.25),
                at = [0.2_m, 0.0, 0.0],
                angular_velocity = [1.0_rad_per_s, 2.0, 3.0]
            ),
            ball: Spherical(ground, plate, at = [0.0, 0.0, 0.0]),
            $($load)*
        });
    };
}
plate!(
    Plate,
    Joint,
    load: Particle(mass = 2.0_kg, position = plate.point(0.1_m, 0.2_m, 0.0_m)),
);
plate!(
    LoadedPlate,
    Reference,
    load: Body(
        mass = 2.0_kg,
        inertia = diag(1e-9, 1e-9, 1e-9),
        at = [0.3_m, 0.2, 0.0],
        angular_velocity = [1.0_rad_per_s, 2.0, 3.0]
    ),
    weld: Fixed(plate, load, at = [0.3_m, 0.2, 0.0]),
);

/// The force in the ball joint is that of both masses, and there is no torque in it.
#[test]
fn reactions_of_a_part_that_carries_another() {
    let carried = Simulation::new(Plate::default()).expect("it assembles");
    let welded = Simulation::new(LoadedPlate::default()).expect("it assembles");
    for component in ["fx", "fy", "fz"] {
        let one = carried.reaction("ball", component).expect("a reaction");
        let other = welded.reaction("ball", component).expect("a reaction");
        assert!((one - other).abs() < 1e-6, "{component}: {one} {other}");
    }
}
