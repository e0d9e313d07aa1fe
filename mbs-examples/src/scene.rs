//! A scene: a mechanism, the duration of a run, and the reference to compare it with.

use mbs_runtime::{AnySimulation, Model, Settings, SimulationError};

/// Makes a simulation of a mechanism from parameters by name.
pub type Build = fn(&[(String, f64)], Settings) -> Result<Box<dyn AnySimulation>, SimulationError>;

/// A mechanism of the command line.
#[derive(Debug, Clone, Copy)]
pub struct Scene {
    /// Its name on the command line, for example `slider-crank`.
    pub name: &'static str,
    /// A title of one line.
    pub title: &'static str,
    /// Source of the numbers.
    pub source: &'static str,
    /// The model.
    pub model: &'static Model,
    /// Simulated time by default, s.
    pub duration: f64,
    /// Step by default, s.
    pub step: f64,
    /// Reference values, if there are any for the default parameters.
    pub reference: Option<Reference>,
    /// Makes the simulation; [`build_scene!`](crate::build_scene) writes this function.
    pub build: Build,
}

/// A table of reference values.
#[derive(Debug, Clone, Copy)]
pub struct Reference {
    /// File name, for example `a01_pendulum_10s.csv`; its column `time_s` is the time.
    pub file: &'static str,
    /// Pairs of the name of an `Output` and the name of the column that it should equal.
    pub columns: &'static [(&'static str, &'static str)],
}

/// The [`Build`] function of a mechanism type, from its default parameters or from others. Which methods are compiled
/// with it is the choice of `start` of the crate.
#[macro_export]
macro_rules! build_scene {
    ($mechanism:ty) => {
        $crate::build_scene!(
            $mechanism,
            <$mechanism as ::std::default::Default>::default()
        )
    };
    ($mechanism:ty, $start:expr) => {
        |parameters, settings| {
            let mut mechanism: $mechanism = $start;
            for (name, value) in parameters {
                ::mbs_runtime::Mechanism::set_parameter(&mut mechanism, name, *value)
                    .map_err(::mbs_runtime::SimulationError::UnknownName)?;
            }
            $crate::start(mechanism, settings)
        }
    };
}
