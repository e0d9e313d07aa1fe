//! The joint reactions that belong to the equations at a state.

use super::Dynamics;
use crate::{SimulationError, System, UnknownName};
use nalgebra::SVector;

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Dynamics<S, Q, N, R> {
    /// [`Dynamics::evaluate`] with these inputs.
    pub(crate) fn follow(
        &mut self,
        inputs: &[f64],
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
    ) -> Result<(), SimulationError> {
        let own = self.system.inputs_mut().iter_mut();
        own.zip(inputs).for_each(|(own, input)| *own = *input);
        self.evaluate(t, q, v)
    }

    /// The joint reactions that belong to λ, in the order of [`Model::reactions`](crate::Model::reactions). Allocates
    /// nothing.
    pub fn reactions(&mut self) -> &[f64] {
        self.system.reactions(
            self.time,
            &self.positions,
            &self.velocities,
            &self.accelerations,
            &self.multipliers,
            &mut self.reactions,
        );
        &self.reactions
    }

    /// One component of a joint's reaction, as [`Simulation::reaction`](crate::Simulation::reaction). Allocates nothing.
    ///
    /// # Errors
    /// An unknown joint, or one without this component.
    pub fn reaction(&mut self, joint: &str, component: &str) -> Result<f64, UnknownName> {
        let index = S::MODEL.reaction_index(joint, component)?;
        // As many values as the model names.
        Ok(self.reactions().get(index).copied().unwrap_or(f64::NAN))
    }
}
