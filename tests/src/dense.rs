//! A mechanism without the elimination that was planned for it: its equations are solved with dense arrays.

use crate::tampered::Tampered;
use mbs_runtime::{Mechanism, Model, ParameterError, UnknownName};

/// The same mechanism.
#[derive(Debug, Clone, Default)]
pub struct Dense<M>(pub M);

impl<M: Mechanism> Mechanism for Dense<M> {
    type System = Tampered<M::System>;
    const MODEL: &'static Model = M::MODEL;

    fn prepare(&self) -> Result<Self::System, ParameterError> {
        Ok(Tampered::new(self.0.prepare()?, "nothing"))
    }
    fn parameter(&self, name: &str) -> Option<f64> {
        self.0.parameter(name)
    }
    fn set_parameter(&mut self, name: &str, value: f64) -> Result<(), UnknownName> {
        self.0.set_parameter(name, value)
    }
}
