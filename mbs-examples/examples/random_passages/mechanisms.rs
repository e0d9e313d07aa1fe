//! Mechanisms that pass singular poses on every turn, with a number that is zero on the branch of the motion.

use crate::combined::{Driven, FastRotor, Light, OnSleigh, Pushed, Shaken};
use crate::spherical::spherical;
use mbs_examples::scene::Build;
use mbs_runtime::{Mechanism, Model, mechanism};

mechanism!(SliderCrank {
    doc: "Crank and rod of equal length: when the crank is upright the slider may stay, or go on.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    phase: Param(40.0_deg),
    rate: Param(1.0_rad_per_s),
    damping: Param(0.0),
    crank: Bar(mass = 1.0_kg, length = 1.0_m, angle = phase, rate = rate),
    rod: Bar(mass = 1.0_kg, length = 1.0_m, angle = -phase, rate = -rate),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),
    brake: TorsionSpring(ground, crank, damping = damping),
    astray: Output(rod.b.x - 2.0 * crank.b.x),
});

mechanism!(DoubleFourBar {
    doc: "Three cranks and two couplers, two parallelograms, singular when level.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    phase: Param(40.0_deg),
    rate: Param(1.0_rad_per_s),
    damping: Param(0.0),
    crank0: Bar(mass = 1.0_kg, length = 1.0_m, angle = phase, rate = rate),
    crank1: Bar(mass = 1.0_kg, length = 1.0_m, angle = phase, rate = rate),
    crank2: Bar(mass = 1.0_kg, length = 1.0_m, angle = phase, rate = rate),
    coupler1: Bar(mass = 1.0_kg, length = 1.0_m),
    coupler2: Bar(mass = 1.0_kg, length = 1.0_m),
    pivot0: Revolute(ground.origin, crank0.a),
    pivot1: Revolute(ground.point(1.0, 0.0), crank1.a),
    pivot2: Revolute(ground.point(2.0, 0.0), crank2.a),
    pin1a: Revolute(crank0.b, coupler1.a),
    pin1b: Revolute(crank1.b, coupler1.b),
    pin2a: Revolute(crank1.b, coupler2.a),
    pin2b: Revolute(crank2.b, coupler2.b),
    brake: TorsionSpring(ground, crank0, damping = damping),
    astray: Output(abs(crank1.b.y - crank0.b.y) + abs(crank2.b.y - crank0.b.y)),
});

mechanism!(Parallelogram {
    doc: "Three cranks, two couplers and a rod over both: a redundant row, and singular when level.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    phase: Param(40.0_deg),
    rate: Param(1.0_rad_per_s),
    damping: Param(0.0),
    crank0: Bar(mass = 1.0_kg, length = 1.0_m, angle = phase, rate = rate),
    crank1: Bar(mass = 1.0_kg, length = 1.0_m, angle = phase, rate = rate),
    crank2: Bar(mass = 1.0_kg, length = 1.0_m, angle = phase, rate = rate),
    coupler1: Bar(mass = 1.0_kg, length = 1.0_m),
    coupler2: Bar(mass = 1.0_kg, length = 1.0_m),
    pivot0: Revolute(ground.origin, crank0.a),
    pivot1: Revolute(ground.point(1.0, 0.0), crank1.a),
    pivot2: Revolute(ground.point(2.0, 0.0), crank2.a),
    pin1a: Revolute(crank0.b, coupler1.a),
    pin1b: Revolute(crank1.b, coupler1.b),
    pin2a: Revolute(crank1.b, coupler2.a),
    pin2b: Revolute(crank2.b, coupler2.b),
    over: Distance(crank0.b, crank2.b, length = 2.0_m),
    brake: TorsionSpring(ground, crank0, damping = damping),
    astray: Output(abs(crank1.b.y - crank0.b.y) + abs(crank2.b.y - crank0.b.y)),
});

/// Two cranks and a coupler in space, on four parallel hinges.
macro_rules! in_space {
    ($name:ident, $coordinates:ident) => {
        mechanism!($name {
            doc: "A parallelogram in space: three rows are redundant, and one more is lost when it is level.",
            world: Spatial(gravity = [0.0, -9.81_m_per_s2, 0.0], coordinates = $coordinates),
            phase: Param(40.0_deg),
            rate: Param(1.0_rad_per_s),
            damping: Param(0.0),
            reach: Let(1.0_m * [cos(phase), sin(phase), 0.0]),
            turning: Let([0.0, 0.0, rate]),
            crank0: Body(
                mass = 1.0_kg,
                inertia = diag(0.01, 0.08, 0.08),
                at = 0.5 * reach,
                orientation = turn([0.0, 0.0, 1.0], phase),
                velocity = 0.5 * cross(turning, reach),
                angular_velocity = turning
            ),
            crank1: Body(
                mass = 1.0_kg,
                inertia = diag(0.01, 0.08, 0.08),
                at = 0.5 * reach + [2.0_m, 0.0, 0.0],
                orientation = turn([0.0, 0.0, 1.0], phase),
                velocity = 0.5 * cross(turning, reach),
                angular_velocity = turning
            ),
            coupler: Body(
                mass = 2.0_kg,
                inertia = diag(0.02, 0.6, 0.6),
                at = reach + [1.0_m, 0.0, 0.0],
                velocity = cross(turning, reach)
            ),
            bearing0: Revolute(ground, crank0, at = [0.0, 0.0, 0.0], axis = Z),
            bearing1: Revolute(ground, crank1, at = [2.0_m, 0.0, 0.0], axis = Z),
            pin0: Revolute(crank0, coupler, at = reach, axis = Z),
            pin1: Revolute(crank1, coupler, at = reach + [2.0_m, 0.0, 0.0], axis = Z),
            brake: TorsionSpring(bearing0, damping = damping),
            astray: Output(crank1.origin.y - crank0.origin.y),
        });
    };
}
in_space!(ParallelogramInSpace, Auto);
in_space!(ParallelogramByBodies, Reference);

spherical!(Spherical, Auto);
spherical!(SphericalByBodies, Reference);

/// A mechanism of the table.
pub struct Passing {
    /// Its name there.
    pub name: &'static str,
    /// The model.
    pub model: &'static Model,
    /// Makes it.
    pub build: Build,
}

macro_rules! passing {
    ($name:literal, $mechanism:ty) => {
        Passing {
            name: $name,
            model: <$mechanism>::MODEL,
            build: mbs_examples::build_scene!($mechanism),
        }
    };
}

/// All of them.
pub fn all() -> Vec<Passing> {
    vec![
        passing!("slider-crank", SliderCrank),
        passing!("double four-bar", DoubleFourBar),
        passing!("three cranks, redundant", Parallelogram),
        passing!("parallelogram in space", ParallelogramInSpace),
        passing!("the same by bodies", ParallelogramByBodies),
        passing!("spherical linkage", Spherical),
        passing!("spherical by bodies", SphericalByBodies),
        passing!("driven slider-crank", Driven),
        passing!("on a shaken base", Shaken),
        passing!("on a knife edge", OnSleigh),
        passing!("torque that jumps", Pushed),
        passing!("couplers of 0.1 g", Light),
        passing!("rotor of 1000 rad/s", FastRotor),
    ]
}
