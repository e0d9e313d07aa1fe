//! Coordinates, velocities and points by name, for tools.

use super::Simulation;
use super::access::find;
use crate::{System, UnknownName};

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// A generalized coordinate, in the unit that [`Model::coordinates`](crate::Model::coordinates) tells. Which
    /// coordinates there are follows from the description that the compiler has chosen; an `Output` is independent of it.
    ///
    /// # Errors
    /// No coordinate has this name.
    pub fn coordinate(&self, name: &str) -> Result<f64, UnknownName> {
        let names = S::MODEL.coordinates.iter().map(|known| known.name);
        let index = find("coordinate", name, names)?;
        Ok(self.positions().get(index).copied().unwrap_or(f64::NAN))
    }

    /// A generalized velocity, in the unit that [`Model::velocities`](crate::Model::velocities) tells.
    ///
    /// # Errors
    /// No velocity has this name.
    pub fn velocity(&self, name: &str) -> Result<f64, UnknownName> {
        let names = S::MODEL.velocities.iter().map(|known| known.name);
        let index = find("velocity", name, names)?;
        Ok(self.velocities().get(index).copied().unwrap_or(f64::NAN))
    }

    /// A named point in world axes, m, as [`Model::points`](crate::Model::points) names it. Allocates.
    ///
    /// # Errors
    /// No point has this name.
    pub fn point(&self, name: &str) -> Result<[f64; 3], UnknownName> {
        let index = find("point", name, S::MODEL.points.iter().copied())?;
        Ok(self.points().get(index).copied().unwrap_or([f64::NAN; 3]))
    }
}
