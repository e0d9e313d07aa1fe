//! A mechanism of the sweep, and how much a step of it costs.

use mbs_runtime::{AnySimulation, Model, Settings, SimulationError};

/// Makes a simulation of a mechanism from parameters by name.
pub type Build = fn(&[(String, f64)], Settings) -> Result<Box<dyn AnySimulation>, SimulationError>;

/// A mechanism with its usual step.
pub struct Case {
    /// Its name in tables.
    pub name: String,
    /// The model.
    pub model: &'static Model,
    /// Parameters that differ from the declared ones.
    pub parameters: Vec<(String, f64)>,
    /// The usual step of the two-level method of order 2, s.
    pub step: f64,
    /// The longest run, s.
    pub duration: f64,
    /// Makes its simulation.
    pub build: Build,
}

impl Case {
    /// A simulation of it.
    ///
    /// # Errors
    /// As the simulation's.
    pub fn start(&self, settings: Settings) -> Result<Box<dyn AnySimulation>, SimulationError> {
        (self.build)(&self.parameters, settings)
    }

    /// Processor time of a stage of the two-level method, roughly, s; by the operations, so that a sweep is the same on
    /// every machine.
    pub fn stage(&self) -> f64 {
        let operations = self.model.operations.iter().map(|f| {
            let simple = f.additions + f.multiplications;
            simple + 5 * f.divisions + 20 * f.calls
        });
        let sizes = self.model.velocities.len() + self.model.rows.len();
        // Where the elimination is sparse, the operations of the dense one are not made.
        let most = 200.0 * sizes as f64;
        1e-9 * (0.5 * operations.sum::<usize>() as f64 + 30.0 * sizes as f64).min(most)
    }

    /// The largest difference of two poses, in sizes of the mechanism and radians; infinite if it is not a number.
    /// Both signs of a unit quaternion are the same orientation.
    pub fn apart(&self, size: f64, a: &[f64], b: &[f64]) -> f64 {
        let (mut most, mut sign) = (0.0_f64, 1.0);
        for (i, q) in self.model.coordinates.iter().enumerate() {
            if q.name.ends_with(".qw") {
                let product: f64 = (i..i + 4).map(|j| a[j] * b[j]).sum();
                sign = product.signum();
            } else if !q.name.contains(".q") {
                sign = 1.0;
            }
            let unit = if q.unit == "m" { size } else { 1.0 };
            let difference = ((a[i] - sign * b[i]) / unit).abs();
            if !(difference <= most) {
                most = if difference.is_nan() {
                    f64::INFINITY
                } else {
                    difference
                };
            }
        }
        most
    }
}

/// The largest extent of points along an axis, m; 0 without points.
pub fn extent(points: &[[f64; 3]]) -> f64 {
    let along = |axis: usize| {
        let values = points.iter().map(|point| point[axis]);
        let least = values.clone().fold(f64::INFINITY, f64::min);
        (values.fold(f64::NEG_INFINITY, f64::max) - least).max(0.0)
    };
    along(0).max(along(1)).max(along(2))
}
