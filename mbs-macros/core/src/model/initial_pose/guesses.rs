//! Initial guesses of local coordinates and their rates.

use crate::symbolic::{Expr, Graph, Map};

/// Guesses of local coordinates and their rates, in parameters.
#[derive(Debug, Default)]
pub(in crate::model) struct Guesses {
    values: Map<u32, (Expr, Expr)>,
    quaternions: Map<u32, [Expr; 4]>,
    angles: Map<usize, Expr>,
}

impl Guesses {
    pub(in crate::model) fn position(&self, local: u32, graph: &mut Graph) -> Expr {
        self.values
            .get(&local)
            .map_or_else(|| graph.zero(), |value| value.0)
    }

    pub(in crate::model) fn set(&mut self, local: u32, position: Expr, velocity: Expr) {
        self.values.insert(local, (position, velocity));
    }

    pub(in crate::model) fn set_quaternion(&mut self, first: u32, quaternion: [Expr; 4]) {
        self.quaternions.insert(first, quaternion);
    }

    /// The quaternion of the rotation whose first local is this.
    pub(in crate::model) fn quaternion(&self, first: u32, graph: &mut Graph) -> [Expr; 4] {
        let (zero, one) = (graph.zero(), graph.one());
        let identity = [one, zero, zero, zero];
        self.quaternions.get(&first).copied().unwrap_or(identity)
    }

    pub(in crate::model) fn velocity(&self, local: u32, graph: &mut Graph) -> Expr {
        self.values
            .get(&local)
            .map_or_else(|| graph.zero(), |value| value.1)
    }

    pub(in crate::model) fn set_angle(&mut self, bar: usize, angle: Expr) {
        self.angles.insert(bar, angle);
    }

    /// The angle of a bar of the plane that has none among its coordinates.
    pub(in crate::model) fn angle(&self, bar: usize, graph: &mut Graph) -> Expr {
        let angle = self.angles.get(&bar).copied();
        angle.unwrap_or_else(|| graph.zero())
    }

    /// Whether all are known once the parameters are.
    pub(in crate::model) fn are_known(&self, graph: &Graph) -> bool {
        let values = self
            .values
            .values()
            .flat_map(|&(position, rate)| [position, rate]);
        let quaternions = self.quaternions.values().flatten().copied();
        let angles = self.angles.values().copied();
        values
            .chain(quaternions)
            .chain(angles)
            .all(|x| !graph.depends_on(x, |symbol| !symbol.is_parameter_like()))
    }
}
