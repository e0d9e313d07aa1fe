//! Bricard's mechanism: five rods and six revolutes with one redundant row; it has one degree of freedom.
//!
//! IFToMM benchmark A04. By Grübler's count it has no mobility: 30 velocities and 30 rows. But one row follows from the
//! others, so that there is one degree of freedom. The rods start at rest and swing to the opposite pose in 2.5 s. The
//! benchmark does not say whether the rods are slender. Here they have a square section of 0.1 m; the scene
//! `bricard-slender` takes 3 mm instead of the limit. The motion differs from that of the limit with the square of the
//! width: in ten seconds by 2.1e-2 m at 0.1 m and by 1.9e-5 m at 3 mm, where the step of 0.01 s is wrong by 1.0e-3 m.
//! With thinner rods the equations with all rows are ill-conditioned: the moment of inertia of a rod of 1 mm about its
//! axis is half a million times smaller than across, and only 6e-8 of the length of row `j6.rotation_y` is independent
//! of the rows before it.
//!
//! Reference: closed form of the closure, integrated in one coordinate with high precision.

use crate::scene::{Reference, Scene};
use mbs_runtime::{Mechanism, mechanism};

mechanism!(Bricard {
    doc: "Five rods in a ring with the ground, six revolutes about X, Y and Z: overconstrained and movable.",
    world: Spatial(gravity = [0.0, -9.81_m_per_s2, 0.0]),

    /// Length of each rod.
    side: Param(1.0_m),
    /// Mass of each rod.
    mass: Param(1.0_kg),
    /// Width of the square section.
    width: Param(0.1_m),

    p1: Point([0.0_m, 0.0, 0.0]),
    p2: Point([side, 0.0, 0.0]),
    p3: Point([side, -side, 0.0]),
    p4: Point([side, -side, side]),
    p5: Point([0.0, -side, side]),
    p6: Point([0.0, 0.0, side]),

    rod1: Bar(
        mass = mass,
        from = p1,
        to = p2,
        inertia = Cuboid(side, width, width)
    ),
    rod2: Bar(
        mass = mass,
        from = p2,
        to = p3,
        inertia = Cuboid(side, width, width)
    ),
    rod3: Bar(
        mass = mass,
        from = p3,
        to = p4,
        inertia = Cuboid(side, width, width)
    ),
    rod4: Bar(
        mass = mass,
        from = p4,
        to = p5,
        inertia = Cuboid(side, width, width)
    ),
    rod5: Bar(
        mass = mass,
        from = p5,
        to = p6,
        inertia = Cuboid(side, width, width)
    ),

    j1: Revolute(ground, rod1, at = p1, axis = Y),
    j2: Revolute(rod1, rod2, at = p2, axis = Z),
    j3: Revolute(rod2, rod3, at = p3, axis = X),
    j4: Revolute(rod3, rod4, at = p4, axis = Y),
    j5: Revolute(rod4, rod5, at = p5, axis = Z),
    j6: Revolute(rod5, ground, at = p6, axis = X),

    corner2: Output(rod1.b),
    corner3: Output(rod2.b),
    corner4: Output(rod3.b),
    corner5: Output(rod4.b),
});

mechanism!(BricardReference {
    doc: "Bricard's mechanism with all of its rows: 30 velocities and 30 rows, one of which follows from the others.",
    world: Spatial(
        gravity = [0.0, -9.81_m_per_s2, 0.0],
        coordinates = Reference
    ),

    /// Length of each rod.
    side: Param(1.0_m),
    /// Mass of each rod.
    mass: Param(1.0_kg),
    /// Width of the square section.
    width: Param(0.1_m),

    place: Each(
        [
            [0.0_m, 0.0, 0.0],
            [side, 0.0, 0.0],
            [side, -side, 0.0],
            [side, -side, side],
            [0.0, -side, side],
            [0.0, 0.0, side]
        ],
        |place| Point(place)
    ),
    rod: Each(0..5, |i| Bar(
        mass = mass,
        from = place[i],
        to = place[i + 1],
        inertia = Cuboid(side, width, width)
    )),
    hinge: Each([Y, Z, X, Y, Z, X], |i, axis| Revolute(
        if i == 0 { ground } else { rod[i - 1] },
        if i == 5 { ground } else { rod[i] },
        at = place[i],
        axis = axis
    )),

    corner2: Output(rod[0].b),
    corner3: Output(rod[1].b),
    corner4: Output(rod[2].b),
    corner5: Output(rod[3].b),
});

const COLUMNS: &[(&str, &str)] = &[
    ("corner3.x", "p3x_m"),
    ("corner3.y", "p3y_m"),
    ("corner3.z", "p3z_m"),
    ("corner2.x", "p2x_m"),
    ("corner2.z", "p2z_m"),
    ("corner5.y", "p5y_m"),
];

/// The scene with rods of square section.
pub const SCENE: Scene = Scene {
    name: "bricard",
    title: "Bricard's mechanism, rods of square section",
    source: "IFToMM benchmark A04",
    model: Bricard::MODEL,
    duration: 10.0,
    step: 1e-2,
    reference: Some(Reference {
        file: "a04_bricard_square_rods.csv",
        columns: COLUMNS,
    }),
    build: crate::build_scene!(Bricard),
};

/// Rods of 3 mm.
const SLENDER: f64 = 3e-3;

/// The scene with slender rods.
pub const SLENDER_RODS: Scene = Scene {
    name: "bricard-slender",
    title: "Bricard's mechanism, slender rods",
    reference: Some(Reference {
        file: "a04_bricard_slender_rods.csv",
        columns: COLUMNS,
    }),
    build: crate::build_scene!(
        Bricard,
        Bricard {
            width: SLENDER,
            ..Bricard::default()
        }
    ),
    ..SCENE
};

/// The scene with six coordinates for each rod, and all rows.
pub const REFERENCE: Scene = Scene {
    name: "bricard-reference",
    title: "Bricard's mechanism, every joint as rows",
    model: BricardReference::MODEL,
    build: crate::build_scene!(BricardReference),
    ..SCENE
};
