//! The choice of the redundant rows that are left out.

use crate::singular::round_off;

/// Of rows with pivots larger than this fraction of the largest the first is taken: round-off does not decide between
/// rows that are alike by symmetry.
const ALIKE: f64 = 0.9;

/// At a singular pose of the mechanism the pivots of every choice are small: others are left out only where their
/// smallest is this many times larger.
const GAIN: f64 = 10.0;

/// This number of rows that follow from the others, chosen such that the others are as independent as possible: rows are
/// eliminated in the order of their pivots relative to `scales`. `None` if fewer follow, up to relative pivots of
/// `bound`, or if the smallest pivot of the others is not much larger than `least`. `upper` is S, in its upper triangle, and is used up.
pub(super) fn dependent_rows<const K: usize>(
    upper: &mut [[f64; K]; K],
    scales: &[f64; K],
    count: usize,
    [least, bound]: [f64; 2],
) -> Option<[bool; K]> {
    let (mut left, enough) = ([true; K], GAIN * least);
    let mut least = 1.0_f64;
    let relative = |upper: &[[f64; K]; K], k: usize| upper[k][k] / scales[k];
    for _ in count..K {
        let among = || (0..K).filter(|&k| left[k]);
        let most = among().map(|k| relative(upper, k)).fold(0.0, f64::max);
        let best = among().find(|&k| relative(upper, k) >= ALIKE * most)?;
        left[best] = false;
        least = least.min(relative(upper, best));
        let pivot_row: [f64; K] = super::array(|j| upper[best.min(j)][best.max(j)]);
        for i in (0..K).filter(|&i| left[i]) {
            let factor = pivot_row[i] / pivot_row[best];
            for j in i..K {
                upper[i][j] -= factor * pivot_row[j];
            }
        }
    }
    let follows = |k: usize| relative(upper, k).abs() <= round_off(least).max(bound);
    (least > enough && (0..K).all(|k| !left[k] || follows(k))).then_some(left)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// S of rows in the plane, all of which follow from two of them.
    fn of_rows<const K: usize>(rows: [[f64; 2]; K]) -> [[f64; K]; K] {
        rows.map(|a| rows.map(|b| a[0] * b[0] + a[1] * b[1]))
    }

    #[test]
    fn the_most_independent_rows_are_kept() {
        let mut s = of_rows([[1.0, 0.0], [1.0, 1e-4], [0.0, 0.9]]);
        let left_out = dependent_rows(&mut s, &[1.0; 3], 1, [1e-8, 1e-10]);
        assert_eq!(left_out, Some([false, true, false]));
    }

    #[test]
    fn a_row_that_vanishes_is_left_out() {
        let mut s = of_rows([[1e-5, 0.0], [0.0, 1.0], [1.0, 1.0], [0.5, 0.2]]);
        let left_out = dependent_rows(&mut s, &[1.0; 4], 2, [1e-10, 1e-10]).unwrap();
        assert!(left_out[0]);
    }

    #[test]
    fn independent_rows_are_not_left_out() {
        let mut s = of_rows([[1.0, 0.0], [0.0, 1.0]]);
        assert_eq!(dependent_rows(&mut s, &[1.0; 2], 1, [0.0, 1e-10]), None);
    }
}
