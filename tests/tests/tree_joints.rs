//! Joints that become coordinates: the same motion and the same reactions as by rows, whichever partner is declared first.

use mbs_runtime::{Mechanism, Model, Settings, Simulation, System, mechanism};

/// A declaration by bodies and by joints.
macro_rules! both {
    ($name:ident, $world:ident($($gravity:tt)*), $($entries:tt)*) => {
        mod rows {
            use super::mechanism;
            mechanism!($name { world: $world($($gravity)*, coordinates = Reference), $($entries)* });
        }
        mod joints {
            use super::mechanism;
            mechanism!($name { world: $world($($gravity)*, coordinates = Joint), $($entries)* });
        }
    };
}

/// Outputs and reactions, each with its name, at `until`.
fn run<M, S, const Q: usize, const N: usize, const R: usize>(
    step: f64,
    until: f64,
) -> Vec<(String, f64)>
where
    M: Mechanism<System = S> + Default,
    S: System<Q, N, R>,
{
    let settings = Settings {
        step,
        ..Settings::default()
    };
    let mut simulation =
        Simulation::<S, Q, N, R>::with_settings(M::default(), settings).expect("it assembles");
    simulation.run_until(until).expect("it runs");
    let mut values = Vec::new();
    for output in M::MODEL.outputs {
        let value = simulation.output(output.name).expect("it is an output");
        values.push((output.name.to_owned(), value));
    }
    for reaction in M::MODEL.reactions {
        let (joint, component) = (reaction.joint, reaction.component);
        let value = simulation.reaction(joint, component).expect("it is there");
        values.push((format!("{joint}.{component}"), value));
    }
    values.sort_by(|a, b| a.0.cmp(&b.0));
    values
}

/// Both descriptions approach each other with second order, in outputs and reactions.
fn agree(runs: [&dyn Fn(f64) -> Vec<(String, f64)>; 2], step: f64, tolerance: f64) {
    let gaps = [step, 0.5 * step].map(|step| {
        let [a, b] = runs.map(|run| run(step));
        assert!(!a.is_empty());
        let mut worst: f64 = 0.0;
        for ((first, x), (second, y)) in a.iter().zip(&b) {
            assert_eq!(first, second, "the same names");
            worst = worst.max((x - y).abs() / (1.0 + x.abs()));
        }
        assert_eq!(a.len(), b.len());
        worst
    });
    println!("{gaps:?}");
    assert!(gaps[1] < tolerance, "{gaps:?}");
    assert!(gaps[1] < 0.35 * gaps[0] || gaps[0] < 1e-9, "{gaps:?}");
}

fn size(model: &Model) -> (usize, usize, usize) {
    let (coordinates, velocities) = (model.coordinates.len(), model.velocities.len());
    (coordinates, velocities, model.rows.len())
}

mod slides {
    use super::{mechanism, *};

    both!(Slides, Planar(gravity = [0.0, -9.81_m_per_s2]),
        cart: Body(mass = 2.0_kg, inertia = 0.3_kg_m2, at = [0.4, 0.3], angle = -90.0_deg, center_of_mass = [0.02, 0.05]),
        arm: Body(mass = 1.0_kg, inertia = 0.1_kg_m2, center_of_mass = [0.3, 0.1], angle = 0.0_deg, rate = 2.0_rad_per_s),
        ram: Body(mass = 0.5_kg, inertia = 0.02_kg_m2, center_of_mass = [0.1, -0.1], at = [0.66, 0.38], angle = 30.0_deg,
            velocity = [-0.16_m_per_s, 0.32], rate = 2.0_rad_per_s),
        load: Body(mass = 0.3_kg, inertia = 0.01_kg_m2, center_of_mass = [0.05, 0.1], angle = 30.0_deg + 0.4, rate = 2.0_rad_per_s),
        slide: Prismatic(cart.origin, ground.origin, axis = [-0.6, 0.8], angle = 90.0_deg),
        pin: Revolute(cart.point(0.0, 0.1), arm.origin),
        guide: Prismatic(arm.point(0.1, 0.0), ram.origin, axis = [0.6, 0.8], angle = 30.0_deg),
        weld: Fixed(ram.point(0.1, 0.1), load.origin, angle = 0.4),
        spring: SpringDamper(arm.point(0.1, 0.0), ram.origin, stiffness = 90.0_N_per_m, length = 0.1_m),
        tip: Output(load.point(0.2, 0.3)),
        heading: Output(load.angle),
    );

    #[test]
    fn plane_slides_and_welds() {
        assert_eq!(size(joints::Slides::MODEL), (3, 3, 0));
        agree(
            [&|h| run::<rows::Slides, _, _, _, _>(h, 0.4), &|h| {
                run::<joints::Slides, _, _, _, _>(h, 0.4)
            }],
            2e-3,
            1e-3,
        );
    }
}

mod crosses {
    use super::{mechanism, *};

    both!(Crosses, Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
        rod: Body(mass = 1.0_kg, inertia = diag(0.1, 0.2, 0.25), at = [0.3, 0.2, 0.1], center_of_mass = [0.1, 0.2, -0.3]),
        bob: Body(mass = 0.5_kg, inertia = diag(0.02, 0.03, 0.025), at = [0.6, 0.2, 0.0], orientation = turn([1.0, 2.0, 0.5], 0.7)),
        cross: Universal(rod, ground, at = [0.1, 0.0, 0.0], axis = [1.0, 1.0, 0.0], second_axis = [1.0, -1.0, 0.5]),
        second: Universal(rod, bob, at = [0.5, 0.2, 0.1], axis = Y, second_axis = X),
        tip: Output(bob.point(0.2, 0.3, 0.1)),
    );

    #[test]
    fn universals_turn_about_both_pins() {
        assert_eq!(size(joints::Crosses::MODEL), (4, 4, 0));
        agree(
            [&|h| run::<rows::Crosses, _, _, _, _>(h, 0.4), &|h| {
                run::<joints::Crosses, _, _, _, _>(h, 0.4)
            }],
            2e-3,
            1e-3,
        );
    }
}

mod welds {
    use super::{mechanism, *};

    both!(Welds, Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
        arm: Body(mass = 1.0_kg, inertia = diag(0.1, 0.2, 0.25), at = [0.3, 0.2, 0.1]),
        post: Body(mass = 2.0_kg, inertia = diag(0.1, 0.2, 0.1), at = [0.5, 0.2, 0.1], orientation = turn([1.0, 2.0, 0.5], 0.7)),
        ram: Body(mass = 1.0_kg, inertia = diag(0.1, 0.2, 0.1), at = [0.5, 0.2, 0.6], orientation = turn([1.0, 0.0, 0.5], 0.7)),
        hinge: Revolute(ground, arm, at = [0.0, 0.0, 0.0], axis = [0.0, 1.0, 0.3]),
        weld: Fixed(post, arm, at = [0.4, 0.2, 0.1]),
        guide: Cylindrical(ram, post, at = [0.5, 0.2, 0.3], axis = [0.3, 0.0, 1.0]),
        wind: TorsionSpring(guide, stiffness = 3.0_Nm, angle = 0.5),
        turned: Output(guide.angle),
        turning: Output(guide.rate),
        slid: Output(guide.stroke),
        sliding: Output(guide.speed),
    );

    #[test]
    fn welded_bodies_have_no_coordinates() {
        // Neither has an angle that is a coordinate a memory of its turns.
        assert_eq!(size(joints::Welds::MODEL), (3, 3, 0));
        agree(
            [&|h| run::<rows::Welds, _, _, _, _>(h, 0.4), &|h| {
                run::<joints::Welds, _, _, _, _>(h, 0.4)
            }],
            2e-3,
            1e-3,
        );
    }
}

mod turns {
    use super::{mechanism, *};

    both!(Turns, Spatial(gravity = [0.0, 0.0, 0.0]),
        wheel: Body(mass = 1.0_kg, inertia = 0.1_kg_m2, angular_velocity = [0.0_rad_per_s, 0.0, 50.0]),
        rack: Body(mass = 1.0_kg, inertia = 0.1_kg_m2, at = [1.0, 0.0, 0.0]),
        axle: Revolute(wheel, ground, at = [0.0, 0.0, 0.0], axis = Z),
        lift: Prismatic(ground, rack, at = [1.0, 0.0, 0.0], axis = Z),
        mesh: RackPinion(axle, lift, radius = 0.1_m),
        turned: Output(axle.angle),
        turning: Output(axle.rate),
        lifted: Output(lift.stroke),
        lifting: Output(lift.speed),
    );

    #[test]
    fn full_turns_are_counted_by_the_coordinate() {
        assert_eq!(size(joints::Turns::MODEL).0, size(joints::Turns::MODEL).1);
        let run = run::<joints::Turns, _, _, _, _>(1e-3, 2.0);
        let value = |name: &str| {
            let found = run.iter().find(|(other, _)| other == name);
            found.expect("it is an output").1
        };
        // Constant speed, and no slip.
        let rate = value("turning");
        assert!(rate < 0.0, "the wheel is the first partner: {rate}");
        assert!((value("turned") - 2.0 * rate).abs() < 1e-9);
        assert!(value("turned").abs() > 10.0 * std::f64::consts::TAU);
        assert!((value("lifted") - 0.1 * value("turned")).abs() < 1e-9);
        assert!((value("lifting") - 0.1 * rate).abs() < 1e-9);
    }
}
