//! Vectors of fixed length.
//!
//! Sums keep their order of terms: a step has the same digits whatever the library's own order is.

use nalgebra::{SMatrix, SVector};

/// The vector with these entries.
#[inline(always)]
pub(crate) fn vector<const N: usize>(entry: impl FnMut(usize) -> f64) -> SVector<f64, N> {
    SVector::from(array(entry))
}

/// The array with these entries. (The loop is a few lines where `core::array::from_fn` is hundreds, for every mechanism and
/// every closure, that the optimiser has to remove.)
#[inline(always)]
pub(crate) fn array<T: Copy + Default, const N: usize>(
    mut entry: impl FnMut(usize) -> T,
) -> [T; N] {
    let mut entries = [T::default(); N];
    for i in 0..N {
        entries[i] = entry(i);
    }
    entries
}

/// The entries of a vector. (An index of the vector itself is five calls where nothing is inlined.)
#[inline(always)]
pub fn entries<const N: usize>(vector: &SVector<f64, N>) -> &[f64; N] {
    &vector.data.0[0]
}

/// The entries of a vector, to be written.
#[inline(always)]
pub fn entries_mut<const N: usize>(vector: &mut SVector<f64, N>) -> &mut [f64; N] {
    &mut vector.data.0[0]
}

/// s x.
#[inline(always)]
pub(crate) fn scaled<const N: usize>(scale: f64, x: &SVector<f64, N>) -> SVector<f64, N> {
    let x = entries(x);
    vector(|i| scale * x[i])
}

/// x + s y.
#[inline(always)]
pub(crate) fn added<const N: usize>(
    x: &SVector<f64, N>,
    scale: f64,
    y: &SVector<f64, N>,
) -> SVector<f64, N> {
    let (x, y) = (entries(x), entries(y));
    vector(|i| x[i] + scale * y[i])
}

/// x ← x + y.
#[inline(always)]
pub(crate) fn add<const N: usize>(x: &mut SVector<f64, N>, y: &SVector<f64, N>) {
    add_scaled(x, 1.0, y);
}

/// x ← x + s y.
#[inline(always)]
pub(crate) fn add_scaled<const N: usize>(x: &mut SVector<f64, N>, scale: f64, y: &SVector<f64, N>) {
    let (x, y) = (entries_mut(x), entries(y));
    for i in 0..N {
        x[i] += scale * y[i];
    }
}

/// a_i b_i.
#[inline(always)]
pub(crate) fn products<const N: usize>(
    a: &SVector<f64, N>,
    b: &SVector<f64, N>,
) -> SVector<f64, N> {
    let (a, b) = (entries(a), entries(b));
    vector(|i| a[i] * b[i])
}

/// The vector of zeros.
#[inline(always)]
pub(crate) fn zeros<const N: usize>() -> SVector<f64, N> {
    SVector::from([0.0; N])
}

/// −x.
#[inline(always)]
pub(crate) fn negative<const N: usize>(x: &SVector<f64, N>) -> SVector<f64, N> {
    let x = entries(x);
    vector(|i| -x[i])
}

/// a · b.
#[inline(always)]
pub(crate) fn dot<const N: usize>(a: &SVector<f64, N>, b: &SVector<f64, N>) -> f64 {
    dot_of(entries(a), entries(b))
}

/// The same for arrays.
#[inline(always)]
pub(crate) fn dot_of<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
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
    x: &mut SVector<f64, N>,
    rows: &SMatrix<f64, N, R>,
    k: &SVector<f64, R>,
) {
    let ([x], [k]) = (&mut x.data.0, &k.data.0);
    for (row, &factor) in rows.data.0.iter().zip(k) {
        if R >= super::SPARSE_FROM && factor == 0.0 {
            continue;
        }
        for j in 0..N {
            x[j] += factor * row[j];
        }
    }
}

/// The larger of two numbers; the first, if any is not a number.
#[inline(always)]
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// max |x_i|; NaN if any entry is NaN.
#[inline(always)]
pub(crate) fn largest<const N: usize>(x: &SVector<f64, N>) -> f64 {
    largest_of(entries(x))
}

/// The same for any number of values.
#[inline(always)]
pub(crate) fn largest_of(values: &[f64]) -> f64 {
    let (mut largest, mut sum) = (0.0, 0.0);
    for &value in values {
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
pub(crate) fn finite<const N: usize>(x: &SVector<f64, N>) -> bool {
    let mut sum = 0.0;
    for value in entries(x) {
        sum += value * 0.0;
    }
    sum == 0.0
}

#[cfg(test)]
mod tests {
    use super::largest_of;

    #[test]
    fn the_largest_is_nan_wherever_one_is() {
        assert_eq!(largest_of(&[1.0, -3.0, 2.0]), 3.0);
        for i in 0..3 {
            let mut x = [1.0, 2.0, 3.0];
            x[i] = f64::NAN;
            assert!(largest_of(&x).is_nan());
        }
    }
}
