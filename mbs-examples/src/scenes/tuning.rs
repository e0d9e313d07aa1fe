//! Mechanisms for the search of the parameters of the baselines. They have the same difficulties as those of the maps
//! and of the paper's figures, singular poses and redundant rows, but are other mechanisms. They are not in the list of
//! scenes.

use crate::scene::Scene;
use mbs_runtime::{Mechanism, mechanism};

mechanism!(ThreeCranks {
    doc: "Three cranks that turn right round, with couplers of unequal lengths: two ranks are lost when they are horizontal.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    /// Length of the cranks.
    radius: Param(0.3_m),
    /// Length of the first coupler.
    near: Param(0.5_m),
    /// Length of the second coupler.
    far: Param(0.8_m),
    /// Initial angular velocity of the cranks.
    turning: Param(-5.0_rad_per_s),

    crank0: Bar(
        mass = 0.4_kg,
        length = radius,
        angle = 70.0_deg,
        rate = turning
    ),
    crank1: Bar(
        mass = 1.1_kg,
        length = radius,
        angle = 70.0_deg,
        rate = turning
    ),
    crank2: Bar(
        mass = 0.7_kg,
        length = radius,
        angle = 70.0_deg,
        rate = turning
    ),
    coupler1: Bar(mass = 1.5_kg, length = near),
    coupler2: Bar(mass = 0.6_kg, length = far),

    bearing0: Revolute(ground.origin, crank0.a),
    bearing1: Revolute(ground.point(near, 0.0), crank1.a),
    bearing2: Revolute(ground.point(near + far, 0.0), crank2.a),
    left1: Revolute(crank0.b, coupler1.a),
    right1: Revolute(crank1.b, coupler1.b),
    left2: Revolute(crank1.b, coupler2.a),
    right2: Revolute(crank2.b, coupler2.b),

    tip: Output(crank2.b),
});

mechanism!(Kite {
    doc: "A four-bar of two pairs of equal neighbours: it can fold, and is singular when the crank lies on the base.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    /// Length of crank and base.
    short: Param(0.5_m),
    /// Length of coupler and rocker.
    long: Param(0.9_m),
    /// Initial angular velocity of the crank.
    turning: Param(-6.0_rad_per_s),

    crank: Bar(
        mass = 2.0_kg,
        length = short,
        angle = 60.0_deg,
        rate = turning
    ),
    coupler: Bar(mass = 0.5_kg, length = long, angle = 13.9_deg),
    rocker: Bar(mass = 0.8_kg, length = long, angle = 46.1_deg),

    bearing: Revolute(ground.origin, crank.a),
    post: Revolute(ground.point(short, 0.0), rocker.a),
    left: Revolute(crank.b, coupler.a),
    right: Revolute(rocker.b, coupler.b),

    tip: Output(coupler.b),
});

mechanism!(FourBarInSpace {
    doc: "A planar four-bar of unequal masses with joints of space: 18 velocities and 20 rows, three of which follow from the others.",
    world: Spatial(
        gravity = [0.0, -9.81_m_per_s2, 0.0],
        coordinates = Reference
    ),

    p1: Point([0.0_m, 0.0, 0.0]),
    p2: Point([0.0_m, 0.25, 0.0]),
    p3: Point([0.7_m, 0.45, 0.0]),
    p4: Point([0.8_m, 0.0, 0.0]),

    crank: Bar(mass = 0.2_kg, from = p1, to = p2, radius = 0.04_m),
    coupler: Bar(mass = 5.0_kg, from = p2, to = p3, radius = 0.05_m),
    rocker: Bar(mass = 0.5_kg, from = p4, to = p3, radius = 0.03_m),

    j1: Revolute(ground, crank, at = p1, axis = Z),
    j2: Revolute(crank, coupler, at = p2, axis = Z),
    j3: Revolute(coupler, rocker, at = p3, axis = Z),
    j4: Revolute(ground, rocker, at = p4, axis = Z),

    tip: Output(coupler.b),
});

const SOURCE: &str = "made to tune the baselines";

/// Three cranks of unequal spacing.
pub static THREE_CRANKS: Scene = Scene {
    name: "three-cranks",
    title: "Three cranks with couplers of unequal lengths",
    source: SOURCE,
    model: ThreeCranks::MODEL,
    duration: 3.0,
    step: 1e-3,
    reference: None,
    build: crate::build_scene!(ThreeCranks),
};

/// A four-bar that folds.
pub static KITE: Scene = Scene {
    name: "kite",
    title: "Kite that folds",
    source: SOURCE,
    model: Kite::MODEL,
    duration: 3.0,
    step: 1e-3,
    reference: None,
    build: crate::build_scene!(Kite),
};

/// A planar loop of bodies in space.
pub static FOUR_BAR_IN_SPACE: Scene = Scene {
    name: "four-bar-in-space",
    title: "Planar four-bar of bodies in space",
    source: SOURCE,
    model: FourBarInSpace::MODEL,
    duration: 3.0,
    step: 1e-3,
    reference: None,
    build: crate::build_scene!(FourBarInSpace),
};
