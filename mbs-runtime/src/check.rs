//! The check of settings.

use crate::settings::ORDERS;
use crate::{
    BaumgarteSettings, BdfSettings, Method, PaperSettings, PenaltySettings, Settings,
    SimulationError,
};

/// The range of tolerances: larger ones give no accuracy, smaller ones are below round-off.
const TOLERANCES: [f64; 2] = [Settings::LEAST_TOLERANCE, 0.1];
/// The range of accuracies, which tolerances are a part of.
const ACCURACIES: [f64; 2] = [1e-11, 0.1];
/// The range of steps: powers of others overflow or vanish.
const STEPS: [f64; 2] = [1e-100, 1e100];
/// The most iterations: rows that can be satisfied take some ten, and others must come to an end.
const ITERATIONS: usize = 10_000;
/// The least tolerance of rows, and of methods that control their error. It is far below round-off, and its powers are
/// numbers.
const LEAST: f64 = 1e-30;

impl Settings {
    /// Returns an error for values that cannot be used.
    pub(crate) fn check(&self) -> Result<(), SimulationError> {
        let counted = (STEPS[0]..=STEPS[1]).contains(&self.step);
        require("step", self.step, counted, "a value from 1e-100 to 1e100")?;
        tolerance("constraint_tolerance", self.constraint_tolerance)?;
        count("max_iterations", self.max_iterations)?;
        let known = ORDERS.contains(&self.order);
        require("order", self.order.into(), known, "2, 4, 6 or 8")?;
        if let Some(count) = self.fixed_iterations {
            let free = self.tolerance.is_none() && matches!(self.method, Method::TwoLevel);
            let wanted = "`None` with a tolerance or another method than the two-level one";
            require("fixed_iterations", count as f64, free, wanted)?;
            self::count("fixed_iterations", count)?;
        }
        if let Some(wished) = self.accuracy {
            let possible = (ACCURACIES[0]..=ACCURACIES[1]).contains(&wished);
            require("accuracy", wished, possible, "a value from 1e-11 to 0.1")?;
            let free = self.tolerance.is_none() && self.fixed_iterations.is_none();
            let wanted = "`None` with a tolerance or fixed iterations: it chooses them";
            require("accuracy", wished, free, wanted)?;
            let wanted = "`None` with a method, an order or a flow: it chooses them";
            let is_open = self.method == Method::TwoLevel && self.order == 2 && self.flow.is_none();
            require("accuracy", wished, is_open, wanted)?;
        }
        if let Some(wished) = self.tolerance {
            let possible = (TOLERANCES[0]..=TOLERANCES[1]).contains(&wished);
            require("tolerance", wished, possible, "a value from 1e-12 to 0.1")?;
            let paced = matches!(
                self.method,
                Method::TwoLevel | Method::Projected | Method::Radau
            );
            let wanted =
                "`None` with this method: `two-level`, `projected` and `radau` choose their steps";
            require("tolerance", wished, paced, wanted)?;
        }
        let fits = self.flow.is_none() || self.method == Method::TwoLevel;
        let wanted = "`Method::TwoLevel`, which alone has a flow, or no `flow`";
        self.require_method(fits, wanted)?;
        let (order, (orders, because)) = (self.order, self.method.orders());
        if !orders.contains(&order) {
            return Err(SimulationError::Order { order, because });
        }
        match &self.method {
            Method::TwoLevel | Method::Projected | Method::Rattle | Method::Radau => Ok(()),
            Method::Baumgarte(baumgarte) => baumgarte.check(),
            Method::Penalty(penalty) => penalty.check(),
            Method::Index3Projections(projections) => positive("penalty", projections.penalty),
            Method::GeneralizedAlpha(alpha) => require(
                "spectral_radius",
                alpha.spectral_radius,
                (0.0..=1.0).contains(&alpha.spectral_radius),
                "from 0 to 1",
            ),
            Method::Bdf(bdf) => bdf.check(),
            Method::Paper(paper) | Method::MAlf(paper) => paper.check(),
        }
    }
}

impl Settings {
    /// Refuses the method unless this holds; `wanted`: what can be given.
    pub(crate) fn require_method(
        &self,
        holds: bool,
        wanted: &'static str,
    ) -> Result<(), SimulationError> {
        let method = self.method.name();
        match holds {
            true => Ok(()),
            false => Err(SimulationError::OtherMethod { method, wanted }),
        }
    }
}

impl PaperSettings {
    fn check(&self) -> Result<(), SimulationError> {
        tolerance("newton_tolerance", self.newton_tolerance)?;
        tolerance("velocity_tolerance", self.velocity_tolerance)?;
        tolerance("residual_tolerance", self.residual_tolerance)?;
        positive("penalty", self.penalty)?;
        positive("max_penalty", self.max_penalty)?;
        positive("augmentation_ratio", self.augmentation_ratio)?;
        count("max_newton_iterations", self.max_newton_iterations)?;
        count("max_augmentations", self.max_augmentations)?;
        count("max_updates", self.max_updates)?;
        require(
            "min_updates",
            self.min_updates as f64,
            self.min_updates <= self.max_updates,
            "at most `max_updates`",
        )?;
        positive("smallest_step", self.smallest_step)?;
        require(
            "penalty_growth",
            self.penalty_growth,
            self.penalty_growth > 1.0,
            "a finite value above 1",
        )?;
        positive("mass_scale", self.mass_scale)?;
        let frequency = self.stabilisation_frequency;
        require(
            "stabilisation_frequency",
            frequency,
            frequency >= 0.0,
            "zero or a positive finite value",
        )
    }
}

impl PenaltySettings {
    fn check(&self) -> Result<(), SimulationError> {
        positive("penalty", self.penalty)?;
        require(
            "damping_ratio",
            self.damping_ratio,
            self.damping_ratio >= 0.0,
            "zero or a positive finite value",
        )
    }
}

impl BdfSettings {
    fn check(&self) -> Result<(), SimulationError> {
        tolerance("tolerance", self.tolerance)?;
        require(
            "max_order",
            self.max_order.into(),
            (1..=5).contains(&self.max_order),
            "1 to 5",
        )
    }
}

impl BaumgarteSettings {
    fn check(&self) -> Result<(), SimulationError> {
        require(
            "gain",
            self.gain,
            self.gain >= 0.0,
            "zero or a positive finite value",
        )?;
        self.adaptive
            .map_or(Ok(()), |wanted| tolerance("adaptive", wanted))
    }
}

fn positive(name: &'static str, value: f64) -> Result<(), SimulationError> {
    require(name, value, value > 0.0, "a positive finite value")
}

fn count(name: &'static str, value: usize) -> Result<(), SimulationError> {
    let possible = (1..=ITERATIONS).contains(&value);
    require(name, value as f64, possible, "a number from 1 to 10000")
}

fn tolerance(name: &'static str, value: f64) -> Result<(), SimulationError> {
    require(
        name,
        value,
        value >= LEAST,
        "a finite value of at least 1e-30",
    )
}

fn require(
    name: &'static str,
    value: f64,
    holds: bool,
    wanted: &'static str,
) -> Result<(), SimulationError> {
    if holds && value.is_finite() {
        Ok(())
    } else {
        Err(SimulationError::Setting {
            name,
            value,
            wanted,
        })
    }
}
