//! The scenes, one module each.

mod double_four_bar;
mod pendulum;
mod slider_crank;

use crate::scene::Scene;

/// All scenes, in the order in which they are listed.
pub fn scenes() -> &'static [Scene] {
    SCENES
}

const SCENES: &[Scene] = &[
    pendulum::SCENE,
    pendulum::BY_ANGLE,
    slider_crank::SCENE,
    double_four_bar::SCENE,
];
