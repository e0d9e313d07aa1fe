//! The dense factor of M, and products with it.

use mbs_runtime::generated::{Cholesky, delassus};
use mbs_runtime::nalgebra::SMatrix;

/// M = B Bᵀ + 1, and rows of A with zeros.
fn case<const N: usize, const R: usize>() -> (SMatrix<f64, N, N>, SMatrix<f64, N, R>) {
    let entry = |i: usize, j: usize| (37.0 * i as f64 + 11.0 * j as f64).sin();
    let factor = SMatrix::<f64, N, N>::from_fn(|i, j| if i + 1 < j { 0.0 } else { entry(i, j) });
    let rows = SMatrix::<f64, N, R>::from_fn(|i, j| match (i + j) % 3 {
        0 => 0.0,
        _ => entry(i, j),
    });
    (factor * factor.transpose() + SMatrix::identity(), rows)
}

fn check<const N: usize, const R: usize>() {
    let (mass, a) = case::<N, R>();
    let factor = Cholesky::new(&mass).expect("it is positive definite");
    let mut w = SMatrix::<f64, N, R>::zeros();
    factor.solve_rows(&a, &mut w);
    let left = (mass * w - a).amax();
    assert!(left < 1e-12, "{N} velocities, {R} rows: {left:e}");
    for (row, solution) in a.column_iter().zip(w.column_iter()) {
        let mut x = row.into_owned();
        factor.solve(&mut x);
        assert!((x - solution).amax() < 1e-12);
    }
    let mut products = SMatrix::<f64, R, R>::zeros();
    delassus(&a, &w, &mut products);
    // Its columns are rows.
    let expected = w.transpose() * a;
    assert!((products - expected).amax() < 1e-12);
}

/// Few rows, one more than fit together, and more than the columns of a block.
#[test]
fn rows_are_solved_together() {
    check::<5, 3>();
    check::<12, 1>();
    check::<12, 3>();
    check::<18, 9>();
    check::<25, 15>();
    check::<40, 17>();
}

#[test]
fn what_is_not_positive_definite_is_refused() {
    let mut mass = SMatrix::<f64, 12, 12>::identity();
    assert!(Cholesky::new(&mass).is_some());
    mass[(7, 7)] = 0.0;
    assert!(Cholesky::new(&mass).is_none());
    mass[(7, 7)] = f64::NAN;
    assert!(Cholesky::new(&mass).is_none());
}
