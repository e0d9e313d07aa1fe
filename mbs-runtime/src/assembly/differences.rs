//! Derivatives by differences, for functions that have no others.

/// Steps of the first differences; each next is half of it.
const LARGEST: f64 = 0.1;
/// How often the step is halved.
const HALVINGS: usize = 7;
/// Coefficients of the central differences of order 16: 2 (−1)^(k+1) (8!)² / (2k (8 − k)! (8 + k)!).
const COEFFICIENTS: [f64; 8] = [
    8.0 / 9.0,
    -14.0 / 45.0,
    56.0 / 495.0,
    -7.0 / 198.0,
    56.0 / 6435.0,
    -2.0 / 1287.0,
    8.0 / 45045.0,
    -1.0 / 102_960.0,
];

/// The derivative of `function` at 0: that of the step for which the change from the next one, one half of it, and the
/// round-off of the values together are the least. (The change alone may be small by chance.)
pub(super) fn derivative(function: &dyn Fn(f64) -> f64) -> f64 {
    let mut largest: f64 = 0.0;
    let mut difference = |step: f64| {
        let terms = COEFFICIENTS.iter().zip(1..).map(|(coefficient, k)| {
            let way = f64::from(k) * step;
            let (ahead, behind) = (function(way), function(-way));
            largest = largest.max(ahead.abs()).max(behind.abs());
            coefficient * (ahead - behind)
        });
        terms.sum::<f64>() / step
    };
    let steps: [f64; HALVINGS + 1] = core::array::from_fn(|k| LARGEST / (1 << k) as f64);
    let found = steps.map(&mut difference);
    let doubt = |k: usize| (found[k] - found[k + 1]).abs() + f64::EPSILON * largest / steps[k];
    let best = (0..HALVINGS).min_by(|&a, &b| doubt(a).total_cmp(&doubt(b)));
    best.map_or(found[0], |best| found[best])
}

#[cfg(test)]
mod tests {
    use super::derivative;

    #[test]
    fn differences_have_nearly_all_digits() {
        assert!((derivative(&|x| (0.7 + x).sin()) - 0.7_f64.cos()).abs() < 1e-14);
        let angle = |x: f64| (0.1 + x).atan2(0.05);
        assert!((derivative(&angle) - 0.05 / (0.01 + 0.0025)).abs() < 1e-12);
        assert_eq!(derivative(&|_| 3.0), 0.0);
    }
}
