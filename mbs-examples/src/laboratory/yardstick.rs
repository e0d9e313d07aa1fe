//! The data that runs are compared with: instants, the reference, and a fine run of our own.

use mbs_runtime::output::Frame;
use mbs_runtime::{AnySimulation, SimulationError};

use super::methods::{Entry, entry};
use super::outcome::Outcome;
use crate::reference::ReferenceTable;
use crate::scene::Scene;

/// Instants at which runs are compared.
pub const INSTANTS: u32 = 50;

/// A mechanism and the data that its runs are compared with.
pub struct Yardstick {
    /// The mechanism.
    pub scene: &'static Scene,
    /// s
    pub duration: f64,
    /// Reference positions.
    pub reference: ReferenceTable,
    /// The largest position in the reference, in its unit (m or rad).
    pub size: f64,
    /// Reactions at the instants, N and N m, of a fine run of our own; none if no method could make such a run.
    pub reactions: Vec<Vec<f64>>,
    /// The method and step of that run, and its own position error.
    pub source: String,
}

impl Yardstick {
    /// The yardstick of a scene with a reference.
    ///
    /// # Errors
    /// A message about missing data.
    pub fn new(scene: &'static Scene) -> Result<Self, String> {
        let reference = scene.reference.as_ref().ok_or("it has no reference")?;
        let table = ReferenceTable::find(reference, scene.model)?
            .ok_or_else(|| format!("{} was not found", reference.file))?;
        let mut yardstick = Yardstick {
            scene,
            duration: scene.duration,
            reference: table,
            size: 1.0,
            reactions: Vec::new(),
            source: "none".to_owned(),
        };
        let at_origin: Vec<Frame> = (0..=INSTANTS)
            .map(|i| frame(yardstick.instant(i), vec![0.0; scene.model.outputs.len()]))
            .collect();
        yardstick.size = yardstick.distance(&at_origin);
        yardstick.find_reactions();
        Ok(yardstick)
    }

    /// The simulation at its start.
    ///
    /// # Errors
    /// As the scene's.
    pub fn build(
        &self,
        entry: &Entry,
        control: f64,
    ) -> Result<Box<dyn AnySimulation>, SimulationError> {
        (self.scene.build)(&[], entry.settings(self.duration, control))
    }

    /// The i-th instant, s.
    pub fn instant(&self, i: u32) -> f64 {
        self.duration * f64::from(i) / f64::from(INSTANTS)
    }

    /// The largest position error over the frames, m or rad; infinite if it is not a number.
    pub fn distance(&self, frames: &[Frame]) -> f64 {
        let deviations = self.reference.compare(frames);
        let positions = deviations
            .iter()
            .filter(|d| d.column.ends_with("_m") || d.column.ends_with("_rad"));
        positions.fold(0.0, |most, deviation| worse(most, deviation.largest))
    }

    /// The reactions of that run of our own whose positions are nearest to the reference.
    fn find_reactions(&mut self) {
        let mut best = f64::INFINITY;
        for label in ["two-level 8", "projected 8", "two-level 2"] {
            let Some(entry) = entry(label) else { continue };
            // No powers of two: these are steps of the runs that are measured, and one of them would be its own measure.
            for substeps in [45.0, 181.0] {
                let step = self.instant(1) / substeps;
                let Ok((frames, reactions)) = self.follow(&entry, step) else {
                    continue;
                };
                let error = self.distance(&frames);
                if error < best {
                    best = error;
                    self.reactions = reactions;
                    self.source = format!("{label} at {step:.1e} s (position error {error:.1e})");
                }
            }
        }
    }

    fn follow(&self, entry: &Entry, step: f64) -> Result<(Vec<Frame>, Vec<Vec<f64>>), Outcome> {
        let failed = |error: SimulationError| Outcome::of_error(&error);
        let mut simulation = self.build(entry, step).map_err(failed)?;
        let (mut frames, mut reactions) = (Vec::new(), Vec::new());
        for i in 1..=INSTANTS {
            simulation.run_until(self.instant(i)).map_err(failed)?;
            frames.push(frame(simulation.time(), simulation.output_values()));
            reactions.push(simulation.reactions().map_err(failed)?.values);
        }
        Ok((frames, reactions))
    }
}

/// With outputs only, for the comparison with the reference.
pub fn frame(time: f64, outputs: Vec<f64>) -> Frame {
    Frame {
        time,
        outputs,
        ..Frame::default()
    }
}

/// The larger error; NaN counts as the largest.
pub fn worse(a: f64, b: f64) -> f64 {
    if b.is_nan() { f64::INFINITY } else { a.max(b) }
}
