//! A declared mechanism: the type with the parameters.

use crate::{Model, ParameterError, UnknownName};

/// A declared mechanism: its parameters.
pub trait Mechanism: Clone + Default {
    /// The prepared form.
    type System: Clone;
    /// What was modelled.
    const MODEL: &'static Model;

    /// Checks the parameters and computes all that depends on them alone.
    ///
    /// # Errors
    /// A parameter that is not finite; a mass, inertia or length that follows from parameters and that no part has; or
    /// parameters for which M is constant and not positive definite.
    fn prepare(&self) -> Result<Self::System, ParameterError>;

    /// The parameter of this name.
    fn parameter(&self, name: &str) -> Option<f64>;

    /// Sets a parameter by name, in the SI unit that [`Model::parameters`](crate::Model::parameters) says. A value that makes no
    /// mechanism, or is not finite, is refused at the start of a simulation, not here.
    ///
    /// # Errors
    /// No parameter has this name.
    fn set_parameter(&mut self, name: &str, value: f64) -> Result<(), UnknownName>;
}
