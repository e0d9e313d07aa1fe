//! The singular poses of a mechanism of one degree of freedom: its poses form a curve, so that each is looked at once.

use crate::memory::Box;
use nalgebra::SVector;

/// Poses that are remembered; then the oldest is forgotten.
const REMEMBERED: usize = 8;

/// Positions at singular poses that were found.
#[derive(Debug, Clone, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct KnownPoses<const Q: usize> {
    /// As many places as can be used, so that copies have them, too; the newest pose first.
    places: Box<[SVector<f64, Q>]>,
    /// How many of them are poses.
    count: usize,
}

impl<const Q: usize> KnownPoses<Q> {
    /// None are kept.
    pub(crate) fn none() -> Self {
        Self::default()
    }

    /// Makes room where poses form a curve; otherwise none are kept.
    pub(crate) fn make_room(&mut self, form_a_curve: bool) {
        let places = if form_a_curve { REMEMBERED } else { 0 };
        if self.places.len() != places {
            let mut renewed = vec![SVector::zeros(); places];
            renewed
                .iter_mut()
                .zip(self.poses())
                .for_each(|(new, old)| *new = *old);
            self.count = self.count.min(places);
            self.places = renewed.into_boxed_slice();
        }
    }

    /// The newest first.
    pub fn poses(&self) -> &[SVector<f64, Q>] {
        self.places.get(..self.count).unwrap_or_default()
    }

    /// Keeps a pose.
    pub(crate) fn add(&mut self, positions: SVector<f64, Q>) {
        if self.places.is_empty() {
            return;
        }
        self.count = (self.count + 1).min(self.places.len());
        self.places[..self.count].rotate_right(1);
        self.places[0] = positions;
    }
}

impl<const Q: usize> PartialEq for KnownPoses<Q> {
    fn eq(&self, other: &Self) -> bool {
        self.poses() == other.poses()
    }
}
