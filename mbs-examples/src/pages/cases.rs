//! Scenes whose positions are compared with their references, in sizes of the mechanism or radians.

use super::scene_runs::reference;
use crate::reference::ReferenceTable;
use crate::scene::Scene;
use crate::scenes::scenes;
use mbs_runtime::output::Frame;
use mbs_runtime::{Settings, SimulationError};

/// The position columns of a scene, and its size in their unit.
pub struct Case {
    /// The name of the scene.
    pub scene: &'static str,
    /// Columns of its reference; without any the error is that of the energy balance, and its size the largest kinetic
    /// energy.
    pub columns: &'static [&'static str],
    /// Its size in the unit of the columns.
    pub size: f64,
}

const PENDULUM: &[&str] = &["x_m", "y_m"];
const ANDREWS: &[&str] = &[
    "beta_rad",
    "theta_rad",
    "gamma_rad",
    "phi_rad",
    "delta_rad",
    "omega_rad",
    "epsilon_rad",
];
const BRICARD: &[&str] = &["p3x_m", "p3y_m", "p3z_m", "p2x_m", "p2z_m", "p5y_m"];
const KNIFE_EDGE: &[&str] = &["x_m", "y_m", "phi_rad"];
const ROLLING_DISK: &[&str] = &["cx_m", "cy_m", "cz_m"];

/// A drive determines the motion: positions are exact with steps of any length, and what has an error is its work.
const WORK: &[&str] = &[];

/// All scenes whose reference is that of the same mechanism. (That of `bricard-slender` is the limit of thin rods, 1.9e-5 m from
/// the motion of the scene.)
pub const CASES: [Case; 17] = [
    Case::new("pendulum", PENDULUM, 1.0),
    Case::new("pendulum-angle", PENDULUM, 1.0),
    Case::new("slider-crank", &["p1x_m", "p1y_m", "p2x_m"], 2.0),
    Case::new("driven-slider-crank", WORK, 1.0),
    Case::new("double-four-bar", &["b0x_m", "b0y_m"], 2.0),
    Case::new("four-bar-40", &["b0x_m", "b0y_m"], 40.0),
    Case::new("andrews", ANDREWS, 1.0),
    Case::new("andrews-iftomm", ANDREWS, 1.0),
    Case::new(
        "chaplygin-sleigh",
        &["edge_x_m", "edge_y_m", "theta_rad"],
        1.0,
    ),
    Case::new("knife-edge", KNIFE_EDGE, 1.0),
    Case::new("knife-edge-moving", KNIFE_EDGE, 1.0),
    Case::new("heavy-top", &["x_m", "y_m", "z_m"], 1.0),
    Case::new("bricard", BRICARD, 1.0),
    Case::new("bricard-reference", BRICARD, 1.0),
    Case::new(
        "flyball-governor",
        &["s_m", "ball1_x_m", "ball1_y_m", "ball1_z_m"],
        1.0,
    ),
    Case::new("rolling-disk", ROLLING_DISK, 0.4),
    Case::new("rolling-disk-tilted", ROLLING_DISK, 0.0375),
];

impl Case {
    const fn new(scene: &'static str, columns: &'static [&'static str], size: f64) -> Self {
        Case {
            scene,
            columns,
            size,
        }
    }

    /// The scene with its reference; `None` if there is none.
    ///
    /// # Errors
    /// A reference that cannot be read.
    pub fn load(&self) -> Result<Option<(&'static Scene, ReferenceTable)>, String> {
        let mut scenes = scenes().iter();
        let Some(scene) = scenes.find(|scene| scene.name == self.scene) else {
            return Ok(None);
        };
        Ok(reference(scene)?.map(|reference| (scene, reference)))
    }

    /// The largest error at the instants of the reference.
    ///
    /// # Errors
    /// A run that does not come to its end.
    pub fn error(
        &self,
        scene: &Scene,
        reference: &ReferenceTable,
        settings: Settings,
    ) -> Result<f64, SimulationError> {
        let mut simulation = (scene.build)(&[], settings)?;
        let interval = reference.interval().unwrap_or(scene.duration);
        // Steps that end between the instants; what is at these is sampled.
        let paced = simulation.settings().tolerance.is_some() || settings.step > interval;
        let mut frames = vec![Frame::record(simulation.as_ref())];
        for instant in 1..=(scene.duration / interval).round() as u32 {
            let time = f64::from(instant) * interval;
            match paced {
                true => simulation.run_past(time, scene.duration)?,
                false => simulation.run_until(time)?,
            }
            simulation.look_at(time, &mut |seen| frames.push(Frame::record(seen)))?;
        }
        if self.columns.is_empty() {
            let kinetic = frames.iter().map(|frame| frame.energy.kinetic);
            let error = |frame: &Frame| frame.energy.error.abs();
            let error = frames.iter().map(error).fold(0.0, f64::max);
            return Ok(error / kinetic.fold(0.0, f64::max));
        }
        let deviations = reference.compare(&frames);
        let positions = deviations
            .iter()
            .filter(|deviation| self.columns.contains(&deviation.column));
        let largest = positions.fold(0.0_f64, |largest, deviation| {
            match deviation.largest > largest || deviation.largest.is_nan() {
                true => deviation.largest,
                false => largest,
            }
        });
        Ok(largest / self.size)
    }
}
