//! The mechanisms of the page, as the scenes declare them.
//!
//! The files are those of `mbs-examples`, compiled once more: that library also has the command line and twenty other
//! scenes, which must not be in the module. Variants of a scene that are not shown are not in the module either.

use crate::scene::Scene;

#[path = "../../src/scenes/bricard.rs"]
#[allow(dead_code)]
mod bricard;
#[path = "../../src/scenes/pendulum.rs"]
#[allow(dead_code)]
mod pendulum;
#[path = "../../src/scenes/slider_crank.rs"]
#[allow(dead_code)]
mod slider_crank;

/// A scene, and the ranges of its parameters on the page.
#[derive(Debug)]
pub struct Mechanism {
    /// The scene.
    pub scene: Scene,
    /// The step at which the page begins, s: a motion that looks smooth, and an error that can be seen.
    pub step: f64,
    /// The least and the largest value of each parameter, in the order of the declaration, SI.
    pub ranges: &'static [[f64; 2]],
    /// The parameters that are angles in radians; to the model they are numbers without a unit.
    pub angles: &'static [&'static str],
}

/// All mechanisms; the page uses the names of their scenes.
pub static MECHANISMS: [Mechanism; 3] = [
    Mechanism {
        scene: pendulum::SCENE,
        step: 2e-2,
        ranges: &[[0.2, 3.0], [0.1, 10.0]],
        angles: &[],
    },
    Mechanism {
        scene: slider_crank::SCENE,
        step: 1e-2,
        ranges: &[[0.2, 3.0], [0.1, 10.0], [0.1, 1.5], [0.0, 10.0]],
        angles: &["start"],
    },
    Mechanism {
        scene: bricard::SCENE,
        step: 2e-2,
        ranges: &[[0.2, 3.0], [0.1, 10.0], [0.003, 0.4]],
        angles: &[],
    },
];
