//! The corrections of velocities in Newton's method for an implicit step: when they are small enough.

use crate::ScalarState;
#[cfg(not(feature = "std"))]
use crate::elementary::Elementary as _;
use crate::scalar_state;
use crate::singular::{ROUND_OFF, STILL, has_stalled};
use crate::yardstick::Yardstick;
use nalgebra::SVector;

/// Corrections that stall below this multiple of round-off are round-off that the rows amplify, …
const AMPLIFIED: f64 = 10.0;

/// The sizes of corrections in a step.
pub(super) struct Corrections {
    /// Size of the last one.
    pub(super) size: f64,
    /// Whether it was round-off.
    pub(super) settled: bool,
    /// … and beside a singular pose below this one.
    amplified: f64,
    /// The size that is as good as round-off.
    enough: f64,
}

/// What follows from a correction.
pub(super) struct Verdict {
    /// The next correction would be round-off, or small enough.
    pub(super) converged: bool,
    /// The factor should be renewed.
    pub(super) slow: bool,
    /// The size of this one, as a multiple of round-off …
    #[cfg(feature = "sparse")]
    above: f64,
    /// … as a multiple of what is small enough …
    #[cfg(feature = "sparse")]
    excess: f64,
    /// … and as a multiple of the last one.
    #[cfg(feature = "sparse")]
    rate: f64,
    /// It is no smaller than half the last one.
    #[cfg(feature = "sparse")]
    stalled: bool,
}

impl Verdict {
    /// Whether this number of further corrections would not be enough, where a new factor costs as much as they do.
    #[cfg(feature = "sparse")]
    pub(super) fn is_slow_for(&self, corrections: i32) -> bool {
        self.slow && !(self.excess * self.rate.powi(corrections) <= 1.0)
    }

    /// Whether the corrections of this number of unknowns have ended. The round-off of their rows adds up, as from link to
    /// link of a chain: corrections that stall below the sum are round-off.
    #[cfg(feature = "sparse")]
    pub(super) fn is_end(&self, unknowns: usize) -> bool {
        self.converged || (self.stalled && self.above <= AMPLIFIED * unknowns as f64)
    }
}

impl Corrections {
    pub(super) fn none() -> Self {
        Corrections {
            size: f64::NAN,
            settled: false,
            amplified: AMPLIFIED,
            enough: 0.0,
        }
    }

    /// Corrections that end where the next one would be below this size.
    #[cfg(feature = "sparse")]
    pub(super) fn down_to(enough: f64) -> Self {
        Corrections {
            enough,
            ..Self::none()
        }
    }

    /// After a factorisation of rows whose smallest relative pivot is σ²: they amplify the round-off of positions by 1/σ.
    #[inline(always)]
    pub(super) fn amplify(&mut self, pivot: f64) {
        self.amplified = match pivot > 0.0 && AMPLIFIED * AMPLIFIED * pivot < 1.0 {
            true => 1.0 / pivot.sqrt(),
            false => AMPLIFIED,
        };
    }

    /// Adds a correction of v_b, in a step of h seconds that ends at q.
    #[inline(always)]
    pub(super) fn add<const Q: usize, const N: usize>(
        &mut self,
        change: &SVector<f64, N>,
        (q, vb): (&SVector<f64, Q>, &SVector<f64, N>),
        h: f64,
        yardstick: &Yardstick<Q, N>,
        states: &[ScalarState],
    ) -> Verdict {
        let least = || yardstick.imperceptible(q, h) / ROUND_OFF;
        let whole = || yardstick.measure(vb).max(least());
        let size = yardstick.correction(states, (change, vb), whole);
        let speed = yardstick.measure(vb);
        let last = core::mem::replace(&mut self.size, size);
        // At the rate of this correction.
        let rate = (size / last).min(1.0);
        let next = size * rate;
        let round_off = (ROUND_OFF * speed).max(yardstick.imperceptible(q, h));
        let enough = round_off.max(self.enough);
        let noise = (STILL * speed).max(self.amplified * round_off);
        let stalled = has_stalled(size, last) && size <= noise;
        self.settled = size <= round_off || stalled;
        Verdict {
            converged: next <= enough || stalled,
            slow: size > 0.1 * last
                || !size.is_finite()
                || scalar_state::changes_much(states, change, vb),
            #[cfg(feature = "sparse")]
            above: size / round_off,
            #[cfg(feature = "sparse")]
            excess: size / enough,
            #[cfg(feature = "sparse")]
            rate,
            #[cfg(feature = "sparse")]
            stalled: has_stalled(size, last),
        }
    }
}
