//! States by name.

use super::Simulation;
use super::access::find;
use crate::{ScalarState, SimulationError, System, UnknownName};

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// The value of a `State`, in the unit that [`Observables::STATES`](crate::Observables::STATES) tells. It is also a
    /// field of [`Simulation::outputs`].
    ///
    /// # Errors
    /// No state has this name.
    pub fn state_value(&self, name: &str) -> Result<f64, UnknownName> {
        let state = Self::state_named(name)?;
        Ok(self.velocities()[state.velocity])
    }

    /// Sets a `State` at the current instant: the integral of a controller back to zero, for example. Positions,
    /// velocities and the energy balance stay as they are.
    ///
    /// # Errors
    /// No state has this name, or the value is NaN or infinite.
    pub fn set_state_value(&mut self, name: &str, value: f64) -> Result<(), SimulationError> {
        let state = Self::state_named(name)?;
        if !value.is_finite() {
            let name = state.quantity.name;
            return Err(SimulationError::Input { name, value });
        }
        let current = self.integrator.state_mut();
        current.velocities[state.velocity] = value;
        // With the 1 of M it is its own momentum.
        current.fields.momentum[state.velocity] = value;
        self.integrator.refresh(&self.settings)?;
        self.take_stock();
        // The last step belongs to the motion with the old value.
        self.last_step_start.time = f64::INFINITY;
        Ok(())
    }

    fn state_named(name: &str) -> Result<&'static ScalarState, UnknownName> {
        let names = S::STATES.iter().map(|state| state.quantity.name);
        let index = find("state", name, names)?;
        Ok(&S::STATES[index])
    }
}
