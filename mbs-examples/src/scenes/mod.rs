//! The scenes, one module each.

pub mod andrews;
pub mod bricard;
pub mod cardan_shaft;
pub mod chaplygin_sleigh;
pub mod double_four_bar;
pub mod double_pendulum;
pub mod driven_slider_crank;
pub mod flyball_governor;
pub mod four_bar_10;
pub mod four_bar_40;
pub mod heavy_top;
pub mod knife_edge;
pub mod laboratory;
pub mod paper;
pub mod pendulum;
pub mod rattleback;
pub mod rolling_disk;
pub mod slider_crank;
pub mod spherical_pendulum;
pub mod tuning;

use crate::scene::Scene;

/// All scenes, in the order in which they are listed.
pub fn scenes() -> &'static [Scene] {
    SCENES
}

// A static: programs that use the list must not compile all scenes again.
static SCENES: &[Scene] = &[
    pendulum::SCENE,
    pendulum::BY_ANGLE,
    double_pendulum::SCENE,
    slider_crank::SCENE,
    driven_slider_crank::SCENE,
    double_four_bar::SCENE,
    four_bar_10::SCENE,
    four_bar_40::SCENE,
    andrews::SCENE,
    andrews::IFTOMM,
    chaplygin_sleigh::SCENE,
    knife_edge::SCENE,
    knife_edge::MOVING,
    spherical_pendulum::SCENE,
    heavy_top::SCENE,
    bricard::SCENE,
    bricard::SLENDER_RODS,
    bricard::REFERENCE,
    flyball_governor::SCENE,
    cardan_shaft::SCENE,
    rolling_disk::SCENE,
    rolling_disk::TILTED,
    rattleback::SCENE,
];
