//! Mechanisms with a difficulty at which a simulation may fail: most pass singular poses on every turn, and some have a
//! second difficulty beside them. Parameters are the pose and the speed at the start, `phase` and `rate`, and the damping.
//! The maps of stability and the example `random_passages` run them; they are not in the list of scenes.
//!
//! Those with an output `astray` tell on which branch they are: it is zero in every pose of the motion that goes straight
//! on.

mod bricard;
mod bushing;
mod cranks;
mod in_space;
mod on_sleigh;
mod rotor;
mod shaken;
mod slider_crank;
mod spherical;

use crate::scene::Scene;
use bricard::Threefold;
pub use bushing::OnBushing;
pub use cranks::DoubleFourBar;
use cranks::{Pushed, Redundant};
use in_space::{ParallelogramByBodies, ParallelogramInSpace};
use mbs_runtime::{
    AnySimulation, Mechanism, Settings, Simulation, SimulationError, System, methods,
};
use on_sleigh::OnSleigh;
use rotor::FastRotor;
use shaken::Shaken;
use slider_crank::Driven;
pub use slider_crank::SliderCrank;

spherical::spherical!(Spherical, Auto);
spherical::spherical!(SphericalByBodies, Reference);

/// The output that is zero on the branch of the motion.
pub const ASTRAY: &str = "astray";

/// A scene of a mechanism, from its default parameters or from others.
macro_rules! scene {
    ($name:literal, $title:literal, $mechanism:ty) => {
        scene!($name, $title, $mechanism, <$mechanism>::default())
    };
    ($name:literal, $title:literal, $mechanism:ty, $start:expr) => {
        Scene {
            name: $name,
            title: $title,
            source: "made for the method laboratory",
            model: <$mechanism>::MODEL,
            duration: 10.0,
            step: 1e-3,
            reference: None,
            build: |parameters, settings| {
                start::<$mechanism, _, _, _, _>($start, parameters, settings)
            },
        }
    };
}

/// A simulation with the methods that [`Settings::accuracy`] chooses from.
fn start<M, S, const Q: usize, const N: usize, const R: usize>(
    mut mechanism: M,
    parameters: &[(String, f64)],
    settings: Settings,
) -> Result<Box<dyn AnySimulation>, SimulationError>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    for (name, value) in parameters {
        mechanism
            .set_parameter(name, *value)
            .map_err(SimulationError::UnknownName)?;
    }
    let simulation = Simulation::with_methods(mechanism, settings, methods::Accuracy)?;
    Ok(Box::new(simulation))
}

/// Rods of equal length.
pub static SLIDER_CRANK: Scene =
    scene!("slider-crank", "Slider-crank with equal rods", SliderCrank);
/// Two parallelograms.
pub static DOUBLE_FOUR_BAR: Scene = scene!(
    "double four-bar",
    "Three cranks and two couplers",
    DoubleFourBar
);
/// A row follows from the others.
pub static REDUNDANT: Scene = scene!(
    "three cranks, redundant",
    "Three cranks, two couplers and a rod over both",
    Redundant
);
/// In joint coordinates.
pub static IN_SPACE: Scene = scene!(
    "parallelogram in space",
    "Parallelogram in space",
    ParallelogramInSpace
);
/// The same by bodies.
pub static IN_SPACE_BY_BODIES: Scene = scene!(
    "the same by bodies",
    "Parallelogram in space by bodies",
    ParallelogramByBodies
);
/// In joint coordinates.
pub static SPHERICAL: Scene = scene!(
    "spherical linkage",
    "Spherical linkage that folds flat",
    Spherical
);
/// The same by bodies.
pub static SPHERICAL_BY_BODIES: Scene = scene!(
    "spherical by bodies",
    "Spherical linkage by bodies",
    SphericalByBodies
);
/// A row on time.
pub static DRIVEN: Scene = scene!(
    "driven slider-crank",
    "Slider-crank with equal rods and a drive",
    Driven
);
/// A row on time.
pub static SHAKEN: Scene = scene!(
    "on a shaken base",
    "Parallelogram on a base that a drive shakes",
    Shaken
);
/// A nonholonomic row.
pub static ON_SLEIGH: Scene = scene!(
    "on a knife edge",
    "Parallelogram on a sleigh with a knife edge",
    OnSleigh
);
/// Its input `push` is a torque.
pub static PUSHED: Scene = scene!(
    "torque that jumps",
    "Three cranks and two couplers, pushed",
    Pushed
);
/// The same with light couplers.
pub static LIGHT: Scene = scene!(
    "couplers of 0.1 g",
    "Three cranks and two light couplers, pushed",
    Pushed,
    Pushed {
        coupler_mass: 1e-4,
        ..Pushed::default()
    }
);
/// Without a singular pose.
pub static ROTOR: Scene = scene!("rotor of 1000 rad/s", "Fast rotor on a pendulum", FastRotor);
/// Without a singular pose.
pub static BUSHING: Scene = scene!(
    "stiff bushing",
    "Body on a bushing at a pendulum",
    OnBushing
);
/// Its poses form a curve that crosses another one.
pub static THREEFOLD: Scene = scene!(
    "Bricard's linkage",
    "Bricard's linkage of threefold symmetry",
    Threefold
);

/// The scenes with an output [`ASTRAY`].
pub static SCENES: [&Scene; 13] = [
    &SLIDER_CRANK,
    &DOUBLE_FOUR_BAR,
    &REDUNDANT,
    &IN_SPACE,
    &IN_SPACE_BY_BODIES,
    &SPHERICAL,
    &SPHERICAL_BY_BODIES,
    &DRIVEN,
    &SHAKEN,
    &ON_SLEIGH,
    &PUSHED,
    &LIGHT,
    &ROTOR,
];
