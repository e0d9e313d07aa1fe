//! The velocities that a step begins its corrections with: extrapolated from the last steps.

use super::is_equal;
use nalgebra::SVector;

/// The most differences that are known; predictions use one less.
const MOST: usize = 5;

/// Backward differences ∇v, ∇²v, … of the velocities at the ends of equal steps.
///
/// With k differences the prediction is v + ∇v + … + ∇ᵏv. What a step adds to it is ∇ᵏ⁺¹v of its end: the differences
/// are the errors of all predictions of the last step, and the next one takes the number whose error was least. Of a slow
/// motion that is the largest number, of a vibration that a step hardly resolves none.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct BackwardDifferences<const N: usize> {
    /// The length of these steps, s; zero: there was none.
    pub step: f64,
    /// ∇v, ∇²v, … at the end of the last step, …
    pub differences: [SVector<f64, N>; MOST],
    /// … of which this number is known, …
    pub known: usize,
    /// … and this number used for the next step.
    pub used: usize,
    /// The size of ∇³v, of which the error of a step is a twelfth, in sizes of the mechanism per second or rad/s; zero while it
    /// is not known.
    pub third: f64,
}

impl<const N: usize> BackwardDifferences<N> {
    /// Before the first step.
    pub(crate) fn none() -> Self {
        BackwardDifferences {
            step: 0.0,
            differences: [SVector::zeros(); MOST],
            known: 0,
            used: 0,
            third: 0.0,
        }
    }

    /// The velocities at the end of a step of h seconds that begins with v.
    pub(crate) fn predict(&self, v: &SVector<f64, N>, h: f64) -> SVector<f64, N> {
        let mut end = *v;
        if is_equal(self.step, h) {
            for difference in self.differences.iter().take(self.used) {
                end += difference;
            }
        } else if self.known > 0 {
            end += self.differences[0] * (h / self.step);
        }
        end
    }

    /// Adds a step of h seconds by its change of v.
    pub(crate) fn add(
        &mut self,
        change: &SVector<f64, N>,
        h: f64,
        measure: impl Fn(&SVector<f64, N>) -> f64,
    ) {
        if !is_equal(self.step, h) {
            (self.step, self.known, self.third) = (h, 0, 0.0);
        }
        let mut difference = *change;
        let mut least = f64::INFINITY;
        for (order, known) in self.differences.iter_mut().enumerate() {
            let error = measure(&difference);
            if order == 2 {
                self.third = error;
            }
            if error < least {
                (least, self.used) = (error, order);
            }
            let before = core::mem::replace(known, difference);
            if order == self.known {
                break;
            }
            difference -= before;
        }
        // Of one step alone no prediction has an error.
        self.used = self.used.max(usize::from(self.known == 0));
        self.known = self.known.saturating_add(1).min(MOST);
    }
}

#[cfg(test)]
mod tests {
    use super::BackwardDifferences;
    use nalgebra::SVector;

    /// The number of differences in use after 20 steps, and the error of the next prediction.
    fn after(v: impl Fn(f64) -> f64) -> (usize, f64) {
        let at = |n: i32| SVector::from([v(f64::from(n))]);
        let mut differences = BackwardDifferences::none();
        for n in 0..20 {
            differences.add(&(at(n + 1) - at(n)), 0.1, |x| x[0].abs());
        }
        let error = differences.predict(&at(20), 0.1) - at(21);
        (differences.used, error[0].abs())
    }

    #[test]
    fn smooth_motions_are_predicted_by_many_differences() {
        let (used, error) = after(|n| (0.1 * n).sin());
        assert_eq!(used, 4);
        assert!(error < 1e-5, "{error}");
        let (_, error) = after(|n| n * n * n);
        assert!(error < 1e-9, "{error}");
    }

    #[test]
    fn unresolved_vibrations_are_not_extrapolated() {
        let (used, _) = after(|n| (3.0 * n).cos());
        assert_eq!(used, 0);
    }

    #[test]
    fn another_step_begins_anew_with_the_last_rate() {
        let mut differences = BackwardDifferences::none();
        let one = SVector::from([1.0]);
        assert_eq!(differences.predict(&one, 0.1), one);
        differences.add(&one, 0.1, |x| x[0].abs());
        assert_eq!(differences.predict(&one, 0.2)[0], 3.0);
        differences.add(&(one * 2.0), 0.2, |x| x[0].abs());
        assert_eq!((differences.known, differences.used), (1, 1));
        assert_eq!(differences.predict(&one, 0.2)[0], 3.0);
    }
}
