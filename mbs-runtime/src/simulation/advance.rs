//! One step, in parts where it does not converge, and what is known after it.
//!
//! ```text
//! guarded_step ─▶ step_past_poses ─▶ placed_step ─▶ advance ─▶ Integrator::step
//! energy          turns ahead        clearance      halves
//! ```
//!
//! Each function takes the step by the next one, looks at what its name says, and takes it again in another length where
//! that is needed.

use super::Simulation;
use super::books::Books;
use crate::alf3f::StepMonitor;
use crate::integrator::Integrator;
use crate::linear::largest;
use crate::singular::RankMargin;
use crate::{Energy, SimulationError, System};
use nalgebra::SVector;

/// How often a step that does not converge is halved before it is given up.
pub(super) const HALVINGS: u32 = 8;

/// All that steps change beside the states, to be restored after a look at other instants.
pub(super) struct Kept<const R: usize> {
    pub(super) books: Books,
    rejected: u64,
    placed: u64,
    rank_margin: Option<RankMargin>,
    balance: Energy,
    multipliers: Option<SVector<f64, R>>,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// One step of h: halved where it does not converge. Returns its clearance from singular poses.
    pub(crate) fn advance(&mut self, h: f64) -> Result<f64, SimulationError> {
        let known = self.rank_margin;
        let rank_margin = known.or_else(|| self.integrator.rank_margin());
        let mut monitor = StepMonitor::new(self.books.power, rank_margin);
        let halvings = if self.is_paced_by_estimates() {
            0
        } else {
            HALVINGS
        };
        if let Err(error) = self.halving(h, halvings, &mut monitor) {
            self.rank_margin = None;
            return Err(error);
        }
        self.rank_margin = monitor.rank_margin;
        self.multipliers_before = None;
        self.books.steps += 1;
        Ok(monitor.clearance)
    }

    fn halving(
        &mut self,
        h: f64,
        left: u32,
        monitor: &mut StepMonitor,
    ) -> Result<(), SimulationError> {
        let start = (self.state().time, self.state().clock);
        match self.integrator.step(h, monitor) {
            Ok(()) => {
                self.integrator.state_mut().count(start, h);
                self.books.shortest = self.books.shortest.min(h.abs());
                self.keep_books(monitor);
                Ok(())
            }
            Err(error) if error.asks_for_less() && left > 0 => {
                self.rejected += 1;
                // The halves of a step may also end beside the singular pose, so that other lengths are tried first.
                let watched = monitor.rank_margin.is_some() || monitor.clearance == 0.0;
                *monitor = StepMonitor::new(self.books.power, None);
                if watched {
                    monitor.clearance = 0.0;
                }
                self.halving(0.5 * h, left - 1, monitor)?;
                self.halving(0.5 * h, left - 1, monitor)
            }
            Err(error) => Err(error),
        }
    }

    /// Work and errors of the step just taken.
    fn keep_books(&mut self, monitor: &mut StepMonitor) {
        let trace = self.integrator.trace();
        let holonomic = largest(trace.phi);
        let velocity = largest(&trace.rates);
        self.books.holonomic_error = self.books.holonomic_error.max(holonomic);
        self.books.velocity_error = self.books.velocity_error.max(velocity);
        self.books.power = monitor.power;
        let ledger = &mut self.integrator.state_mut().ledger;
        let work = std::mem::take(&mut monitor.nonconservative_work);
        let drive_work = std::mem::take(&mut monitor.drive_work);
        ledger.nonconservative_work += work;
        ledger.drive_work += drive_work;
        let doubt = std::mem::take(&mut monitor.work_doubt);
        if let Some(range) = &mut ledger.range {
            range.doubt(doubt);
            range.exchange(work.abs() + drive_work.abs());
        }
        self.balance = self.energy();
        self.books.energy_error = self.books.energy_error.max(self.balance.error.abs());
    }

    /// Quantities of the current instant for the energy balance of the next step.
    pub(super) fn take_stock(&mut self) {
        self.rank_margin = None;
        let state = self.state();
        self.books.power =
            self.system()
                .nonconservative_power(state.time, &state.positions, &state.velocities);
    }

    /// The integrator of a method with a memory of earlier steps, which a copy of the state does not have.
    pub(super) fn memory(&self) -> Option<Integrator<S, Q, N, R>> {
        (self.settings.method.has_memory()).then(|| self.integrator.clone())
    }

    /// What [`Simulation::restore`] takes back.
    pub(super) fn keep(&self) -> Kept<R> {
        Kept {
            books: self.books,
            rejected: self.rejected,
            placed: self.placed,
            rank_margin: self.rank_margin,
            balance: self.balance,
            multipliers: self.step_multipliers(),
        }
    }

    /// After the state was copied back.
    pub(super) fn restore(&mut self, kept: Kept<R>) -> Result<(), SimulationError> {
        self.put_back(kept);
        self.integrator.refresh(&self.settings)
    }

    /// The same after the whole integrator was put back.
    pub(super) fn put_back(&mut self, kept: Kept<R>) {
        self.books = kept.books;
        (self.rejected, self.placed) = (kept.rejected, kept.placed);
        (self.rank_margin, self.balance) = (kept.rank_margin, kept.balance);
        self.multipliers_before = Some(kept.multipliers);
    }
}
