//! Inputs and outputs: as fields, and by name for tools.

use super::Simulation;
use super::refused::Refused;
use crate::acceleration_level::outputs;
use crate::{NamedValues, SimulationError, System, UnknownName};
use std::ops::{Deref, DerefMut};

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// The `Output`s at the current instant as fields, each with its unit in its documentation. Allocates nothing, but
    /// for outputs that read accelerations or reactions if there are more than 16 velocities or rows, or a singular pose
    /// is near.
    pub fn outputs(&self) -> S::Outputs {
        S::Outputs::from_values(|values| outputs(self.system(), self.state(), values))
    }

    /// The current values of the `Input`s as fields.
    pub fn inputs(&self) -> S::Inputs {
        let current = self.system().inputs();
        S::Inputs::from_values(|inputs| copy(current, inputs))
    }

    /// The `Input`s as fields to be set: `simulation.inputs_mut().torque = 2.0`. They take effect when the returned
    /// value goes out of scope. If one of them is NaN or infinite, all keep their values and the next step returns the error, unless
    /// this one was set again before; [`Simulation::set_inputs`] and [`Simulation::set_input`] return it immediately.
    ///
    /// Where a `Drive` follows one of them, its new value takes a new pose, which allocates some twenty times, and another input of
    /// this mechanism allocates twice. Where no drive follows an input, inputs allocate nothing.
    pub fn inputs_mut(&mut self) -> InputsMut<'_, S, Q, N, R> {
        let refused = self.refused.as_ref().map(|refused| refused.inputs);
        InputsMut {
            values: refused.unwrap_or_else(|| self.inputs()),
            simulation: self,
        }
    }

    /// The value of an `Input`, in the unit that [`Model::inputs`](crate::Model::inputs) tells.
    ///
    /// # Errors
    /// No input has this name.
    pub fn input(&self, name: &str) -> Result<f64, UnknownName> {
        let index = find(
            "input",
            name,
            S::MODEL.inputs.iter().map(|input| input.name),
        )?;
        Ok(self
            .system()
            .inputs()
            .get(index)
            .copied()
            .unwrap_or(f64::NAN))
    }

    /// Sets an `Input` from now on, and with it those that [`Simulation::inputs_mut`] was given beside a value that was refused, if this
    /// was the last of such values. Allocates as [`Simulation::inputs_mut`].
    ///
    /// # Errors
    /// No input has this name, or the value is NaN or infinite. A `Drive` follows the input to where no pose, or no velocities,
    /// satisfy the rows, or forces are not finite; then the input keeps its value.
    pub fn set_input(&mut self, name: &str, value: f64) -> Result<(), SimulationError> {
        let index = find(
            "input",
            name,
            S::MODEL.inputs.iter().map(|input| input.name),
        )?;
        if !value.is_finite() {
            // The model names as many inputs as were found.
            let name = S::MODEL.inputs.get(index).map_or("", |input| input.name);
            return Err(SimulationError::Input { name, value });
        }
        if let Some(before) = self.refused.take() {
            let inputs = with(before.inputs, index, value);
            let Err(error) = self.set_inputs(inputs) else {
                return Ok(());
            };
            let alone = self.set_one(index, value);
            self.refused = Some(match alone {
                Ok(()) => Refused { error, inputs },
                Err(_) => before,
            });
            return alone;
        }
        self.set_one(index, value)
    }

    /// Sets an input to a finite value.
    fn set_one(&mut self, index: usize, value: f64) -> Result<(), SimulationError> {
        // Of a value that it has already the motion takes no note.
        if self.system().inputs().get(index) == Some(&value) {
            return Ok(());
        }
        let before = self.driving_inputs();
        if let Some(input) = self.integrator.system_mut().inputs_mut().get_mut(index) {
            *input = value;
        }
        self.inputs_changed(&before)
    }

    /// Sets all `Input`s from now on, at once, or none.
    ///
    /// # Errors
    /// A value that is NaN or infinite, with the name of its input; otherwise as [`Simulation::set_input`].
    pub fn set_inputs(&mut self, inputs: S::Inputs) -> Result<(), SimulationError> {
        inputs.with_values(|values| self.set_input_values(values))
    }

    /// The current values of all `Input`s, in the order and units of [`Model::inputs`](crate::Model::inputs).
    pub fn input_values(&self) -> Vec<f64> {
        self.system().inputs().to_vec()
    }

    /// Sets all `Input`s from now on, at once, in the order of [`Model::inputs`](crate::Model::inputs), or none.
    ///
    /// # Errors
    /// Another number of values than of inputs; otherwise as [`Simulation::set_inputs`].
    pub fn set_input_values(&mut self, values: &[f64]) -> Result<(), SimulationError> {
        if values.len() != S::MODEL.inputs.len() {
            return Err(SimulationError::Setting {
                name: "number of inputs",
                value: values.len() as f64,
                wanted: "as many values as the mechanism has inputs",
            });
        }
        let mut named = values.iter().zip(S::MODEL.inputs);
        if let Some((&value, input)) = named.find(|(value, _)| !value.is_finite()) {
            return Err(SimulationError::Input {
                name: input.name,
                value,
            });
        }
        if self.system().inputs() != values {
            let before = self.driving_inputs();
            copy(values, self.integrator.system_mut().inputs_mut());
            self.inputs_changed(&before)?;
        }
        self.refused = None;
        Ok(())
    }

    /// Returns the error of inputs that [`Self::inputs_mut`] was given, once.
    pub(super) fn check_inputs(&mut self) -> Result<(), SimulationError> {
        // `take` alone would move a place for an error in every step.
        match self.refused.is_some() {
            true => (self.refused.take()).map_or(Ok(()), |refused| Err(refused.error)),
            false => Ok(()),
        }
    }

    fn inputs_changed(&mut self, before: &[f64]) -> Result<(), SimulationError> {
        self.integrator.state_mut().forget_factors();
        if let Err(error) = self.follow_inputs(before) {
            copy(before, self.integrator.system_mut().inputs_mut());
            self.integrator.refresh(&self.settings)?;
            return Err(error);
        }
        self.integrator.note_inputs();
        self.integrator.refresh(&self.settings)?;
        self.take_stock();
        // The last step belongs to the motion with the old input.
        self.last_step_start.time = f64::INFINITY;
        Ok(())
    }

    /// The value of an `Output`, in the unit that [`Model::outputs`](crate::Model::outputs) tells. Allocates as
    /// [`Self::outputs`].
    ///
    /// # Errors
    /// No output has this name.
    pub fn output(&self, name: &str) -> Result<f64, UnknownName> {
        let index = find(
            "output",
            name,
            S::MODEL.outputs.iter().map(|output| output.name),
        )?;
        let of_index = |outputs: &[f64]| outputs.get(index).copied();
        Ok(self.outputs().with_values(of_index).unwrap_or(f64::NAN))
    }

    /// All `Output`s, in the order and units of [`Model::outputs`](crate::Model::outputs).
    pub fn output_values(&self) -> Vec<f64> {
        let mut values = vec![0.0; S::MODEL.outputs.len()];
        outputs(self.system(), self.state(), &mut values);
        values
    }
}

/// The inputs of a simulation as fields; made by [`Simulation::inputs_mut`].
pub struct InputsMut<'a, S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    simulation: &'a mut Simulation<S, Q, N, R>,
    values: S::Inputs,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Deref
    for InputsMut<'_, S, Q, N, R>
{
    type Target = S::Inputs;
    fn deref(&self) -> &S::Inputs {
        &self.values
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> DerefMut
    for InputsMut<'_, S, Q, N, R>
{
    fn deref_mut(&mut self) -> &mut S::Inputs {
        &mut self.values
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Drop
    for InputsMut<'_, S, Q, N, R>
{
    fn drop(&mut self) {
        let simulation = &mut *self.simulation;
        let outcome = self
            .values
            .with_values(|values| simulation.set_input_values(values));
        if let Err(error) = outcome {
            let inputs = self.values;
            simulation.refused = Some(Refused { error, inputs });
        }
    }
}

fn copy(from: &[f64], to: &mut [f64]) {
    for (to, from) in to.iter_mut().zip(from) {
        *to = *from;
    }
}

/// The place of a name in a list of the model.
pub(super) fn find(
    what: &'static str,
    name: &str,
    known: impl Iterator<Item = &'static str> + Clone,
) -> Result<usize, UnknownName> {
    known
        .clone()
        .position(|candidate| candidate == name)
        .ok_or_else(|| UnknownName::new(what, name, known))
}

/// Inputs of which one has another value.
fn with<I: NamedValues + Copy>(inputs: I, index: usize, value: f64) -> I {
    I::from_values(|values| {
        inputs.with_values(|known| copy(known, values));
        if let Some(input) = values.get_mut(index) {
            *input = value;
        }
    })
}
