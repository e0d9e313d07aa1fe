//! The rows at a state, in the metric of the mass matrix: least norm where rows follow from others.

use mbs_runtime::nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// Eigenvalues of the scaled rows below this belong to rows that follow from others.
const DEPENDENT: f64 = 1e-10;

/// M, A and M⁻¹ Aᵀ with the eigenvalues of the scaled A M⁻¹ Aᵀ.
pub struct Metric {
    mass: Cholesky<f64, Dyn>,
    rows: DMatrix<f64>,
    weighted: DMatrix<f64>,
    scale: DVector<f64>,
    eigenvectors: DMatrix<f64>,
    eigenvalues: DVector<f64>,
}

impl Metric {
    /// From M and A; `None` if M is not positive definite.
    pub fn new(mass: DMatrix<f64>, rows: DMatrix<f64>) -> Option<Self> {
        let mass = mass.cholesky()?;
        let weighted = mass.solve(&rows.transpose());
        let delassus = &rows * &weighted;
        // A row that vanishes here is one that follows from others.
        let scale = delassus.diagonal().map(|x| match x > 0.0 {
            true => x.sqrt(),
            false => 1.0,
        });
        let scaled = DMatrix::from_fn(scale.len(), scale.len(), |i, j| {
            delassus[(i, j)] / (scale[i] * scale[j])
        });
        let (eigenvectors, eigenvalues) = match scale.is_empty() {
            true => (scaled, scale.clone()),
            false => {
                let eigen = scaled.symmetric_eigen();
                (eigen.eigenvectors, eigen.eigenvalues)
            }
        };
        Some(Metric {
            mass,
            rows,
            weighted,
            scale,
            eigenvectors,
            eigenvalues,
        })
    }

    /// The rank of A.
    pub fn rank(&self) -> usize {
        let counting = self.eigenvalues.iter();
        counting.filter(|&&value| value > DEPENDENT).count()
    }

    /// The smallest eigenvalue that counts, 1 without rows: near 0 beside a singular pose.
    pub fn margin(&self) -> f64 {
        let counting = self.eigenvalues.iter();
        let counting = counting.filter(|&&value| value > DEPENDENT);
        counting.fold(1.0, |least, &value| least.min(value))
    }

    /// x·M x.
    pub fn square(&self, x: &DVector<f64>) -> f64 {
        self.mass.l().tr_mul(x).norm_squared()
    }

    /// M⁻¹ x.
    pub fn free(&self, x: &DVector<f64>) -> DVector<f64> {
        self.mass.solve(x)
    }

    /// x + M⁻¹ Aᵀ λ with A (x + M⁻¹ Aᵀ λ) + b = 0, and the λ of least norm.
    pub fn onto_rows(&self, x: &DVector<f64>, b: &DVector<f64>) -> [DVector<f64>; 2] {
        let missing = -b - &self.rows * x;
        let mut parts = self
            .eigenvectors
            .tr_mul(&missing.component_div(&self.scale));
        for (part, &value) in parts.iter_mut().zip(&self.eigenvalues) {
            *part = if value > DEPENDENT {
                *part / value
            } else {
                0.0
            };
        }
        let lambda = (&self.eigenvectors * parts).component_div(&self.scale);
        [x + &self.weighted * &lambda, lambda]
    }

    /// The largest |A v + b|, relative to the length of the row.
    pub fn residual(&self, v: &DVector<f64>, b: &DVector<f64>) -> f64 {
        (&self.rows * v + b)
            .component_div(&self.scale)
            .iter()
            .fold(0.0, |most, x| x.abs().max(most))
    }
}
