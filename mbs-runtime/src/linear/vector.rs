//! Vector operations of fixed length.

/// a · b.
#[inline(always)]
pub(crate) fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    if N <= 8 {
        let mut sum = 0.0;
        for i in 0..N {
            sum += a[i] * b[i];
        }
        return sum;
    }
    // Four independent sums, because the compiler may not reorder one.
    let mut lanes = [0.0; 4];
    let (a4, b4) = (a.chunks_exact(4), b.chunks_exact(4));
    let rest: f64 = a4
        .remainder()
        .iter()
        .zip(b4.remainder())
        .map(|(x, y)| x * y)
        .sum();
    for (x, y) in a4.zip(b4) {
        for lane in 0..4 {
            lanes[lane] += x[lane] * y[lane];
        }
    }
    (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]) + rest
}

/// x ← x + Σ k_i rows_i.
#[inline(always)]
pub(crate) fn accumulate<const N: usize, const R: usize>(
    x: &mut [f64; N],
    rows: &[[f64; N]; R],
    k: &[f64; R],
) {
    for i in 0..R {
        let factor = k[i];
        if R >= super::SPARSE_FROM && factor == 0.0 {
            continue;
        }
        for j in 0..N {
            x[j] += factor * rows[i][j];
        }
    }
}

/// max |x_i|; NaN if any entry is NaN.
#[inline(always)]
pub(crate) fn largest(x: &[f64]) -> f64 {
    let (mut largest, mut sum) = (0.0, 0.0);
    for &value in x {
        let size = value.abs();
        if size > largest {
            largest = size;
        }
        sum += size;
    }
    // The comparison passes a NaN over, the sum does not.
    if sum.is_nan() { sum } else { largest }
}

/// Whether every entry is finite: one sum instead of a test per entry (an infinity or a NaN survives it).
#[inline(always)]
pub(crate) fn finite<const N: usize>(x: &[f64; N]) -> bool {
    let mut sum = 0.0;
    for value in x {
        sum += value * 0.0;
    }
    sum == 0.0
}

#[cfg(test)]
mod tests {
    use super::largest;

    #[test]
    fn the_largest_is_nan_wherever_one_is() {
        assert_eq!(largest(&[1.0, -3.0, 2.0]), 3.0);
        for i in 0..3 {
            let mut x = [1.0, 2.0, 3.0];
            x[i] = f64::NAN;
            assert!(largest(&x).is_nan());
        }
    }
}
