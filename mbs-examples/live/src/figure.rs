//! The runs of one figure.

use crate::{MECHANISMS, Refusal};
use mbs_runtime::{
    AnySimulation, BaumgarteSettings, Method, PenaltySettings, ProjectionSettings, Settings,
};

/// The least and the largest step of the page, s. Below it a browser cannot follow the clock, above it no mechanism of the
/// page is resolved.
pub const STEPS: [f64; 2] = [1e-5, 0.2];

/// How many numbers precede the points in what [`Figure::read`] writes.
pub const HEAD: usize = 4;

/// The methods by index: the name among [`Method::NAMES`], and what the page calls it. The first is the two-level one; the
/// page proposes the second to compare with.
///
/// Those that choose their steps are not there, nor is Algorithm 1 of the paper, which may halve a step until a page
/// would seem to hang.
pub const METHODS: [(&str, &str); 7] = [
    ("two-level", "two-level"),
    ("baumgarte", "RK4, Baumgarte"),
    ("projected", "RK4, projected"),
    ("rattle", "RATTLE"),
    ("generalized-alpha", "generalized α"),
    ("index3-projections", "index 3, projected"),
    ("penalty", "penalties"),
];

/// The settings of the module that the book has: its digits are compared with those of this code.
fn as_built(method: Method) -> Method {
    match method {
        Method::Baumgarte(settings) => Method::Baumgarte(BaumgarteSettings {
            gain: 10.0,
            ..settings
        }),
        Method::Penalty(_) => Method::Penalty(PenaltySettings {
            penalty: 1e8,
            damping_ratio: 1.0,
        }),
        Method::Index3Projections(_) => {
            Method::Index3Projections(ProjectionSettings { penalty: 1e5 })
        }
        other => other,
    }
}

struct Run {
    simulation: Box<dyn AnySimulation>,
    /// max |energy error| over the steps since the last reading, J.
    worst: f64,
}

/// Two runs of a mechanism, each with a method of its own.
#[derive(Default)]
pub struct Figure {
    runs: [Option<Run>; 2],
}

impl Figure {
    /// Starts a run from time 0, in place of an earlier one. `parameters` are in the order of the declaration; those
    /// that are missing have their defaults.
    ///
    /// # Errors
    /// An index or a step out of range, and what the runtime does not accept.
    pub fn start(
        &mut self,
        run: usize,
        mechanism: usize,
        method: usize,
        step: f64,
        parameters: &[f64],
    ) -> Result<(), Refusal> {
        let slot = self.runs.get_mut(run).ok_or(Refusal::Run(run))?;
        *slot = None;
        let chosen = MECHANISMS
            .get(mechanism)
            .ok_or(Refusal::Mechanism(mechanism))?;
        let method = METHODS
            .get(method)
            .and_then(|(name, _)| Method::by_name(name))
            .map(as_built)
            .ok_or(Refusal::Method(method))?;
        if !(STEPS[0]..=STEPS[1]).contains(&step) {
            return Err(Refusal::Step(step));
        }
        let named = chosen.scene.model.parameters.iter().zip(parameters);
        let named: Vec<(String, f64)> = named
            .map(|(parameter, value)| (parameter.name.to_owned(), *value))
            .collect();
        let settings = Settings {
            method,
            step,
            ..Settings::default()
        };
        let simulation = (chosen.scene.build)(&named, settings)?;
        *slot = Some(Run {
            simulation,
            worst: 0.0,
        });
        Ok(())
    }

    /// Takes steps until `time` is reached or passed, but no more than `most`; how many it took. There is nothing between
    /// steps: a page shows where the method has been.
    ///
    /// # Errors
    /// A run that was not started, or a step that fails; the run then keeps the state before that step.
    pub fn advance(&mut self, run: usize, time: f64, most: usize) -> Result<usize, Refusal> {
        let Run { simulation, worst } = self.run_mut(run)?;
        let mut taken = 0;
        while taken < most && simulation.time() < time {
            simulation.step()?;
            *worst = worst.max(simulation.energy().error.abs());
            taken += 1;
        }
        Ok(taken)
    }

    /// Writes where a run is and returns how many numbers that takes (those beyond the end of `out` are left out):
    ///
    /// | numbers | what |
    /// |---|---|
    /// | 4 ([`HEAD`]) | time, s; energy error, J; its largest magnitude since the last reading, J; max \|φ\| since the start |
    /// | 3 for each point | the points of the model in world axes, m |
    /// | Q, N | coordinates and velocities |
    ///
    /// # Errors
    /// A run that was not started.
    pub fn read(&mut self, run: usize, out: &mut [f64]) -> Result<usize, Refusal> {
        let Run { simulation, worst } = self.run_mut(run)?;
        let head: [f64; HEAD] = [
            simulation.time(),
            simulation.energy().error,
            std::mem::take(worst),
            simulation.report().holonomic_error,
        ];
        let points = simulation.points();
        let numbers = head
            .into_iter()
            .chain(points.into_iter().flatten())
            .chain(simulation.coordinates())
            .chain(simulation.velocities());
        let mut count = 0;
        for (place, number) in out.iter_mut().zip(numbers) {
            *place = number;
            count += 1;
        }
        Ok(count)
    }

    fn run_mut(&mut self, run: usize) -> Result<&mut Run, Refusal> {
        let slot = self.runs.get_mut(run).and_then(Option::as_mut);
        slot.ok_or(Refusal::Run(run))
    }
}
