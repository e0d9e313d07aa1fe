//! Which methods a program compiles for a mechanism, beside the two-level one.
//!
//! Each method is code of its own for each mechanism. A program that runs one of them names it:
//!
//! ```
//! use mbs_runtime::{Method, Settings, Simulation, mechanism, methods};
//!
//! mechanism!(Pendulum {
//!     world: Planar(gravity = [0.0, -9.81_m_per_s2]),
//!     bar: Bar(mass = 1.0_kg, length = 1.0_m),
//!     pivot: Revolute(ground.origin, bar.a),
//! });
//!
//! let settings = Settings { method: Method::Projected, order: 8, step: 0.02, ..Settings::default() };
//! let mut simulation = Simulation::with_methods(Pendulum::default(), settings, methods::Projected)?;
//! simulation.run_until(1.0)?;
//! # Ok::<(), mbs_runtime::SimulationError>(())
//! ```

use crate::baselines::{self, registry};
use crate::stepper::AnyStepper;
use crate::{BaselineStepper, Method, PaperStepper, Settings, SimulationError, State, System};

/// Methods that are compiled beside the two-level one: a type of this module.
pub trait Methods: compiled::Make {}

impl<C: compiled::Make> Methods for C {}

pub(crate) mod compiled {
    use super::{AnyStepper, Settings, SimulationError, State, System};

    /// How a simulation begins with a method other than the two-level one.
    pub trait Make {
        /// The stepper of the method of the settings, or an error that it is not compiled.
        #[allow(private_interfaces)]
        fn make<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
            system: S,
            state: State<Q, N, R>,
            settings: &Settings,
        ) -> Result<AnyStepper<S, Q, N, R>, SimulationError>;
    }
}

/// Methods by a rule of the baselines.
macro_rules! baselines {
    ($($(#[doc = $doc:literal])+ $name:ident: $rule:path;)+) => {
        $(
            $(#[doc = $doc])+
            #[derive(Debug, Clone, Copy)]
            pub struct $name;

            impl compiled::Make for $name {
                #[allow(private_interfaces)]
                fn make<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
                    system: S,
                    state: State<Q, N, R>,
                    settings: &Settings,
                ) -> Result<AnyStepper<S, Q, N, R>, SimulationError> {
                    let stepper = BaselineStepper::with($rule, system, state, settings)?;
                    Ok(Box::new(stepper))
                }
            }
        )+
    };
}

baselines! {
    /// [`Method::Projected`].
    Projected: baselines::Explicit::projected;
    /// [`Method::Baumgarte`].
    Baumgarte: registry::baumgarte;
    /// [`Method::Rattle`].
    Rattle: baselines::Rattle::rule;
    /// [`Method::Penalty`].
    Penalty: baselines::Penalty::rule;
    /// [`Method::Index3Projections`].
    Index3Projections: baselines::Index3::rule;
    /// [`Method::GeneralizedAlpha`].
    GeneralizedAlpha: baselines::GeneralizedAlpha::rule;
    /// [`Method::Bdf`].
    Bdf: baselines::Bdf::rule;
    /// [`Method::Radau`].
    Radau: baselines::Radau::rule;
    /// The candidates of [`Settings::accuracy`]: [`Method::Projected`] and, where forces depend on velocities and the mechanism is
    /// small, [`Method::Radau`].
    Accuracy: registry::accuracy;
}

/// Algorithm 1 of the paper and the modified augmented Lagrangian: [`Method::Paper`], [`Method::MAlf`].
#[derive(Debug, Clone, Copy)]
pub struct Paper;

impl compiled::Make for Paper {
    #[allow(private_interfaces)]
    fn make<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
        system: S,
        state: State<Q, N, R>,
        settings: &Settings,
    ) -> Result<AnyStepper<S, Q, N, R>, SimulationError> {
        match settings.method {
            Method::Paper(_) | Method::MAlf(_) => {
                Ok(Box::new(PaperStepper::new(system, state, settings)?))
            }
            method => Err(SimulationError::NotCompiled {
                method: method.name(),
            }),
        }
    }
}

/// Every [`Method`].
#[derive(Debug, Clone, Copy)]
pub struct Any;

impl compiled::Make for Any {
    #[allow(private_interfaces)]
    fn make<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
        system: S,
        state: State<Q, N, R>,
        settings: &Settings,
    ) -> Result<AnyStepper<S, Q, N, R>, SimulationError> {
        match settings.method {
            Method::Paper(_) | Method::MAlf(_) => Paper::make(system, state, settings),
            _ => Ok(Box::new(BaselineStepper::new(system, state, settings)?)),
        }
    }
}
