//! Mechanisms of the method laboratory: each has one difficulty at which methods are said to fail; one mechanism is
//! modelled in four ways. `mbs chart` runs them; they are not in the list of scenes.

use crate::scene::{Reference, Scene};
use mbs_runtime::{Mechanism, mechanism};

mechanism!(NearParallelogram {
    doc: "A four-bar of three bars of 1 m on a base that is 1e-6 m short of it: nearly singular when horizontal.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    /// Length of each bar.
    length: Param(1.0_m),
    /// Difference between the length of the bars and that of the base. The cranks make full turns, so that only one
    /// motion is right.
    shortfall: Param(1e-6_m),
    /// Mass of each bar.
    mass: Param(1.0_kg),
    /// Initial angular velocity of the cranks.
    turning: Param(-1.0_rad_per_s),

    base: Point([length - shortfall, 0.0_m]),
    left: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    right: Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = turning
    ),
    coupler: Bar(mass = mass, length = length),

    left_bearing: Revolute(ground.origin, left.a),
    right_bearing: Revolute(base, right.a),
    left_pin: Revolute(left.b, coupler.a),
    right_pin: Revolute(right.b, coupler.b),

    left_tip: Output(left.b),
    right_tip: Output(right.b),
});

mechanism!(UnequalMasses {
    doc: "A slider-crank that meets no singular pose, with masses of any ratio.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    /// Mass of the crank.
    crank_mass: Param(1.0_kg),
    /// Mass of the rod.
    rod_mass: Param(1.0_kg),
    /// Initial angular velocity of the crank: it makes full turns.
    turning: Param(8.0_rad_per_s),

    crank: Bar(
        mass = crank_mass,
        length = 0.5_m,
        angle = 0.0_deg,
        rate = turning
    ),
    rod: Bar(mass = rod_mass, length = 1.2_m, angle = 0.0_deg),

    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),

    tip: Output(crank.b),
    slider: Output(rod.b),
});

mechanism!(SpringPendulum {
    doc: "A bar with a particle on a spring at its end: one fast motion beside a slow one.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    /// Stiffness of the spring.
    stiffness: Param(1.0e4_N_per_m),

    bar: Bar(mass = 1.0_kg, length = 1.0_m, angle = 0.0_deg),
    bob: Particle(mass = 1.0_kg, at = [2.0, 0.0]),
    pivot: Revolute(ground.origin, bar.a),
    spring: SpringDamper(bar.b, bob.origin, stiffness = stiffness, length = 1.0_m),

    tip: Output(bar.b),
    end: Output(bob.origin),
});

mechanism!(SliderCrankByAngle {
    doc: "The slider-crank with two equal rods in the angle of its crank: no row, and no singular pose.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    /// Length of each rod.
    length: Param(1.0_m),
    /// Mass of each rod.
    mass: Param(1.0_kg),

    theta: Coordinate(45.0_deg, rate = 2.8284271247461903_rad_per_s),
    crank: Bar(
        mass = mass,
        length = length,
        frame = Frame([0.0_m, 0.0], theta)
    ),
    rod: Bar(
        mass = mass,
        length = length,
        frame = Frame([length * theta.cos(), length * theta.sin()], -theta),
    ),

    p1: Output(crank.b),
    p2: Output(rod.b),
});

mechanism!(SliderCrankByPoints {
    doc: "The slider-crank with two equal rods by the ends of its rods.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Natural),

    /// Length of each rod.
    length: Param(1.0_m),
    /// Mass of each rod.
    mass: Param(1.0_kg),

    turning: Let(2.8284271247461903_rad_per_s),
    crank: Bar(
        mass = mass,
        length = length,
        angle = 45.0_deg,
        rate = turning
    ),
    rod: Bar(
        mass = mass,
        length = length,
        angle = -45.0_deg,
        rate = -turning
    ),

    main_bearing: Revolute(ground.origin, crank.a),
    crank_pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),

    p1: Output(crank.b),
    p2: Output(rod.b),
});

mechanism!(SliderCrankByBodies {
    doc: "The slider-crank with two equal rods by centres and angles: every joint is rows.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Reference),

    /// Length of each rod.
    length: Param(1.0_m),
    /// Mass of each rod.
    mass: Param(1.0_kg),

    turning: Let(2.8284271247461903_rad_per_s),
    crank: Bar(
        mass = mass,
        length = length,
        angle = 45.0_deg,
        rate = turning
    ),
    rod: Bar(
        mass = mass,
        length = length,
        angle = -45.0_deg,
        rate = -turning
    ),

    main_bearing: Revolute(ground.origin, crank.a),
    crank_pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),

    p1: Output(crank.b),
    p2: Output(rod.b),
});

mechanism!(SliderCrankInSpace {
    doc: "The slider-crank with two equal rods in space: every joint is rows, and some follow from others.",
    world: Spatial(
        gravity = [0.0, -9.81_m_per_s2, 0.0],
        coordinates = Reference
    ),

    /// Length of each rod.
    length: Param(1.0_m),
    /// Mass of each rod.
    mass: Param(1.0_kg),

    start: Let(0.25 * pi),
    turning: Let(2.8284271247461903_rad_per_s),
    inertia: Let(mass * length * length / 12.0),
    knee: Point([length * start.cos(), length * start.sin(), 0.0_m]),

    crank: Body(
        mass = mass,
        inertia = diag(inertia, inertia, inertia),
        center_of_mass = [0.5 * length, 0.0, 0.0],
        orientation = turn(Z, start),
        angular_velocity = [0.0, 0.0, turning],
    ),
    rod: Body(
        mass = mass,
        inertia = diag(inertia, inertia, inertia),
        center_of_mass = [0.5 * length, 0.0, 0.0],
        at = [length * start.cos(), length * start.sin(), 0.0_m],
        orientation = turn(Z, -start),
        angular_velocity = [0.0, 0.0, -turning],
    ),

    main_bearing: Revolute(ground, crank, at = [0.0_m, 0.0, 0.0], axis = Z),
    crank_pin: Revolute(crank, rod, at = knee, axis = Z),
    guide: PointOnLine(rod.point(length, 0.0, 0.0), ground.origin, axis = X),

    p1: Output(rod.origin),
    p2: Output(rod.point(length, 0.0, 0.0)),
});

const FAILURES: &str = "made for the method laboratory";

/// A near-parallelogram.
pub static NEAR_PARALLELOGRAM: Scene = Scene {
    name: "near-parallelogram",
    title: "Parallelogram with a base 1e-6 m short",
    source: FAILURES,
    model: NearParallelogram::MODEL,
    duration: 10.0,
    step: 1e-3,
    reference: None,
    build: crate::build_scene!(NearParallelogram),
};

/// Masses of any ratio.
pub static UNEQUAL_MASSES: Scene = Scene {
    name: "unequal-masses",
    title: "Slider-crank with masses of any ratio",
    source: FAILURES,
    model: UnequalMasses::MODEL,
    duration: 10.0,
    step: 1e-3,
    reference: None,
    build: crate::build_scene!(UnequalMasses),
};

/// A spring of any stiffness.
pub static SPRING_PENDULUM: Scene = Scene {
    name: "spring-pendulum",
    title: "Bar with a particle on a spring",
    source: FAILURES,
    model: SpringPendulum::MODEL,
    duration: 10.0,
    step: 1e-3,
    reference: None,
    build: crate::build_scene!(SpringPendulum),
};

/// One slider-crank in four ways, the smallest model first.
pub static MODELS: [Scene; 4] = [
    model(
        "declared angle",
        SliderCrankByAngle::MODEL,
        crate::build_scene!(SliderCrankByAngle),
    ),
    model(
        "points",
        SliderCrankByPoints::MODEL,
        crate::build_scene!(SliderCrankByPoints),
    ),
    model(
        "planar bodies",
        SliderCrankByBodies::MODEL,
        crate::build_scene!(SliderCrankByBodies),
    ),
    model(
        "bodies in space",
        SliderCrankInSpace::MODEL,
        crate::build_scene!(SliderCrankInSpace),
    ),
];

const fn model(
    name: &'static str,
    model: &'static mbs_runtime::Model,
    build: crate::scene::Build,
) -> Scene {
    Scene {
        name,
        title: "Slider-crank through its singular pose",
        source: "Potosakis, Paraskevopoulos, Natsiavas 2020, section 7.2",
        model,
        duration: 10.0,
        step: 1e-3,
        reference: Some(Reference {
            file: "slider_crank_singular_gravity.csv",
            columns: &[("p1.x", "p1x_m"), ("p1.y", "p1y_m"), ("p2.x", "p2x_m")],
        }),
        build,
    }
}
