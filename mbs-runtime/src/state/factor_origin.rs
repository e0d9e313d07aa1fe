//! Where the factors of a large mechanism were made.

use super::is_equal;
use nalgebra::SVector;

/// What a new factor costs, in corrections: more in a plane grid, half of it in a chain. The best number of steps with one
/// factor depends on its root only.
pub(crate) const COST: u64 = 8;

/// The step at whose beginning the factors in use were made.
///
/// Corrections with other factors end in other round-off. A state names the factors that its next step begins with, so
/// that a run is resumed bit for bit: they are made again.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FactorOrigin<const Q: usize, const N: usize> {
    /// The instant at which that step began, s.
    pub time: f64,
    /// Its length, s; zero: the next step makes new factors.
    pub step: f64,
    /// q at that instant.
    pub positions: SVector<f64, Q>,
    /// v at that instant.
    pub velocities: SVector<f64, N>,
    /// What the factors have saved and cost since.
    pub renewal: Renewal,
}

/// When factors are renewed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Renewal {
    /// The corrections of the step that made the factors.
    pub fewest: u64,
    /// The steps since, with that one.
    pub steps: u64,
    /// The corrections of these steps beyond `fewest` in each.
    pub more: u64,
}

impl<const Q: usize, const N: usize> FactorOrigin<Q, N> {
    /// No factors.
    pub(crate) fn none() -> Self {
        FactorOrigin {
            time: 0.0,
            step: 0.0,
            positions: SVector::zeros(),
            velocities: SVector::zeros(),
            renewal: Renewal::default(),
        }
    }

    /// Whether there are factors, for steps of h seconds.
    pub(crate) fn fits(&self, h: f64) -> bool {
        is_equal(self.step, h)
    }

    /// Whether both are the same factors.
    pub(crate) fn is_same(&self, other: &Self) -> bool {
        self.time == other.time
            && self.step == other.step
            && self.positions == other.positions
            && self.velocities == other.velocities
    }
}

impl Renewal {
    /// For factors that were made in a step with these corrections.
    pub(crate) fn first(corrections: u64) -> Self {
        Renewal {
            fewest: corrections,
            steps: 1,
            more: 0,
        }
    }

    /// Counts a further step; whether the next one should make new factors.
    ///
    /// The mean cost of a step is (COST + more)/steps. It is least where a further step would cost more than this mean.
    pub(crate) fn add(&mut self, corrections: u64) -> bool {
        let more = corrections.saturating_sub(self.fewest);
        self.steps = self.steps.saturating_add(1);
        self.more = self.more.saturating_add(more);
        more.saturating_mul(self.steps) > self.more.saturating_add(COST)
    }
}

#[cfg(test)]
mod tests {
    use super::Renewal;

    /// The steps until factors are renewed, if the n-th step after takes `more(n)` corrections more.
    fn life(more: impl Fn(u64) -> u64) -> Option<u64> {
        let mut renewal = Renewal::first(3);
        (1..1000).find(|&n| renewal.add(3 + more(n)))
    }

    #[test]
    fn factors_are_kept_while_that_is_the_cheaper() {
        assert_eq!(life(|_| 0), None);
        // Always one correction more, but never a factor again.
        assert_eq!(life(|_| 1), None);
        assert_eq!(life(|n| n), Some(4));
        assert_eq!(life(|n| if n < 20 { 1 } else { 4 }), Some(20));
        assert_eq!(life(|_| 20), Some(1));
    }
}
