//! The singular poses of a mechanism of one degree of freedom: its poses form a curve, so that each is looked at once.

use crate::memory::cloned_with_room;
use nalgebra::SVector;

/// Poses that are remembered; then the oldest is forgotten.
const REMEMBERED: usize = 8;

/// Positions at singular poses that were found.
#[derive(Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct KnownPoses<const Q: usize> {
    /// The newest last.
    poses: Vec<SVector<f64, Q>>,
    /// How many may be kept; the mechanism says it, not a file.
    #[cfg_attr(feature = "serde", serde(skip))]
    room: usize,
}

impl<const Q: usize> KnownPoses<Q> {
    /// None are kept.
    pub(crate) fn none() -> Self {
        Self::default()
    }

    /// Makes room where poses form a curve; otherwise none are kept.
    pub(crate) fn make_room(&mut self, form_a_curve: bool) {
        self.room = if form_a_curve { REMEMBERED } else { 0 };
        self.poses.truncate(self.room);
        self.poses.reserve_exact(self.room - self.poses.len());
    }

    /// The newest last.
    pub fn poses(&self) -> &[SVector<f64, Q>] {
        &self.poses
    }

    /// Keeps a pose.
    pub(crate) fn add(&mut self, positions: SVector<f64, Q>) {
        if self.room == 0 {
            return;
        }
        if self.poses.len() >= self.room {
            self.poses.remove(0);
        }
        self.poses.push(positions);
    }
}

impl<const Q: usize> Clone for KnownPoses<Q> {
    /// With the same room, so that steps of a copy do not allocate either.
    fn clone(&self) -> Self {
        KnownPoses {
            poses: cloned_with_room(&self.poses),
            room: self.room,
        }
    }
}

impl<const Q: usize> PartialEq for KnownPoses<Q> {
    fn eq(&self, other: &Self) -> bool {
        self.poses == other.poses
    }
}
