//! Radau IIA of three stages: Hairer, Wanner, Solving Ordinary Differential Equations II, table IV.5.6 and section IV.8.

use nalgebra::Complex;

/// √6.
const ROOT: f64 = 2.449_489_742_783_178;

/// c.
pub(super) const NODES: [f64; 3] = [(4.0 - ROOT) / 10.0, (4.0 + ROOT) / 10.0, 1.0];

/// a_ij; the last row has the weights of the step.
pub(super) const WEIGHTS: [[f64; 3]; 3] = [
    [
        (88.0 - 7.0 * ROOT) / 360.0,
        (296.0 - 169.0 * ROOT) / 1800.0,
        (-2.0 + 3.0 * ROOT) / 225.0,
    ],
    [
        (296.0 + 169.0 * ROOT) / 1800.0,
        (88.0 + 7.0 * ROOT) / 360.0,
        (-2.0 - 3.0 * ROOT) / 225.0,
    ],
    [(16.0 - ROOT) / 36.0, (16.0 + ROOT) / 36.0, 1.0 / 9.0],
];

/// γ₀ dᵢ of the embedded formula of order 3, with γ₀ = [`REAL`]: (8.19) there.
pub(super) const EMBEDDED: [f64; 3] = [
    -REAL * (13.0 + 7.0 * ROOT) / 3.0,
    -REAL * (13.0 - 7.0 * ROOT) / 3.0,
    -REAL / 3.0,
];

/// The eigenvalues of (a_ij): the real one, …
pub(super) const REAL: f64 = 1.0 / 3.637_834_252_744_496;

/// … and one of the pair, 1/(α + iβ).
pub(super) const COMPLEX: Complex<f64> = {
    let (alpha, beta) = (2.681_082_873_627_752, 3.050_430_199_247_411);
    let square = alpha * alpha + beta * beta;
    Complex::new(alpha / square, -beta / square)
};

/// The columns are the real eigenvector, and the parts of a complex one by which real and imaginary parts are multiplied.
pub(super) const FROM_BASIS: [[f64; 3]; 3] = [
    [
        9.123_239_487_089_294e-2,
        -0.141_255_295_020_954_2,
        -3.002_919_410_514_742_5e-2,
    ],
    [
        0.241_717_932_707_107,
        0.204_129_352_293_799_93,
        0.382_942_112_757_261_9,
    ],
    [0.966_048_182_615_092_9, 1.0, 0.0],
];

/// The inverse.
pub(super) const INTO_BASIS: [[f64; 3]; 3] = [
    [
        4.325_579_890_063_155,
        0.339_199_251_815_809_84,
        0.541_770_539_935_874_9,
    ],
    [
        -4.178_718_591_551_905,
        -0.327_682_820_761_062_37,
        0.476_623_554_500_550_43,
    ],
    [
        -0.502_872_634_945_786_9,
        2.571_926_949_855_605,
        -0.596_039_204_828_224_9,
    ],
];

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Matrix3;

    fn matrix(rows: [[f64; 3]; 3]) -> Matrix3<f64> {
        Matrix3::from_fn(|i, j| rows[i][j])
    }

    #[test]
    fn the_basis_makes_the_matrix_diagonal() {
        let (from, into) = (matrix(FROM_BASIS), matrix(INTO_BASIS));
        assert!((from * into - Matrix3::identity()).amax() < 1e-14);
        // (re, im) times the eigenvalue of the pair.
        let Complex { re, im } = COMPLEX;
        let diagonal = Matrix3::new(REAL, 0.0, 0.0, 0.0, re, -im, 0.0, im, re);
        let difference = into * matrix(WEIGHTS) * from - diagonal;
        assert!(difference.amax() < 1e-14, "{difference}");
    }

    #[test]
    fn the_embedded_formula_has_order_three() {
        for degree in 1..5 {
            // x' = degree · t^(degree − 1): its derivative at the start, and x at the nodes.
            let start = if degree == 1 { REAL } else { 0.0 };
            let terms = EMBEDDED.iter().zip(NODES);
            let sum: f64 = terms.map(|(d, node)| d * node.powi(degree)).sum();
            assert_eq!((start + sum).abs() < 1e-14, degree < 4, "{degree}");
        }
    }

    #[test]
    fn the_weights_integrate_polynomials() {
        for degree in 0..5 {
            let power = |node: f64| node.powi(degree);
            let sum: f64 = WEIGHTS[2]
                .iter()
                .zip(NODES)
                .map(|(b, c)| b * power(c))
                .sum();
            assert!((sum - 1.0 / f64::from(degree + 1)).abs() < 1e-15);
        }
    }
}
