//! The settings of the integration.

mod baumgarte;
mod bdf;
mod generalized_alpha;
mod paper;
mod penalty;
mod projections;

pub use baumgarte::BaumgarteSettings;
pub use bdf::BdfSettings;
pub use generalized_alpha::GeneralizedAlphaSettings;
pub use paper::{MultiplierStart, PaperSettings, RowDirection};
pub use penalty::PenaltySettings;
pub use projections::ProjectionSettings;

/// The orders of the two-level method.
pub(crate) const ORDERS: [u8; 4] = [2, 4, 6, 8];

/// The choice of the integrator.
///
/// BDF, Radau, RATTLE, generalized α, index 3 with projections, and Baumgarte's terms with error control have a memory: their
/// steps depend on more of the earlier ones than a [`State`](crate::State) has. They begin anew where a state is resumed.
/// [`Method::Penalty`] takes the stiffnesses of its rows from the pose in which it begins or is resumed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Method {
    /// Two-level ALF-3F: positions and velocities have separate multipliers.
    #[default]
    TwoLevel,
    /// Algorithm 1 of the paper.
    Paper(PaperSettings),
    /// The modified augmented Lagrangian that the paper compares with (section 7.2): the same algorithm with rows that have
    /// neither mass nor damping. Start from [`PaperSettings::m_alf`]: its penalties have another scale.
    MAlf(PaperSettings),
    /// Explicit Runge–Kutta on the index-1 form with Baumgarte's stabilisation; of order 4, 6 or 8.
    Baumgarte(BaumgarteSettings),
    /// The same without stabilisation: positions and velocities are projected onto the rows after each step, and the
    /// lengths of steps are chosen beside singular poses ([`Settings::placement`]). Over some seconds, with few rows
    /// and forces that are not stiff it often takes less processor time than [`Method::TwoLevel`] for the same
    /// accuracy; it is not symmetric, so that its energy drifts over long times.
    Projected,
    /// RATTLE without regularisation.
    Rattle,
    /// Rows as stiff springs and dampers.
    Penalty(PenaltySettings),
    /// Augmented Lagrangian of index 3 with projections of velocities and accelerations.
    Index3Projections(ProjectionSettings),
    /// The generalized-α method with position rows.
    GeneralizedAlpha(GeneralizedAlphaSettings),
    /// Backward differentiation of variable order and step with position rows. [`Settings::step`] bounds its steps.
    Bdf(BdfSettings),
    /// Radau IIA of three stages and order 5, with the rows of velocities at its stages and those of positions at its ends: stiff
    /// forces of velocity.
    Radau,
}

impl Method {
    /// The names on the command line.
    pub const NAMES: &'static [&'static str] = &[
        "two-level",
        "alf3f-paper",
        "m-alf",
        "index3-projections",
        "generalized-alpha",
        "bdf",
        "radau",
        "rattle",
        "baumgarte",
        "projected",
        "penalty",
    ];

    /// The method of this name, with default settings.
    pub fn by_name(name: &str) -> Option<Self> {
        Some(match name {
            "two-level" => Method::TwoLevel,
            "alf3f-paper" => Method::Paper(PaperSettings::default()),
            "m-alf" => Method::MAlf(PaperSettings::m_alf()),
            "baumgarte" => Method::Baumgarte(BaumgarteSettings::default()),
            "projected" => Method::Projected,
            "rattle" => Method::Rattle,
            "penalty" => Method::Penalty(PenaltySettings::default()),
            "index3-projections" => Method::Index3Projections(ProjectionSettings::default()),
            "generalized-alpha" => Method::GeneralizedAlpha(GeneralizedAlphaSettings::default()),
            "bdf" => Method::Bdf(BdfSettings::default()),
            "radau" => Method::Radau,
            _ => return None,
        })
    }

    /// Those of [`ORDERS`] that [`Settings::order`] may have, and why it may have no others.
    pub(crate) fn orders(&self) -> (&'static [u8], &'static str) {
        match self {
            Method::TwoLevel | Method::Projected => (&ORDERS, ""),
            Method::Baumgarte(settings) if settings.adaptive.is_some() => (
                &ORDERS[..2],
                "with error control the method has the pair of orders 5 and 4",
            ),
            Method::Baumgarte(_) => (&ORDERS, ""),
            Method::Paper(_) | Method::MAlf(_) => (
                &ORDERS[..1],
                "Algorithm 1 is dissipative and not symmetric, and stages that run back in time would undo that",
            ),
            Method::Rattle
            | Method::Penalty(_)
            | Method::Index3Projections(_)
            | Method::GeneralizedAlpha(_)
            | Method::Bdf(_)
            | Method::Radau => (&ORDERS[..1], "the method has an order of its own"),
        }
    }

    /// Whether steps depend on more of the earlier ones than the state has.
    pub(crate) fn has_memory(&self) -> bool {
        match self {
            Method::Index3Projections(_) | Method::GeneralizedAlpha(_) => true,
            Method::Bdf(_) | Method::Radau | Method::Rattle => true,
            Method::Baumgarte(settings) => settings.adaptive.is_some(),
            Method::TwoLevel | Method::Paper(_) | Method::MAlf(_) => false,
            Method::Projected | Method::Penalty(_) => false,
        }
    }

    /// The name on the command line, one of [`Method::NAMES`].
    pub fn name(&self) -> &'static str {
        match self {
            Method::TwoLevel => "two-level",
            Method::Paper(_) => "alf3f-paper",
            Method::MAlf(_) => "m-alf",
            Method::Baumgarte(_) => "baumgarte",
            Method::Projected => "projected",
            Method::Rattle => "rattle",
            Method::Penalty(_) => "penalty",
            Method::Index3Projections(_) => "index3-projections",
            Method::GeneralizedAlpha(_) => "generalized-alpha",
            Method::Bdf(_) => "bdf",
            Method::Radau => "radau",
        }
    }
}

/// The unconstrained part of a two-level step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Flow {
    /// Kick, leapfrog, kick: constant mass, forces of position and time only.
    Leapfrog,
    /// Kick, implicit midpoint in momentum form, kick: M(q).
    Midpoint,
    /// Kick, implicit trapezoid in momentum form, kick: constant mass, forces that are stiff in the positions. (Large mechanisms take
    /// [`Flow::Implicit`], which has sparse matrices.)
    Trapezoid,
    /// Implicit trapezoid with the multiplier inside: forces that depend on velocities.
    Implicit,
}

impl Flow {
    /// `leapfrog`, `midpoint`, `trapezoid` or `implicit`.
    pub fn name(&self) -> &'static str {
        match self {
            Flow::Leapfrog => "leapfrog",
            Flow::Midpoint => "midpoint",
            Flow::Trapezoid => "trapezoid",
            Flow::Implicit => "implicit",
        }
    }
}

/// Settings of a simulation.
///
/// By default two-level of order 2 with a step of 1 ms, placement on, a constraint tolerance of 1e-13 and at most 25
/// iterations.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Settings {
    /// The integrator.
    pub method: Method,
    /// Order of the method: 2, 4, 6 or 8. Above 2 a step is a symmetric composition of 7, 13 or 17 stages, some of
    /// which run back in time. Where forces depend on velocities it is extrapolated instead, from 6, 12 or 20 stages that
    /// all run forwards: stable with stiff dampers, but not symmetric. For the explicit Runge–Kutta methods it chooses order 4
    /// (also for 2), 6 or 8. All other methods have an order of their own: for them orders above 2 are an error.
    pub order: u8,
    /// Step h, s; with a tolerance the first one that is tried.
    pub step: f64,
    /// The runtime chooses the steps of the two-level method, the projected one, or Radau: the error of two steps, of positions
    /// and of velocities times h, stays below a fiftieth of the tolerance times the motion in these steps. Motion is measured in sizes of
    /// the mechanism (the extent of its points at the declared guess) and in radians; it counts as at least the duration times
    /// the greatest speed so far.
    ///
    /// Errors add up over a run and grow with the motion's own instability; the factor 1/50 allows for both. In the
    /// comparison of the scenes with their references the largest error of a position, in sizes and radians, was 0.01
    /// to 5 times the tolerance, from 1e-3 to 1e-9 (at the order of [`Settings::for_tolerance`]; table in the book).
    ///
    /// Between 1e-12 and 0.1. [`Settings::for_tolerance`] chooses the order with it.
    pub tolerance: Option<f64>,
    /// The runtime chooses the method and its order, too: [`Settings::accuracy`]. Together with a method or an order it is an error.
    pub accuracy: Option<f64>,
    /// Whether a step of the two-level or of the projected method with a stage that would end beside a singular pose gets
    /// another length (0.5 to 1.15 times h). At second order only if digits would be lost. Not with [`Settings::fixed_iterations`].
    /// [`Simulation::step`](crate::Simulation::step) then advances by that length; runs to a time or an event still end
    /// exactly there.
    pub placement: bool,
    /// The flow of the two-level step; `None` chooses it from the structure of the mechanism and the stiffness of its
    /// forces. With another method it is an error.
    pub flow: Option<Flow>,
    /// Tolerance of the position rows, as a distance relative to the size of the mechanism.
    pub constraint_tolerance: f64,
    /// Iterations after which a step fails, up to 10,000.
    pub max_iterations: usize,
    /// Known cost, for real time: every stage makes exactly this many corrections of κ₁ (10,000 at most) with one factorisation, and
    /// accepts the residual of φ ([`Report::holonomic_error`](crate::Report::holonomic_error)); the next stage reduces
    /// it again, so that residuals do not grow. [`Model::step_flops`](crate::Model::step_flops) bounds the work. There is no placement. For the
    /// leapfrog flow without nonholonomic rows; for other mechanisms and methods, and with a tolerance or an accuracy, it is
    /// an error.
    ///
    /// A loop at 1 kHz, in which every step has the same number of corrections:
    ///
    /// ```
    /// # use mbs_runtime::{Mechanism, Settings, Simulation, mechanism};
    /// mechanism!(SliderCrank {
    ///     world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    ///     drive_force: Input(unit = N),
    ///     crank: Bar(mass = 1.0_kg, length = 0.15_m, angle = 60.0_deg),
    ///     rod: Bar(mass = 0.5_kg, length = 0.4_m, angle = -20.0_deg),
    ///     main_bearing: Revolute(ground.origin, crank.a),
    ///     crank_pin: Revolute(crank.b, rod.a),
    ///     liner: PointOnLine(rod.b, ground.origin, axis = X),
    ///     drive: Force(on = rod.b, value = [drive_force, 0.0]),
    /// });
    ///
    /// # fn main() -> Result<(), Box<dyn core::error::Error>> {
    /// let settings = Settings { step: 1e-3, fixed_iterations: Some(2), ..Settings::default() };
    /// let mut simulation = Simulation::with_settings(SliderCrank::default(), settings)?;
    /// assert!(SliderCrank::MODEL.step_flops(2).is_some_and(|flops| flops < 20_000));
    /// for tick in 0..1000 {
    ///     let force = if tick < 500 { 1.0 } else { -1.0 };
    ///     simulation.set_input("drive_force", force)?;
    ///     simulation.step()?;
    /// }
    /// assert!(simulation.report().holonomic_error < 1e-9);
    /// # Ok(())
    /// # }
    /// ```
    pub fixed_iterations: Option<usize>,
}

impl Default for Settings {
    fn default() -> Self {
        Settings {
            method: Method::TwoLevel,
            order: 2,
            step: 1e-3,
            tolerance: None,
            accuracy: None,
            placement: true,
            flow: None,
            constraint_tolerance: 1e-13,
            max_iterations: 25,
            fixed_iterations: None,
        }
    }
}

impl Settings {
    /// The least tolerance: smaller ones are below round-off.
    pub(crate) const LEAST_TOLERANCE: f64 = 1e-12;

    /// The order that the method has with these settings: the explicit methods have 4 at least, others one of their own.
    pub fn true_order(&self) -> u8 {
        match self.method {
            Method::Projected | Method::Baumgarte(_) => self.order.max(4),
            Method::Radau => 5,
            _ => self.order,
        }
    }

    /// An accuracy and nothing else: the largest error of a position over the run, in sizes of the mechanism and radians,
    /// between 1e-11 and 0.1; relative to the greatest speed, so that parts that are far slower than the fastest one have larger
    /// errors.
    ///
    /// The tolerance is a fifth of the accuracy. Where other candidates are compiled
    /// ([`Simulation::with_accuracy`](crate::Simulation::with_accuracy)) the simulation runs the beginning of the motion
    /// with the projected explicit method, with Radau where forces depend on velocities, and with the two-level method, and
    /// takes the one that needs the fewest operations for a second of it, from the start on; otherwise it takes the two-level
    /// one.
    /// [`Simulation::settings`](crate::Simulation::settings) tells which. Where the motion changes its character on the way, as
    /// when a block comes to stick, the choice is made again, which allocates;
    /// [`Simulation::method_changes`](crate::Simulation::method_changes) lists the changes.
    ///
    /// ```
    /// # use mbs_runtime::{Mechanism, Settings, Simulation, mechanism};
    /// # mechanism!(Pendulum {
    /// #     world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    /// #     rod: Bar(mass = 1.0_kg, length = 0.5_m, angle = 0.0_deg),
    /// #     pivot: Revolute(ground.origin, rod.a),
    /// # });
    /// # fn main() -> Result<(), Box<dyn core::error::Error>> {
    /// let mut simulation = Simulation::with_accuracy(Pendulum {}, 1e-8)?;
    /// simulation.run_until(10.0)?;
    /// println!("{}", simulation.settings().method.name());
    /// # Ok(())
    /// # }
    /// ```
    pub fn accuracy(accuracy: f64) -> Self {
        Settings {
            accuracy: Some(accuracy),
            ..Settings::default()
        }
    }

    /// Steps chosen by a [tolerance](Settings::tolerance), at the order that reaches it with the least work: 4 down to
    /// 3e-4, 6 down to 3e-6, then 8.
    ///
    /// ```
    /// # use mbs_runtime::{Mechanism, Settings, Simulation, mechanism};
    /// # mechanism!(Pendulum {
    /// #     world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    /// #     rod: Bar(mass = 1.0_kg, length = 0.5_m, angle = 0.0_deg),
    /// #     pivot: Revolute(ground.origin, rod.a),
    /// # });
    /// # fn main() -> Result<(), Box<dyn core::error::Error>> {
    /// let settings = Settings::for_tolerance(1e-8);
    /// let mut simulation = Simulation::with_settings(Pendulum {}, settings)?;
    /// simulation.run_until(10.0)?;
    /// assert!(simulation.energy().error.abs() < 1e-7);
    /// # Ok(())
    /// # }
    /// ```
    pub fn for_tolerance(tolerance: f64) -> Self {
        Settings::default().with_tolerance(tolerance)
    }

    /// The same with other settings kept.
    pub(crate) fn with_tolerance(self, tolerance: f64) -> Self {
        let order = match tolerance {
            t if t > 3e-4 => 4,
            t if t > 3e-6 => 6,
            _ => 8,
        };
        Settings {
            order,
            tolerance: Some(tolerance),
            ..self
        }
    }
}
