//! Forces and torques in the axes of their own part, of another part and of the ground: the same motion in joint
//! coordinates and in those of free bodies, with few operations.

use mbs_macros_core::{Analysis, analyse};
use mbs_runtime::nalgebra::SVector;
use mbs_runtime::{Settings, Simulation, State, mechanism};
use mbs_tests::instant::Instant;

/// An arm on a universal joint with a slide, each with forces and torques in all axes; `COORDINATES` is replaced.
const ARM: &str = "Arm { world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2], coordinates = COORDINATES),
    lower: Body(mass = 2.0_kg, inertia = diag(0.2, 0.3, 0.1) * 1.0_kg_m2, center_of_mass = [0.1_m, 0.02, 0.3],
        orientation = [turn([1.0, 2.0, 3.0], 0.4)], at = [0.2_m, 0.1, 0.0]),
    upper: Body(mass = 1.0_kg, inertia = diag(0.02, 0.02, 0.001) * 1.0_kg_m2, center_of_mass = [0.0_m, 0.1, 0.05],
        orientation = [turn([0.3, -1.0, 0.2], 0.7)], at = [0.3_m, 0.3, 0.9]),
    base: Universal(ground, lower, at = [0.0_m, 0.0, 0.0], axis = X, second_axis = Y),
    slide: Prismatic(lower, upper, at = [0.1_m, 0.1, 0.5], axis = unit([0.2, 0.1, 1.0])),
    own: Force(upper.point(0.1_m, 0.2, 0.3), value = [1.0_N, 2.0, 3.0], axes = upper),
    across: Force(upper.point(0.1_m, 0.0, -0.2), value = [3.0_N, -1.0, 2.0], axes = lower),
    wind: Force(lower.point(0.3_m, 0.1, 0.2), value = [1.0_N, 1.0, -2.0]),
    screw: Wrench(lower.point(0.1_m, 0.4, 0.2), force = [1.0_N, 0.0, 2.0], torque = [0.3_Nm, 0.2, 0.1], axes = lower),
    turner: Wrench(upper.origin, torque = [0.3_Nm, -0.2, 0.1], axes = lower),
    twist: Torque(upper, value = [0.1_Nm, 0.2, 0.3], axes = upper),
    back: Torque(upper, value = [0.4_Nm, 0.1, -0.3], from = lower, axes = lower),
    mount: Bushing(lower, upper, at = [0.3_m, 0.2, 0.4], stiffness = [100.0_N_per_m, 200.0, 300.0],
        damping = [4.0_N_s_per_m, 5.0, 6.0], torsion_stiffness = [[3.0_Nm, 0.2, 0.1], [0.2, 2.0, 0.3], [0.1, 0.3, 1.0]],
        torsion_damping = [0.1_Nm_s, 0.2, 0.3]),
    foot: Bushing(upper, ground, at = [0.1_m, 0.2, 0.3], stiffness = [100.0_N_per_m, 200.0, 300.0],
        damping = [4.0_N_s_per_m, 5.0, 6.0], torsion_stiffness = [3.0_Nm, 2.0, 1.0], torsion_damping = 0.1_Nm_s),
    tip: Output([dot(upper.origin, ground.x), dot(upper.origin, ground.y), dot(upper.origin, ground.z)]),
}";

fn analysed(text: &str) -> Analysis {
    let tokens = text.parse().expect("these are tokens");
    let failed =
        |failure: mbs_macros_core::diagnostics::Failure| panic!("{:?}", failure.messages());
    analyse(tokens).1.unwrap_or_else(failed)
}

#[test]
fn descriptions_agree() {
    let [joint, free] =
        ["Joint", "Reference"].map(|name| analysed(&ARM.replace("COORDINATES", name)));
    let [a, b] = [&joint, &free].map(Instant::at_start);
    for instant in [&a, &b] {
        let [gained, given, size] = instant.power();
        assert!(
            (gained - given).abs() < 1e-7 * size,
            "{gained} W for {given} W"
        );
    }
    let (a, b) = (a.quantities(), b.quantities());
    for (a, b) in a.iter().zip(&b) {
        assert!((a - b).abs() < 1e-9 * (1.0 + b.abs()), "{a} for {b}");
    }
    let [a, b] = [&joint, &free].map(|analysis| Instant::at_start(analysis).reactions());
    assert_eq!(
        a.keys().collect::<Vec<_>>(),
        b.keys().collect::<Vec<_>>(),
        "the same reactions"
    );
    for (name, force) in &a {
        assert!(
            (force - b[name]).abs() < 1e-7,
            "{name}: {force} for {}",
            b[name]
        );
    }
}

/// A part that turns about a point: an entry of its rotation would take more operations than the force has.
#[test]
fn a_force_in_its_own_axes_needs_no_rotation() {
    let text = "Top { world: Spatial(coordinates = Joint),
        push: Input(1.0_N),
        top: Body(mass = 1.0_kg, inertia = diag(0.2, 0.3, 0.1) * 1.0_kg_m2, at = [0.0_m, 0.0, 0.0]),
        pivot: Universal(ground, top, at = [0.0_m, 0.0, 0.0], axis = X, second_axis = Y),
        thrust: Force(top.point(0.0_m, 0.0, 1.0), value = [0.0_N, push, 0.0], axes = top),
    }";
    let analysis = analysed(text);
    let forces = analysis.program.function("applied_forces");
    let operations = forces.expect("there are forces").operations.len();
    // −F cos(second angle), and nothing about the other axis.
    assert!(operations <= 3, "{operations} operations");
}

/// Two welded parts that swing together: a damper between them sees no motion, whatever their velocities.
#[test]
fn a_damper_between_welded_parts_does_no_work() {
    let text = "Welded { world: Spatial(gravity = [1.0, 2.0, -9.81_m_per_s2], coordinates = Reference),
        lower: Body(mass = 2.0_kg, inertia = diag(0.2, 0.3, 0.1) * 1.0_kg_m2, center_of_mass = [0.1_m, 0.02, 0.3]),
        upper: Body(mass = 1.0_kg, inertia = diag(0.2, 0.2, 0.1) * 1.0_kg_m2, center_of_mass = [0.1_m, 0.2, 0.3],
            orientation = [turn([0.3, -1.0, 0.2], 0.7)], at = [0.3_m, 0.3, 0.9]),
        base: Spherical(ground, lower, at = [0.0_m, 0.0, 0.0]),
        weld: Fixed(lower, upper, at = [0.1_m, 0.1, 0.5]),
        mount: Bushing(lower, upper, at = [0.3_m, 0.2, 0.4], damping = [4.0_N_s_per_m, 5.0, 6.0],
            torsion_damping = [0.1_Nm_s, 0.2, 0.3]),
    }";
    let analysis = analysed(text);
    let [kinetic, _, power] = Instant::at_start(&analysis).quantities()[..] else {
        panic!("three quantities")
    };
    assert!(kinetic > 0.01, "it moves: {kinetic} J");
    assert!(power.abs() < 1e-12, "{power} W");
}

/// The gains of a bushing are in the axes of its parent, however its partners are written.
macro_rules! turned_parent {
    ($name:ident, $parent:expr, $child:expr $(, $at:tt)*) => {
        mechanism!($name {
            world: Spatial(),
            base: Body(
                mass = 1.0_kg,
                inertia = 1.0_kg_m2,
                orientation = turn(Z, 90.0_deg)
            ),
            weld: Fixed(ground, base, at = [0.0_m, 0.0, 0.0]),
            load: Body(
                mass = 1.0_kg,
                inertia = 1.0_kg_m2,
                velocity = [1.0_m_per_s, 0.0, 0.0]
            ),
            mount: Bushing(
                $parent,
                $child,
                $($at = [0.0_m, 0.0, 0.0],)*
                damping = [10.0_N_s_per_m, 20.0, 30.0]
            ),
            pull: Output(load.origin.acceleration.x),
        });
    };
}

turned_parent!(ByParts, base, load, at);
turned_parent!(ByPoints, base.origin, load.origin);
turned_parent!(
    ByFrames,
    base.frame([0.0, 0.0, 0.0], Z),
    load.frame([0.0, 0.0, 0.0], Z)
);

#[test]
fn gains_of_a_bushing_are_in_the_axes_of_its_parent() {
    let pulls = [
        Simulation::new(ByParts::default()).map(|run| run.outputs().pull),
        Simulation::new(ByPoints::default()).map(|run| run.outputs().pull),
        Simulation::new(ByFrames::default()).map(|run| run.outputs().pull),
    ];
    for pull in pulls {
        let pull = pull.expect("it assembles");
        assert!((pull + 20.0).abs() < 1e-12, "{pull}");
    }
}

mechanism!(Coupled {
    world: Spatial(),
    load: Body(mass = 2.0_kg, inertia = 0.25_kg_m2),
    mount: Bushing(
        ground,
        load,
        at = [0.0_m, 0.0, 0.0],
        cross_stiffness = [[0.0_N, 0.0, 5.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]],
        torsion_damping = [0.1_N_m_s, 0.2, 0.5]
    ),
    along: Output(load.origin.acceleration.x),
    about: Output(load.angular_acceleration.z),
});

/// V = u · C s with s = n sin ψ: with C_xz = 5 N alone the force along x is −C_xz s_z, and the torque about z is −C_xz u_x ds_z/dψ.
#[test]
fn a_bushing_opposes_what_its_gains_couple() {
    let outputs = |x: f64, angle: f64, spin: f64| {
        let (sin, cos) = (0.5 * angle).sin_cos();
        let positions = SVector::from([x, 0.0, 0.0, cos, 0.0, 0.0, sin]);
        let velocities = SVector::from([0.0, 0.0, 0.0, 0.0, 0.0, spin]);
        let state = State::new(0.0, positions, velocities);
        let run = Simulation::resume(Coupled::default(), Settings::default(), state);
        let outputs = run.expect("it has no rows").outputs();
        [outputs.along, outputs.about]
    };
    // s_z = sin 60° and ds_z/dψ = cos 60°: −5 N · sin 60° on 2 kg, and −5 N · 0.2 m · cos 60° on 0.25 kg m².
    let turned = outputs(0.2, 60f64.to_radians(), 0.0);
    // −0.5 N m s · 3 rad/s on 0.25 kg m².
    let spinning = outputs(0.0, 0.0, 3.0);
    for (found, wanted) in [
        (turned, [-2.5 * 0.75f64.sqrt(), -2.0]),
        (spinning, [0.0, -6.0]),
    ] {
        for (found, wanted) in found.iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-12, "{found} for {wanted}");
        }
    }
}
