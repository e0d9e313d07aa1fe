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
    /// Columns of its reference.
    pub columns: &'static [&'static str],
    /// Its size in the unit of the columns.
    pub size: f64,
}

/// All of them.
pub const CASES: [Case; 8] = [
    Case {
        scene: "pendulum",
        columns: &["x_m", "y_m"],
        size: 1.0,
    },
    Case {
        scene: "slider-crank",
        columns: &["p1x_m", "p1y_m", "p2x_m"],
        size: 2.0,
    },
    Case {
        scene: "double-four-bar",
        columns: &["b0x_m", "b0y_m"],
        size: 2.0,
    },
    Case {
        scene: "andrews",
        columns: &[
            "beta_rad",
            "theta_rad",
            "gamma_rad",
            "phi_rad",
            "delta_rad",
            "omega_rad",
            "epsilon_rad",
        ],
        size: 1.0,
    },
    Case {
        scene: "bricard",
        columns: &["p3x_m", "p3y_m", "p3z_m", "p2x_m", "p2z_m", "p5y_m"],
        size: 1.0,
    },
    Case {
        scene: "chaplygin-sleigh",
        columns: &["edge_x_m", "edge_y_m", "theta_rad"],
        size: 1.0,
    },
    Case {
        scene: "heavy-top",
        columns: &["x_m", "y_m", "z_m"],
        size: 1.0,
    },
    Case {
        scene: "flyball-governor",
        columns: &["s_m", "ball1_x_m", "ball1_y_m", "ball1_z_m"],
        size: 1.0,
    },
];

impl Case {
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
        let paced = simulation.settings().tolerance.is_some();
        let mut frames = vec![Frame::record(simulation.as_ref())];
        let interval = reference.interval().unwrap_or(scene.duration);
        for instant in 1..=(scene.duration / interval).round() as u32 {
            let time = f64::from(instant) * interval;
            match paced {
                true => simulation.run_past(time, scene.duration)?,
                false => simulation.run_until(time)?,
            }
            simulation.look_at(time, &mut |seen| frames.push(Frame::record(seen)))?;
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
