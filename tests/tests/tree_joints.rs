//! Joints that become coordinates: the same motion and the same reactions as with rows, for both orders of the
//! partners.

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
        // An angle that is a coordinate does not count turns either.
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

mod threads {
    use super::{mechanism, *};

    // The second thread is declared from the carried part to the one that carries it.
    both!(Threads, Spatial(gravity = [0.3_m_per_s2, -1.0, -9.81]),
        post: Body(mass = 2.0_kg, inertia = diag(0.1, 0.2, 0.15), at = [0.3, 0.2, 0.1], center_of_mass = [0.1, 0.0, 0.05]),
        nut: Body(mass = 1.0_kg, inertia = diag(0.05, 0.04, 0.06), at = [0.5, 0.2, 0.1], orientation = turn([1.0, 2.0, 0.5], 0.7),
            center_of_mass = [0.02, -0.03, 0.05]),
        bolt: Body(mass = 0.6_kg, inertia = diag(0.01, 0.02, 0.025), at = [0.6, 0.4, 0.2], center_of_mass = [0.05, 0.02, 0.0]),
        hinge: Revolute(ground, post, at = [0.0, 0.0, 0.0], axis = [0.0, 1.0, 0.3]),
        thread: Screw(post, nut, at = [0.5, 0.2, 0.3], axis = [0.3, 0.2, 1.0], pitch = 0.4_m),
        left: Screw(bolt, nut, at = [0.5, 0.3, 0.2], axis = [1.0, 0.0, 0.2], pitch = -0.3_m),
        wind: TorsionSpring(left, stiffness = 3.0_Nm, angle = 0.5),
        push: Torque(thread, value = 0.4_Nm * sin(3.0_rad_per_s * t)),
        turned: Output(thread.angle),
        turning: Output(thread.rate),
        slid: Output(thread.stroke),
        sliding: Output(left.speed),
        unscrewed: Output(left.angle),
        tip: Output(bolt.point(0.2, 0.3, 0.1)),
    );

    #[test]
    fn screws_turn_and_slide_by_one_coordinate() {
        assert_eq!(size(joints::Threads::MODEL), (3, 3, 0));
        assert_eq!(size(rows::Threads::MODEL).2, 15);
        agree(
            [&|h| run::<rows::Threads, _, _, _, _>(h, 0.3), &|h| {
                run::<joints::Threads, _, _, _, _>(h, 0.3)
            }],
            2e-3,
            1e-3,
        );
    }

    /// stroke = pitch · angle / 2π, whichever partner is declared first.
    #[test]
    fn the_stroke_follows_the_angle() {
        let run = run::<joints::Threads, _, _, _, _>(1e-3, 0.3);
        let value = |name: &str| {
            let found = run.iter().find(|(other, _)| other == name);
            found.expect("it is an output").1
        };
        let lead = 0.4 / std::f64::consts::TAU;
        assert!(value("turned").abs() > 0.1);
        assert!((value("slid") - lead * value("turned")).abs() < 1e-12);
    }
}

mod jack {
    use super::{mechanism, *};

    // A nut that falls along a vertical thread, and starts with a declared speed.
    both!(Jack, Spatial(gravity = [0.0, 0.0, -10.0_m_per_s2]),
        nut: Body(mass = 2.0_kg, inertia = diag(0.3, 0.3, 0.1), velocity = [0.0_m_per_s, 0.0, -0.5]),
        thread: Screw(ground, nut, at = [0.0, 0.0, 0.0], axis = Z, pitch = 0.5_m),
        turned: Output(thread.angle),
        fallen: Output(thread.stroke),
        speed: Output(thread.speed),
    );

    /// (m p² + J) θ̈ = −m g p with p = pitch / 2π: uniform acceleration; the thread carries what is left of the weight.
    #[test]
    fn a_nut_falls_along_its_thread() {
        let lead = 0.5 / std::f64::consts::TAU;
        let acceleration = -2.0 * 10.0 * lead * lead / (2.0 * lead * lead + 0.1);
        let until: f64 = 3.0;
        let fallen = -0.5 * until + 0.5 * acceleration * until * until;
        let force = 2.0 * (acceleration + 10.0);
        for run in [
            run::<rows::Jack, _, _, _, _>(1e-3, until),
            run::<joints::Jack, _, _, _, _>(1e-3, until),
        ] {
            let value = |name: &str| {
                let found = run.iter().find(|(other, _)| other == name);
                found.unwrap_or_else(|| panic!("{name} in {run:?}")).1
            };
            assert!(value("turned").abs() > std::f64::consts::TAU);
            assert!((value("turned") * lead - value("fallen")).abs() < 1e-6);
            assert!((value("thread.fz") - force).abs() < 1e-6 * force);
            assert!((value("thread.tz") + lead * force).abs() < 1e-6 * force);
            for absent in ["thread.fx", "thread.fy", "thread.tx", "thread.ty"] {
                assert!(value(absent).abs() < 1e-9);
            }
        }
        assert_eq!(size(joints::Jack::MODEL), (1, 1, 0));
        let run = run::<joints::Jack, _, _, _, _>(1e-3, until);
        let found = run.iter().find(|(name, _)| name == "fallen");
        assert!((found.expect("an output").1 - fallen).abs() < 1e-9);
    }
}

mod cuts {
    use super::{mechanism, *};

    both!(Cuts, Spatial(gravity = [0.0, -3.0_m_per_s2, -9.81]),
        crank: Body(mass = 1.0_kg, inertia = diag(0.01, 0.02, 0.025), at = [0.1, 0.0, 0.0]),
        rod: Body(mass = 0.5_kg, inertia = diag(0.02, 0.01, 0.02), at = [0.2, 0.25, 0.0]),
        block: Body(mass = 0.4_kg, inertia = diag(0.02, 0.03, 0.025), at = [0.2, 0.5, 0.0]),
        axle: Revolute(ground, crank, at = [0.0, 0.0, 0.0], axis = Z),
        cross: Universal(crank, rod, at = [0.2, 0.0, 0.0], axis = Z, second_axis = X),
        sleeve: Cylindrical(rod, block, at = [0.2, 0.4, 0.0], axis = Y),
        ball: Spherical(ground, block, at = [0.2, 0.6, 0.0]),
        end: Output(crank.point(0.1, 0.0, 0.0)),
        top: Output(block.point(0.1, 0.0, 0.2)),
    );

    #[test]
    fn the_joint_with_most_freedoms_is_cut() {
        // With the shortest chain the block would be carried by the ball, and a joint of four rows would close the
        // loop.
        let rows: Vec<&str> = joints::Cuts::MODEL
            .rows
            .iter()
            .map(|row| row.entry)
            .collect();
        assert_eq!(rows, ["ball"; 3]);
        assert_eq!(size(joints::Cuts::MODEL), (5, 5, 3));
        agree(
            [&|h| run::<rows::Cuts, _, _, _, _>(h, 0.3), &|h| {
                run::<joints::Cuts, _, _, _, _>(h, 0.3)
            }],
            2e-3,
            1e-3,
        );
    }
}

mod equal_cuts {
    use super::{mechanism, *};

    // Five bars in a ring: two joints could be cut, and leave chains of two and three bars.
    mechanism!(Ring {
        world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Joint),
        first: Bar(mass = 1.0_kg, length = 0.5_m, angle = 90.0_deg),
        second: Bar(mass = 1.0_kg, length = 0.5_m, angle = 60.0_deg),
        third: Bar(mass = 1.0_kg, length = 0.5_m, angle = 0.0_deg),
        fourth: Bar(mass = 1.0_kg, length = 0.5_m, angle = -60.0_deg),
        fifth: Bar(mass = 1.0_kg, length = 0.5_m, angle = -90.0_deg),
        left: Revolute(ground.origin, first.a),
        shoulder: Revolute(first.b, second.a),
        top: Revolute(second.b, third.a),
        crown: Revolute(third.b, fourth.a),
        elbow: Revolute(fourth.b, fifth.a),
        right: Revolute(fifth.b, ground.point(1.0_m, 0.0)),
    });

    #[test]
    fn equal_cuts_are_counted() {
        let candidates = Ring::MODEL.candidates;
        let cuts: Vec<&[&str]> = candidates.iter().map(|choice| choice.cut).collect();
        println!("{candidates:?}");
        assert_eq!(cuts, [["crown"], ["top"]]);
        assert_eq!(candidates.iter().filter(|choice| choice.taken).count(), 1);
        let least = candidates
            .iter()
            .filter_map(|choice| choice.operations)
            .min();
        let taken = candidates.iter().find(|choice| choice.taken);
        assert_eq!(taken.and_then(|choice| choice.operations), least);
    }
}

mod own {
    use super::*;

    /// Two bars and a crosshead, whose coordinates are chosen for all and for each.
    macro_rules! press {
        ($module:ident, $all:ident, [$($crank:tt)*], [$($rod:tt)*]) => {
            mod $module {
                use mbs_runtime::mechanism;
                mechanism!(Press {
                    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = $all),
                    crank: Bar(mass = 1.0_kg, length = 0.5_m, angle = 40.0_deg, rate = 3.0_rad_per_s $($crank)*),
                    rod: Bar(mass = 2.0_kg, length = 0.8_m, angle = -0.4134185936318221_rad $($rod)*),
                    bearing: Revolute(ground.origin, crank.a),
                    pin: Revolute(crank.b, rod.a),
                    guide: PointOnLine(rod.b, ground.origin, axis = X),
                    head: Output(rod.b.x),
                    knee: Output(crank.b),
                });
            }
        };
    }

    press!(all_natural, Natural, [], []);
    press!(rod_by_reference, Natural, [], [, coordinates = Reference]);
    press!(crank_by_joint, Natural, [, coordinates = Joint], []);
    press!(rod_by_points, Joint, [], [, coordinates = Natural]);
    press!(rod_beside_joints, Joint, [], [, coordinates = Reference]);

    #[test]
    fn a_part_can_have_coordinates_of_its_own() {
        // (x, y) of the knee and x of the head; the length of each bar.
        assert_eq!(size(all_natural::Press::MODEL), (3, 3, 2));
        // The knee; centre and angle. Length, pin, guide.
        assert_eq!(size(rod_by_reference::Press::MODEL), (5, 5, 4));
        // An angle; the ends of the rod. Pin, guide, length.
        assert_eq!(size(crank_by_joint::Press::MODEL), (5, 5, 4));
        assert_eq!(size(rod_by_points::Press::MODEL), (5, 5, 4));
        // An angle; centre and angle. Pin, guide.
        assert_eq!(size(rod_beside_joints::Press::MODEL), (4, 4, 3));
        let natural = |h| run::<all_natural::Press, _, _, _, _>(h, 0.4);
        agree(
            [&natural, &|h| {
                run::<rod_by_reference::Press, _, _, _, _>(h, 0.4)
            }],
            2e-3,
            1e-3,
        );
        agree(
            [&natural, &|h| {
                run::<crank_by_joint::Press, _, _, _, _>(h, 0.4)
            }],
            2e-3,
            1e-3,
        );
        agree(
            [&natural, &|h| {
                run::<rod_by_points::Press, _, _, _, _>(h, 0.4)
            }],
            2e-3,
            1e-3,
        );
        agree(
            [&natural, &|h| {
                run::<rod_beside_joints::Press, _, _, _, _>(h, 0.4)
            }],
            2e-3,
            1e-3,
        );
    }
}
