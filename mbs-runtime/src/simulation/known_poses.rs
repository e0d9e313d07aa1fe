//! Whether a singular pose that is passed has been found before ([`KnownPoses`](crate::KnownPoses)).

use super::Simulation;
use super::hermite::Hermite;
use crate::{State, System};

/// Two poses that are this near are the same, in lengths of the mechanism and radians: more than the error of the cubic
/// between the ends of two steps.
pub(super) const SAME: f64 = 0.02;
/// A pose beyond the end of a step that is this near to a known one may be the same.
pub(super) const ALIKE: f64 = 0.2;

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Simulation<S, Q, N, R> {
    /// Whether a singular pose that has been found before is nearer than this to the pose after the part s of the way
    /// from `begin` to the state.
    pub(super) fn is_known(&self, begin: &State<Q, N, R>, s: f64, within: f64) -> bool {
        let known = self.state().known_poses.poses();
        if known.is_empty() {
            return false;
        }
        let system = self.system();
        let (_, q, _) = Hermite::new(system, begin, self.state()).at(system, s);
        let distance = |known: &_| self.yardstick.measure(&system.difference(known, &q));
        known.iter().any(|known| distance(known) < within)
    }
}
