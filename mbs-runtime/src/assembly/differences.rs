//! Derivatives by differences, for functions that have no others.

/// Steps of the first differences; each next is half of it.
const LARGEST: f64 = 0.02;
/// How often the step is halved.
const HALVINGS: i32 = 7;
/// Coefficients of the central differences of eighth order.
const COEFFICIENTS: [f64; 4] = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];

/// The derivative of `function` at 0: that of two steps, one half of the other, which agree best.
pub(super) fn derivative(function: &dyn Fn(f64) -> f64) -> f64 {
    let difference = |step: f64| {
        let terms = COEFFICIENTS.iter().zip(1..).map(|(coefficient, k)| {
            let way = f64::from(k) * step;
            coefficient * (function(way) - function(-way))
        });
        terms.sum::<f64>() / step
    };
    let mut last = difference(LARGEST);
    let (mut best, mut least) = (last, f64::INFINITY);
    for halved in 1..=HALVINGS {
        let next = difference(LARGEST * 0.5_f64.powi(halved));
        let change = (next - last).abs();
        if change < least {
            // Of the two, the longer step has the smaller round-off.
            (best, least) = (last, change);
        }
        last = next;
    }
    best
}

#[cfg(test)]
mod tests {
    use super::derivative;

    #[test]
    fn differences_have_nearly_all_digits() {
        assert!((derivative(&|x| (0.7 + x).sin()) - 0.7_f64.cos()).abs() < 1e-13);
        let angle = |x: f64| (0.1 + x).atan2(0.05);
        assert!((derivative(&angle) - 0.05 / (0.01 + 0.0025)).abs() < 1e-11);
        assert_eq!(derivative(&|_| 3.0), 0.0);
    }
}
