//! The scenes, one module each. Those after the first ones are compiled with the feature `laboratory`.

#[cfg(feature = "laboratory")]
pub mod andrews;
#[cfg(feature = "laboratory")]
pub mod bricard;
#[cfg(feature = "laboratory")]
pub mod cardan_shaft;
#[cfg(feature = "laboratory")]
pub mod chaplygin_sleigh;
pub mod double_four_bar;
#[cfg(feature = "laboratory")]
pub mod double_pendulum;
#[cfg(feature = "laboratory")]
pub mod driven_slider_crank;
#[cfg(feature = "laboratory")]
pub mod flyball_governor;
#[cfg(feature = "laboratory")]
pub mod four_bar_10;
#[cfg(feature = "laboratory")]
pub mod four_bar_40;
#[cfg(feature = "laboratory")]
pub mod heavy_top;
#[cfg(feature = "laboratory")]
pub mod knife_edge;
#[cfg(feature = "laboratory")]
pub mod laboratory;
#[cfg(feature = "laboratory")]
pub mod paper;
#[cfg(feature = "laboratory")]
pub mod passages;
pub mod pendulum;
#[cfg(feature = "laboratory")]
pub mod rattleback;
#[cfg(feature = "laboratory")]
pub mod rolling_disk;
pub mod slider_crank;
#[cfg(feature = "laboratory")]
pub mod spherical_pendulum;
#[cfg(feature = "laboratory")]
pub mod tuning;

use crate::scene::Scene;

/// All scenes of this build, in the order in which they are listed.
pub fn scenes() -> &'static [Scene] {
    SCENES
}

// A static: programs that use the list must not compile all scenes again.
static SCENES: &[Scene] = &[
    pendulum::SCENE,
    pendulum::BY_ANGLE,
    #[cfg(feature = "laboratory")]
    double_pendulum::SCENE,
    slider_crank::SCENE,
    #[cfg(feature = "laboratory")]
    driven_slider_crank::SCENE,
    double_four_bar::SCENE,
    #[cfg(feature = "laboratory")]
    four_bar_10::SCENE,
    #[cfg(feature = "laboratory")]
    four_bar_40::SCENE,
    #[cfg(feature = "laboratory")]
    andrews::SCENE,
    #[cfg(feature = "laboratory")]
    andrews::IFTOMM,
    #[cfg(feature = "laboratory")]
    chaplygin_sleigh::SCENE,
    #[cfg(feature = "laboratory")]
    knife_edge::SCENE,
    #[cfg(feature = "laboratory")]
    knife_edge::MOVING,
    #[cfg(feature = "laboratory")]
    spherical_pendulum::SCENE,
    #[cfg(feature = "laboratory")]
    heavy_top::SCENE,
    #[cfg(feature = "laboratory")]
    bricard::SCENE,
    #[cfg(feature = "laboratory")]
    bricard::SLENDER_RODS,
    #[cfg(feature = "laboratory")]
    bricard::REFERENCE,
    #[cfg(feature = "laboratory")]
    flyball_governor::SCENE,
    #[cfg(feature = "laboratory")]
    cardan_shaft::SCENE,
    #[cfg(feature = "laboratory")]
    rolling_disk::SCENE,
    #[cfg(feature = "laboratory")]
    rolling_disk::TILTED,
    #[cfg(feature = "laboratory")]
    rattleback::SCENE,
];
