//! Drives that follow inputs.

use super::Simulation;
use crate::energy::total;
use crate::sink::Discard;
use crate::{SimulationError, State, System, ThreeFields};
use nalgebra::SVector;

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// Whether rows may follow inputs.
    pub(super) const DRIVEN: bool = S::STRUCTURE.rheonomic && R > 0;

    /// The inputs before they change, where rows may follow them; otherwise nothing.
    pub(super) fn driving_inputs(&self) -> Vec<f64> {
        match const { Self::DRIVEN } {
            true => self.system().inputs().to_vec(),
            false => Vec::new(),
        }
    }

    /// Moves the mechanism to where its rows are with the new inputs. The energy that it gains is work of the drives.
    ///
    /// # Errors
    /// As [`jump`](crate::assembly::jump).
    pub(super) fn follow_inputs(&mut self, before: &[f64]) -> Result<(), SimulationError> {
        if const { !Self::DRIVEN } || !self.rows_differ(before) {
            return Ok(());
        }
        let mut state: State<Q, N, R> = self.state().clone();
        crate::assembly::jump(self.system(), &self.settings, &mut state)?;
        state.ledger.drive_work +=
            total(self.system(), &state) - total(self.system(), self.state());
        // Momenta of the old velocities.
        state.fields = ThreeFields::default();
        self.integrator.state_mut().copy_from(&state);
        self.balance = self.energy();
        Ok(())
    }

    /// Whether φ or b is another one than with the inputs before.
    fn rows_differ(&mut self, before: &[f64]) -> bool {
        let now = self.rows();
        let inputs = self.system().inputs().to_vec();
        self.integrator
            .system_mut()
            .inputs_mut()
            .copy_from_slice(before);
        let then = self.rows();
        self.integrator
            .system_mut()
            .inputs_mut()
            .copy_from_slice(&inputs);
        now != then
    }

    /// φ and b at the current instant.
    fn rows(&self) -> [SVector<f64, R>; 2] {
        let (mut phi, mut b) = (SVector::zeros(), SVector::zeros());
        let (t, q) = (self.time(), self.positions());
        self.system()
            .constraints(t, q, &mut phi, &mut Discard, &mut b);
        [phi, b]
    }
}
