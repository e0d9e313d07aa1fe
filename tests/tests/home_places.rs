//! Places and directions of the home pose of space that are given by points and axes of parts.

use crate::common::expansion::refused;
use mbs_runtime::{Mechanism, Settings, Simulation, SimulationError, System, mechanism};

/// Every number is written out.
mod by_numbers {
    use super::mechanism;

    mechanism!(pub Arm {
        world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
        post: Bar(
            mass = 2.0_kg,
            from = [0.0, 0.0, 0.0],
            to = [0.0, 0.0, 0.5_m],
            radius = 0.05_m
        ),
        arm: Bar(
            mass = 1.0_kg,
            from = [0.0, 0.0, 0.5_m],
            to = [0.3_m, 0.0, 0.9_m],
            radius = 0.03_m
        ),
        hand: Body(
            mass = 0.5_kg,
            inertia = diag(1e-3_kg_m2, 2e-3_kg_m2, 3e-3_kg_m2),
            at = [0.3_m, 0.0, 0.8_m],
            orientation = axes([0.6, 0.0, 0.8], Y)
        ),
        turn: Revolute(ground, post, at = [0.0, 0.0, 0.0], axis = Z),
        lift: Revolute(post, arm, at = [0.0, 0.0, 0.5_m], axis = Y),
        wrist: Universal(
            arm,
            hand,
            at = [0.3_m, 0.0, 0.9_m],
            axis = [-0.8, 0.0, 0.6],
            second_axis = Y
        ),
        load: Particle(mass = 0.2_kg, at = [0.3_m, 0.0, 0.5_m], free = true),
        rope: Distance(arm.b, load.origin, length = 0.4_m),
        tip: Output(hand.point(0.1_m, 0.0, 0.0)),
    });
}

/// Each part begins where the one before ends.
mod by_parts {
    use super::mechanism;

    mechanism!(pub Arm {
        world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
        height: Param(0.5_m),
        post: Bar(
            mass = 2.0_kg,
            from = [0.0, 0.0, 0.0],
            to = [0.0, 0.0, height],
            radius = 0.05_m
        ),
        arm: Bar(
            mass = 1.0_kg,
            from = post.b,
            to = post.b + [0.3_m, 0.0, 0.4_m],
            radius = 0.03_m
        ),
        along: Let(unit(arm.b - arm.a)),
        below: Let(arm.b - [0.0, 0.0, 0.1_m]),
        hand: Body(
            mass = 0.5_kg,
            inertia = diag(1e-3_kg_m2, 2e-3_kg_m2, 3e-3_kg_m2),
            at = below,
            orientation = axes(along, Y)
        ),
        turn: Revolute(ground, post, at = [0.0, 0.0, post.a.z], axis = Z),
        lift: Revolute(post, arm, at = post.b, axis = Y),
        wrist: Universal(
            arm,
            hand,
            at = below + [0.0, 0.0, 0.1_m],
            axis = cross(along, Y),
            second_axis = hand.y
        ),
        load: Particle(
            mass = 0.2_kg,
            at = [arm.b.x, arm.b.y, height],
            free = true
        ),
        rope: Distance(
            arm.b,
            load.origin,
            length = norm(arm.b - load.origin)
        ),
        tip: Output(hand.point(0.1_m, 0.0, 0.0)),
        // The same values move here.
        reach: Output(below.x),
        slope: Output(along.z),
    });
}

fn moved<M, S, const Q: usize, const N: usize, const R: usize>()
-> Result<(Simulation<S, Q, N, R>, [f64; 3]), SimulationError>
where
    M: Mechanism<System = S> + Default,
    S: System<Q, N, R>,
{
    let settings = Settings {
        step: 1e-2,
        ..Settings::default()
    };
    let mut simulation = Simulation::with_settings(M::default(), settings)?;
    simulation.run_until(0.5)?;
    let tip = ["x", "y", "z"].map(|axis| simulation.output(&format!("tip.{axis}")));
    let [x, y, z] = tip.map(|value| value.expect("it is declared"));
    Ok((simulation, [x, y, z]))
}

#[test]
fn points_and_axes_of_parts_give_the_same_mechanism() -> Result<(), SimulationError> {
    let (_, by_numbers) = moved::<by_numbers::Arm, _, _, _, _>()?;
    let (simulation, by_parts) = moved::<by_parts::Arm, _, _, _, _>()?;
    for (number, part) in by_numbers.into_iter().zip(by_parts) {
        assert!((number - part).abs() < 1e-11, "{by_numbers:?} {by_parts:?}");
    }
    // It has moved, and a `Let` moves with it outside of the home pose.
    assert!((by_parts[2] - 0.88).abs() > 0.1);
    let outputs = simulation.outputs();
    assert!((outputs.reach - 0.3).abs() > 0.05 && (outputs.slope - 0.8).abs() > 0.05);
    Ok(())
}

/// Each `Let` of a long list that doubles the one before is evaluated once.
#[test]
fn values_of_the_home_pose_are_computed_once() {
    let doubles: String = (1..60)
        .map(|k| {
            format!(
                "x{k}: Let(0.5 * x{before} + 0.5 * x{before}),",
                before = k - 1
            )
        })
        .collect();
    let text = format!(
        "Doubles {{
            world: Spatial(),
            arm: Bar(mass = 1.0_kg, from = [0.0, 0.0, 0.0], to = [1.0_m, 0.0, 0.0], radius = 0.1_m),
            x0: Let(arm.b),
            {doubles}
            pin: Revolute(ground, arm, at = x59, axis = Z),
        }}"
    );
    let (_, outcome) = mbs_macros_core::analyse(text.parse().expect("these are tokens"));
    assert!(outcome.is_ok());
}

/// The rows of such joints are products of axes, which vanish for opposite axes, too; joint coordinates would start half a
/// turn off.
#[test]
fn opposite_axes_are_refused() {
    refused(
        r#"mechanism!(Opposite {
    world: Spatial(),
    arm: Body(mass = 1.0_kg, inertia = 0.1_kg_m2),
    hand: Body(mass = 1.0_kg, inertia = 0.1_kg_m2),
    knob: Body(mass = 1.0_kg, inertia = 0.1_kg_m2),
    pin: Revolute(ground.frame([0.0, 0.0, 0.0], Z), arm.frame([0.0, 0.0, 0.0], -Z)),
    ~~~ in the home pose the axes at `ground.frame` and at `arm.frame` are 180.0° off those that this `Revolute` holds together; turn one of the frames or parts, or give the axis once by `axis =`
    slide: Prismatic(arm.frame([0.0, 0.0, 0.0], Z), hand.frame([0.0, 0.0, 0.0], -Z)),
    ~~~~~ in the home pose the axes at `arm.frame` and at `hand.frame` are 180.0° off those that this `Prismatic` holds together; turn one of the frames or parts, or give the axis once by `axis =`
    ball: Spherical(hand.frame([0.0, 0.0, 0.0], Z), knob.frame([0.0, 0.0, 0.0], -Z)),
});"#,
    );
}
