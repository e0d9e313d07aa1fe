//! Parameters that change during a run.

use super::Simulation;
use crate::assembly::refit;
use crate::energy::total;
use crate::yardstick::Yardstick;
use crate::{
    AssemblyVerdict, KnownPoses, Mechanism, PosesAhead, SimulationError, State, System, ThreeFields,
};

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// Goes on from the current instant with other parameters:
    ///
    /// ```
    /// # use mbs_runtime::{Simulation, mechanism};
    /// mechanism!(Hoist {
    ///     world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    ///     load: Param(20.0_kg),
    ///     hook: Particle(mass = load, at = [0.0_m, -2.0_m]),
    ///     rope: SpringDamper(ground.origin, hook, stiffness = 8.0_kN_per_m, damping = 500.0_N_s_per_m, length = 2.0_m),
    ///     height: Output(hook.origin.y),
    /// });
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let mut hoist = Simulation::new(Hoist { load: 20.0 })?;
    /// hoist.run_until(5.0)?;
    /// hoist.set_parameters(Hoist { load: 200.0 })?;
    /// hoist.run_until(20.0)?;
    /// assert!((hoist.outputs().height - (-2.0 - 200.0 * 9.81 / 8000.0)).abs() < 1e-4);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// Coordinates and their rates stay what they are. So all points keep their positions and velocities, if their places in the bodies
    /// stay, with one exception: the coordinates of a body are those of its centre of mass, unless a joint carries it in joint
    /// coordinates. With another `center_of_mass` the centre stays where it is, and the points of such a body move by −R Δc.
    ///
    /// Where the rows do not allow the positions and velocities, because a length has changed, the mechanism follows at once, to the
    /// nearest pose and the nearest velocities, and the verdict says what has moved. The energy that the mechanism gains counts as
    /// nonconservative work, so that its balance goes on. Inputs and the sums of [`Simulation::report`] stay; methods with a memory
    /// ([`Method`](crate::Method)) begin anew. It allocates.
    ///
    /// # Errors
    /// Parameters that do not make a mechanism, [`SimulationError::NoPose`] where no pose satisfies the rows,
    /// [`SimulationError::Contradiction`] where no velocities do, forces or energies that are not finite, and
    /// [`SimulationError::Large`] where that takes dense arrays for which a stack has no room; the simulation
    /// then goes on with the parameters that it had.
    pub fn set_parameters<M: Mechanism<System = S>>(
        &mut self,
        mechanism: M,
    ) -> Result<AssemblyVerdict, SimulationError> {
        let mut system = mechanism.prepare()?;
        system.inputs_mut().copy_from_slice(self.system().inputs());
        // In parts, whose frames are not on the stack together: without optimisation each move of a large state is a copy.
        let (state, verdict) = self.refitted(&system)?;
        self.renew(system, &state, verdict.clone())?;
        Ok(verdict)
    }

    /// The current state where it satisfies the rows of another system, without what belongs to this one.
    #[inline(never)]
    fn refitted(
        &self,
        system: &S,
    ) -> Result<(Box<State<Q, N, R>>, AssemblyVerdict), SimulationError> {
        let before = self.state();
        let mut state = before.boxed_copy();
        state.forget_factors();
        // Momenta of the old masses, energies of the old forces, and a speed in the old size.
        state.fields = ThreeFields::default();
        state.ledger.range = None;
        let length = Yardstick::new(system, self.settings.step).length;
        state.step_controller.speed *= self.yardstick.length / length;
        state.poses_ahead = PosesAhead::default();
        state.known_poses = KnownPoses::none();
        // The difficulties of another motion.
        state.step_controller.estimated_difficulty = None;
        state.step_controller.difficulty = None;
        state.step_controller.estimate_factor = 0.0;
        let verdict = refit(system, &self.settings, &mut state)?;
        state.ledger.nonconservative_work += total(system, &state) - total(self.system(), before);
        Ok((state, verdict))
    }

    /// Goes on with another system and state.
    #[inline(never)]
    fn renew(
        &mut self,
        system: S,
        state: &State<Q, N, R>,
        verdict: AssemblyVerdict,
    ) -> Result<(), SimulationError> {
        match Self::from_state(system, self.settings, state.clone(), verdict, self.other) {
            Ok(mut renewed) => {
                renewed.take_over(self);
                renewed.revision = self.revision.wrapping_add(1);
                // The works so far stay in the balance.
                let range = &mut renewed.integrator.state_mut().ledger.range;
                if let (Some(range), Some(before)) = (range, &self.state().ledger.range) {
                    (range.doubts, range.exchanged) = (before.doubts, before.exchanged);
                }
                *self = renewed;
                Ok(())
            }
            Err(error) => Err(error),
        }
    }

    /// After the method changed: the same, and what does not depend on it.
    pub(super) fn take_over_motion(&mut self, before: &mut Self) {
        self.take_over(before);
        std::mem::swap(&mut self.singularities, &mut before.singularities);
        std::mem::swap(&mut self.last_step_start, &mut before.last_step_start);
        // What an event goes back to belongs to this method.
        self.last_step_start.step_controller = self.state().step_controller;
        self.last_step_start.fields = self.state().fields;
    }

    /// Sums over the run from before the parameters changed.
    fn take_over(&mut self, before: &mut Self) {
        let power = self.books.power;
        self.books = before.books;
        self.books.power = power;
        (self.rejected, self.placed) = (before.rejected, before.placed);
        self.counted = before.counters();
        self.singularities.take_over(&before.singularities);
        self.refused = before.refused.take();
        self.choice = before.choice.take();
        self.revision = before.revision;
    }
}
