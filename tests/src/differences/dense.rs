//! Functions of a system that return dense matrices.

use mbs_runtime::System;
use mbs_runtime::nalgebra::{SMatrix, SVector};

/// All functions of a system in dense form, because closures of their arguments would be long.
pub(super) struct Dense<'a, S, const Q: usize, const N: usize, const R: usize>(pub(super) &'a S);

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Dense<'_, S, Q, N, R> {
    pub(super) fn mass(&self, q: &SVector<f64, Q>) -> Box<SMatrix<f64, N, N>> {
        let mut mass = zeros();
        self.0.mass_matrix(q, &mut mass);
        mass
    }
    pub(super) fn momentum(&self, q: &SVector<f64, Q>, v: &SVector<f64, N>) -> SVector<f64, N> {
        let mut p = SVector::zeros();
        self.0.momentum(q, v, &mut p);
        p
    }
    pub(super) fn holonomic(&self, t: f64, q: &SVector<f64, Q>) -> SVector<f64, R> {
        let mut phi = SVector::zeros();
        self.0.holonomic(t, q, &mut phi);
        phi
    }
    /// φ, A, b.
    pub(super) fn constraints(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
    ) -> (SVector<f64, R>, Box<SMatrix<f64, R, N>>, SVector<f64, R>) {
        let (mut phi, mut a, mut b) = (SVector::zeros(), zeros(), SVector::zeros());
        self.0.constraints(t, q, &mut phi, &mut a, &mut b);
        (phi, a, b)
    }
    /// A v + b.
    pub(super) fn rates(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
    ) -> SVector<f64, R> {
        let (_, a, b) = self.constraints(t, q);
        *a * v + b
    }
    pub(super) fn constraint_rates(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
    ) -> (Box<SMatrix<f64, R, N>>, SVector<f64, R>) {
        let (mut rate, mut gamma) = (zeros(), SVector::zeros());
        self.0.constraint_rates(t, q, v, &mut rate, &mut gamma);
        (rate, gamma)
    }
    pub(super) fn applied(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
    ) -> SVector<f64, N> {
        let mut f = SVector::zeros();
        self.0.applied_forces(t, q, v, &mut f);
        f
    }
    pub(super) fn total(
        &self,
        t: f64,
        q: &SVector<f64, Q>,
        v: &SVector<f64, N>,
    ) -> SVector<f64, N> {
        let mut f = SVector::zeros();
        self.0.forces(t, q, v, &mut f);
        f
    }
}

pub(super) fn zeros<const ROWS: usize, const COLUMNS: usize>() -> Box<SMatrix<f64, ROWS, COLUMNS>> {
    Box::new(SMatrix::zeros())
}

/// Entries, column by column.
pub(super) fn list<const ROWS: usize, const COLUMNS: usize>(
    matrix: &SMatrix<f64, ROWS, COLUMNS>,
) -> Vec<f64> {
    matrix.as_slice().to_vec()
}

pub(super) fn unit<const N: usize>(i: usize) -> SVector<f64, N> {
    SVector::from_fn(|j, _| f64::from(u8::from(i == j)))
}
