//! The singular poses of a mechanism of one degree of freedom: its poses form a curve, so that each is looked at once.

use nalgebra::SVector;

/// Poses that are remembered; then the oldest is forgotten.
const REMEMBERED: usize = 8;
/// Two poses that are this near are the same, in lengths of the mechanism and radians: more than the error of the cubic
/// between the ends of two steps.
pub(super) const SAME: f64 = 0.02;
/// A pose beyond the end of a step that is this near to a known one may be the same.
pub(super) const ALIKE: f64 = 0.2;

/// Positions at singular poses that were found.
#[derive(Clone)]
pub(super) struct KnownPoses<const Q: usize> {
    positions: Vec<SVector<f64, Q>>,
}

impl<const Q: usize> KnownPoses<Q> {
    /// For poses that form a curve; otherwise none is kept.
    pub(super) fn new(form_a_curve: bool) -> Self {
        let room = if form_a_curve { REMEMBERED } else { 0 };
        KnownPoses {
            positions: Vec::with_capacity(room),
        }
    }

    /// Whether one of the poses is nearer than this.
    pub(super) fn contain(&self, within: f64, distance: impl Fn(&SVector<f64, Q>) -> f64) -> bool {
        self.positions.iter().any(|known| distance(known) < within)
    }

    /// Keeps a pose.
    pub(super) fn add(&mut self, positions: SVector<f64, Q>) {
        if self.positions.capacity() < REMEMBERED {
            return;
        }
        if self.positions.len() == REMEMBERED {
            self.positions.remove(0);
        }
        self.positions.push(positions);
    }

    pub(super) fn is_empty(&self) -> bool {
        self.positions.is_empty()
    }
}
