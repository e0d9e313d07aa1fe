//! Declared velocities in space that the joints do not allow: the nearest ones that they do, the same in all coordinates.

use mbs_runtime::{Mechanism, Simulation, System, mechanism};

/// The outputs of a mechanism at the start.
fn start<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    mechanism: impl Mechanism<System = S>,
) -> Vec<f64> {
    let simulation = Simulation::new(mechanism).expect("it assembles");
    simulation.output_values().to_vec()
}

fn near(found: &[f64], wanted: &[f64]) {
    assert_eq!(found.len(), wanted.len());
    let gaps = found.iter().zip(wanted).map(|(a, b)| (a - b).abs());
    assert!(gaps.fold(0.0, f64::max) < 1e-11, "{found:?}, {wanted:?}");
}

/// A declaration in all coordinates, whose starts are compared; outputs that are all zero compare nothing.
macro_rules! starts {
    ($test:ident, $($entries:tt)*) => {
        mod $test {
            use super::{mechanism, near, start};
            mechanism!(ByPoints { world: Spatial(coordinates = Natural), $($entries)* });
            mechanism!(ByBodies { world: Spatial(coordinates = Reference), $($entries)* });
            mechanism!(ByJoints { world: Spatial(coordinates = Joint), $($entries)* });

            #[test]
            fn starts_alike() {
                let wanted = start(ByBodies::default());
                assert!(wanted.iter().any(|x| x.abs() > 0.1), "{wanted:?}");
                near(&start(ByPoints::default()), &wanted);
                near(&start(ByJoints::default()), &wanted);
            }
        }
    };
}

starts!(revolute,
    speed: Param(2.0_m_per_s),
    arm: Body(mass = 2.0_kg, inertia = diag(0.1, 0.2, 0.3), at = [0.5, 0.0, 0.2], velocity = [0.3, speed, -0.5], center_of_mass = [0.1, 0.0, 0.05]),
    pivot: Revolute(ground, arm, at = [0.1, 0.0, 0.0], axis = [0.0, 0.3, 1.0]),
    velocity: Output(arm.velocity),
    spin: Output(arm.angular_velocity),
);

starts!(revolute_backwards,
    arm: Body(mass = 2.0_kg, inertia = diag(0.1, 0.2, 0.3), at = [0.5, 0.0, 0.2], velocity = [0.3, 2.0_m_per_s, -0.5]),
    pivot: Revolute(arm, ground, at = [0.1, 0.0, 0.0], axis = [0.0, 0.3, 1.0]),
    velocity: Output(arm.velocity),
    spin: Output(arm.angular_velocity),
);

starts!(spherical,
    arm: Body(mass = 2.0_kg, inertia = diag(0.1, 0.2, 0.3), at = [0.5, 0.1, 0.2], orientation = turn([1.0, 2.0, 0.5], 0.7), velocity = [0.3, 2.0_m_per_s, -0.5]),
    pivot: Spherical(ground, arm, at = [0.1, 0.0, 0.0]),
    velocity: Output(arm.velocity),
    spin: Output(arm.angular_velocity),
);

starts!(universal,
    arm: Body(mass = 2.0_kg, inertia = diag(0.1, 0.2, 0.3), at = [0.5, 0.1, 0.2], orientation = turn([1.0, 2.0, 0.5], 0.7), velocity = [0.3, 2.0_m_per_s, -0.5]),
    cross: Universal(arm, ground, at = [0.1, 0.0, 0.0], axis = [1.0, 1.0, 0.0], second_axis = [1.0, -1.0, 0.5]),
    velocity: Output(arm.velocity),
    spin: Output(arm.angular_velocity),
);

starts!(cylindrical,
    sleeve: Body(mass = 2.0_kg, inertia = diag(0.1, 0.2, 0.3), at = [0.5, 0.1, 0.2], velocity = [0.3, 2.0_m_per_s, -0.5]),
    guide: Cylindrical(ground, sleeve, at = [0.1, 0.0, 0.0], axis = [0.0, 0.3, 1.0]),
    velocity: Output(sleeve.velocity),
    spin: Output(sleeve.angular_velocity),
);

starts!(prismatic,
    sleeve: Body(mass = 2.0_kg, inertia = diag(0.1, 0.2, 0.3), at = [0.5, 0.1, 0.2], velocity = [0.3, 2.0_m_per_s, 1.5]),
    guide: Prismatic(ground, sleeve, at = [0.1, 0.0, 0.0], axis = [0.0, 0.3, 1.0]),
    velocity: Output(sleeve.velocity),
);

starts!(chain_with_the_last_one_moving,
    upper: Body(mass = 2.0_kg, inertia = diag(0.1, 0.2, 0.3), at = [0.5, 0.0, 0.2]),
    lower: Body(mass = 1.0_kg, inertia = diag(0.1, 0.1, 0.05), at = [1.0, 0.2, 0.0], orientation = turn([1.0, 2.0, 0.5], 0.7), velocity = [0.3, 2.0_m_per_s, -0.5]),
    shoulder: Revolute(ground, upper, at = [0.1, 0.0, 0.0], axis = [0.0, 0.3, 1.0]),
    elbow: Universal(upper, lower, at = [0.7, 0.1, 0.0], axis = X, second_axis = Y),
    velocity: Output(lower.velocity),
    spin: Output(lower.angular_velocity),
    first: Output(upper.angular_velocity),
);

starts!(chain_with_the_first_one_moving,
    upper: Body(mass = 2.0_kg, inertia = diag(0.1, 0.2, 0.3), at = [0.5, 0.0, 0.2], velocity = [0.3, 2.0_m_per_s, -0.5]),
    lower: Body(mass = 1.0_kg, inertia = diag(0.1, 0.1, 0.05), at = [1.0, 0.2, 0.0]),
    shoulder: Spherical(ground.point(0.1, 0.0, 0.0), upper.point(-0.4, 0.0, -0.2)),
    elbow: Cylindrical(upper, lower, at = [0.7, 0.1, 0.0], axis = [0.2, 1.0, 0.0]),
    velocity: Output(lower.velocity),
    spin: Output(lower.angular_velocity),
    first: Output(upper.angular_velocity),
);

starts!(free_root_that_carries,
    trunk: Body(mass = 2.0_kg, inertia = diag(0.1, 0.2, 0.3), at = [0.5, 0.0, 0.2], orientation = turn([1.0, 2.0, 0.5], 0.4), velocity = [0.3, 2.0_m_per_s, -0.5]),
    arm: Body(mass = 1.0_kg, inertia = diag(0.1, 0.1, 0.05), at = [1.0, 0.2, 0.0], velocity = [1.0_m_per_s, 0.0, 0.7]),
    elbow: Revolute(trunk, arm, at = [0.7, 0.1, 0.0], axis = [0.2, 1.0, 0.0]),
    velocity: Output(arm.velocity),
    spin: Output(arm.angular_velocity),
    first: Output(trunk.angular_velocity),
);

starts!(loop_that_a_rod_closes,
    left: Body(mass = 2.0_kg, inertia = diag(0.1, 0.2, 0.3), at = [0.0, 0.0, 0.5], velocity = [1.0_m_per_s, 0.0, 0.0]),
    right: Body(mass = 1.0_kg, inertia = diag(0.1, 0.1, 0.05), at = [1.0, 0.0, 0.5]),
    foot: Revolute(ground, left, at = [0.0, 0.0, 0.0], axis = Y),
    heel: Spherical(ground.point(1.0, 0.0, 0.0), right.point(0.0, 0.0, -0.5)),
    link: Distance(left.point(0.0, 0.0, 0.2), right.point(0.0, 0.0, 0.2), length = 1.0_m),
    velocity: Output(left.velocity),
    spin: Output(right.angular_velocity),
);
