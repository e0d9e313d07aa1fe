//! Products of tall narrow matrices with vectors.

/// y ← y + A x; columns of A begin at multiples of `stride`.
#[inline(always)]
pub(super) fn add_products(y: &mut [f64], a: &[f64], stride: usize, x: &[f64]) {
    let rows = y.len();
    if rows == 0 {
        return;
    }
    let column = |j: usize| &a[j * stride..][..rows];
    let (fours, rest) = x.as_chunks::<4>();
    for (group, x) in fours.iter().enumerate() {
        let [a0, a1, a2, a3] = [0, 1, 2, 3].map(|j| column(4 * group + j));
        for (i, y) in y.iter_mut().enumerate() {
            *y += (a0[i] * x[0] + a1[i] * x[1]) + (a2[i] * x[2] + a3[i] * x[3]);
        }
    }
    for (j, x) in rest.iter().enumerate() {
        for (y, a) in y.iter_mut().zip(column(4 * fours.len() + j)) {
            *y += a * x;
        }
    }
}

/// y ← y − Aᵀx, with sums in eight parts, which are the same for vectors of any width.
#[inline(always)]
pub(super) fn subtract_dots(y: &mut [f64], a: &[f64], x: &[f64]) {
    if x.is_empty() {
        return;
    }
    let (others, more) = x.as_chunks::<8>();
    for (y, column) in y.iter_mut().zip(a.chunks_exact(x.len())) {
        let (eights, rest) = column.as_chunks::<8>();
        let mut sums = [0.0; 8];
        for (a, x) in eights.iter().zip(others) {
            for lane in 0..8 {
                sums[lane] += a[lane] * x[lane];
            }
        }
        let rest = rest.iter().zip(more).map(|(a, x)| a * x);
        *y -= sums.iter().sum::<f64>() + rest.sum::<f64>();
    }
}
