//! A start with values that the program holds.

use super::Simulation;
use crate::assembly::Wanted;
use crate::methods::Methods;
use crate::{Mechanism, Settings, SimulationError, System};

/// A start in preparation; made by [`Simulation::start`].
#[derive(Debug, Clone)]
#[must_use = "nothing starts before `begin`"]
pub struct Start<M> {
    mechanism: M,
    settings: Settings,
    wanted: Vec<Wanted>,
}

impl<M: Mechanism> Start<M> {
    /// From the declared guess of this mechanism, with default settings.
    pub fn of(mechanism: M) -> Self {
        Start {
            mechanism,
            settings: Settings::default(),
            wanted: Vec::new(),
        }
    }

    /// Holds a coordinate, velocity or `Output` at a value, in the unit that the model tells.
    ///
    /// A value that is stationary at the declared guess, as the height of an upright pendulum, is looked for on the positive side
    /// of the first velocity that changes it, and then on the negative one. For another branch declare another guess.
    pub fn hold(mut self, name: &str, value: f64) -> Self {
        self.wanted.push(Wanted {
            name: name.to_owned(),
            value,
            rate: false,
        });
        self
    }

    /// Holds the rate of a coordinate, or of an `Output` that is a function of positions.
    pub fn hold_rate(mut self, name: &str, value: f64) -> Self {
        self.wanted.push(Wanted {
            name: name.to_owned(),
            value,
            rate: true,
        });
        self
    }

    /// With these settings.
    pub fn settings(mut self, settings: Settings) -> Self {
        self.settings = settings;
        self
    }

    /// The simulation.
    ///
    /// # Errors
    /// As [`Simulation::with_settings`]; a name that the mechanism does not have, and values that cannot be held:
    /// [`SimulationError::Held`].
    pub fn begin<S, const Q: usize, const N: usize, const R: usize>(
        self,
    ) -> Result<Simulation<S, Q, N, R>, SimulationError>
    where
        M: Mechanism<System = S>,
        S: System<Q, N, R>,
    {
        Simulation::assembled::<M, true>(self.mechanism, self.settings, &self.wanted, None)
    }

    /// The same with methods beside the two-level one.
    ///
    /// # Errors
    /// As [`Start::begin`] and [`Simulation::with_methods`].
    pub fn begin_with_methods<S, C: Methods, const Q: usize, const N: usize, const R: usize>(
        self,
        _: C,
    ) -> Result<Simulation<S, Q, N, R>, SimulationError>
    where
        M: Mechanism<System = S>,
        S: System<Q, N, R>,
    {
        let methods = Simulation::other_methods::<C>();
        Simulation::assembled::<M, true>(self.mechanism, self.settings, &self.wanted, methods)
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// A start that holds initial values exactly; the rest follows from the declared guess.
    ///
    /// ```text
    /// let simulation = Simulation::start(SixBar::default())
    ///     .hold("crank_angle", 0.4)
    ///     .hold_rate("crank_angle", 9.0)
    ///     .begin()?;
    /// ```
    pub fn start<M: Mechanism<System = S>>(mechanism: M) -> Start<M> {
        Start::of(mechanism)
    }
}
