//! The tangent of ⊕ for finite rotations.
//!
//! A change δθ of the rotation vector θ (body axes) turns the end of q ∘ exp(θ/2) by T(θ) δθ, in the body axes there:
//!
//! ```text
//! T(θ) = I − (1 − cos θ)/θ² θ̂ + (θ − sin θ)/θ³ θ̂²
//! ```

use crate::System;
#[cfg(not(feature = "std"))]
use crate::elementary::Elementary as _;
use crate::linear::RowMatrix;
use nalgebra::SVector;

/// T(θ).
pub(crate) fn right_tangent([x, y, z]: [f64; 3]) -> [[f64; 3]; 3] {
    let square = x * x + y * y + z * z;
    // Below, the first neglected terms of the series are round-off.
    let (b, c) = if square < 1e-2 {
        let b = 0.5 - square * (1.0 / 24.0 - square * (1.0 / 720.0 - square / 40_320.0));
        let c = 1.0 / 6.0 - square * (1.0 / 120.0 - square * (1.0 / 5_040.0 - square / 362_880.0));
        (b, c)
    } else {
        let angle = square.sqrt();
        (
            (1.0 - angle.cos()) / square,
            (angle - angle.sin()) / (square * angle),
        )
    };
    let d = 1.0 - c * square;
    [
        [d + c * x * x, c * x * y + b * z, c * x * z - b * y],
        [c * x * y - b * z, d + c * y * y, c * y * z + b * x],
        [c * x * z + b * y, c * y * z - b * x, d + c * z * z],
    ]
}

/// x ← T(θ) x for each x, where `turn` holds the θ of all rotations (and anything for translations).
pub(crate) fn transport<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    turn: &SVector<f64, N>,
    vectors: &mut [SVector<f64, N>],
) {
    for &i in S::ROTATIONS {
        let tangent = right_tangent([turn[i], turn[i + 1], turn[i + 2]]);
        for x in &mut *vectors {
            let own = [x[i], x[i + 1], x[i + 2]];
            for k in 0..3 {
                x[i + k] = crate::linear::dot_of(&tangent[k], &own);
            }
        }
    }
}

/// T(θ)⁻¹ = I + ½ θ̂ + (1 − θ/2 cot θ/2)/θ² θ̂².
fn right_tangent_inverse([x, y, z]: [f64; 3]) -> [[f64; 3]; 3] {
    let square = x * x + y * y + z * z;
    // Below, the first neglected term of the series is round-off.
    let c = if square < 1e-2 {
        1.0 / 12.0 + square * (1.0 / 720.0 + square * (1.0 / 30_240.0 + square / 1_209_600.0))
    } else {
        let half = 0.5 * square.sqrt();
        (1.0 - half / half.tan()) / square
    };
    let d = 1.0 - c * square;
    [
        [d + c * x * x, c * x * y - 0.5 * z, c * x * z + 0.5 * y],
        [c * x * y + 0.5 * z, d + c * y * y, c * y * z - 0.5 * x],
        [c * x * z - 0.5 * y, c * y * z + 0.5 * x, d + c * z * z],
    ]
}

/// v ← T(θ)⁻¹ v: the rate of θ where the velocity is v.
#[inline(always)]
pub(crate) fn unroll<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    turn: &SVector<f64, N>,
    v: &mut SVector<f64, N>,
) {
    for &i in S::ROTATIONS {
        let inverse = right_tangent_inverse([turn[i], turn[i + 1], turn[i + 2]]);
        let own = [v[i], v[i + 1], v[i + 2]];
        for k in 0..3 {
            v[i + k] = crate::linear::dot_of(&inverse[k], &own);
        }
    }
}

/// m ← m T(θ): derivatives with respect to the end become derivatives with respect to θ.
pub(crate) fn pull_back<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    turn: &SVector<f64, N>,
    matrix: &mut RowMatrix<N, N>,
) {
    pull_back_rows::<S, Q, N, R>(turn, matrix.rows_mut());
}

/// The same for any number of rows.
pub(crate) fn pull_back_rows<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    turn: &SVector<f64, N>,
    matrix: &mut [SVector<f64, N>],
) {
    for &i in S::ROTATIONS {
        let tangent = right_tangent([turn[i], turn[i + 1], turn[i + 2]]);
        for row in &mut *matrix {
            let own = [row[i], row[i + 1], row[i + 2]];
            for k in 0..3 {
                row[i + k] = (0..3).map(|j| own[j] * tangent[j][k]).sum();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{right_tangent, right_tangent_inverse};
    use crate::generated::{rotation_between, turned};

    #[test]
    fn the_inverse_is_that_of_the_tangent() {
        for size in [1e-3, 0.09, 0.11, 2.0] {
            let theta = [0.6 * size, -0.48 * size, 0.64 * size];
            let (tangent, inverse) = (right_tangent(theta), right_tangent_inverse(theta));
            for i in 0..3 {
                for j in 0..3 {
                    let product: f64 = (0..3).map(|k| tangent[i][k] * inverse[k][j]).sum();
                    let unit = f64::from(u8::from(i == j));
                    assert!((product - unit).abs() < 1e-14, "{size} {i} {j}");
                }
            }
        }
    }

    #[test]
    fn the_tangent_is_that_of_turns() {
        let q = [0.5, -0.5, 0.5, 0.5];
        for size in [1e-3, 0.09, 0.11, 2.0] {
            let theta = [0.6 * size, -0.48 * size, 0.64 * size];
            let tangent = right_tangent(theta);
            for j in 0..3 {
                let end = |e: f64| {
                    let mut theta = theta;
                    theta[j] += e;
                    turned(q, theta, 1.0)
                };
                let slope = rotation_between(end(-1e-5), end(1e-5)).map(|x| x / 2e-5);
                for i in 0..3 {
                    assert!((tangent[i][j] - slope[i]).abs() < 1e-9, "{size} {i} {j}");
                }
            }
        }
    }
}
