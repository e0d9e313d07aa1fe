//! No planned elimination: without the feature `std` large mechanisms have none, as its arrays are on the heap.

use super::step_context::StepContext;
use crate::System;
use crate::fault::Fault;
use crate::flow::Leapfrog;
use crate::memory::Box;
use crate::singular::RankMargin;
use core::marker::PhantomData;
use nalgebra::SVector;

/// There is no value of this type.
#[derive(Clone)]
pub(crate) struct SparseKicks<const N: usize, const R: usize> {
    never: core::convert::Infallible,
    _sizes: PhantomData<[[(); N]; R]>,
}

impl<const N: usize, const R: usize> SparseKicks<N, R> {
    /// Dense arrays, whatever the mechanism.
    pub(super) fn usual_pivot<S: System<Q, N, R>, const Q: usize>(_: &S) -> Option<f64> {
        None
    }

    /// None, whatever the mechanism.
    pub(super) fn new<S: System<Q, N, R>, const Q: usize>(
        _: &mut StepContext<S, Q, N, R>,
    ) -> Option<Box<Self>> {
        None
    }

    pub(super) fn refresh<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        _: &mut StepContext<S, Q, N, R>,
    ) {
        match self.never {}
    }

    pub(super) fn rates<S: System<Q, N, R>, const Q: usize>(
        &self,
        _: &StepContext<S, Q, N, R>,
    ) -> SVector<f64, R> {
        match self.never {}
    }

    pub(super) fn rank_margin(&self) -> RankMargin {
        match self.never {}
    }

    pub(super) fn weakest_rows(&mut self) -> SVector<f64, R> {
        match self.never {}
    }

    pub(super) fn step<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        _: &mut StepContext<S, Q, N, R>,
        _: &mut Leapfrog<Q, N, R>,
        _: f64,
    ) -> Result<(), Fault> {
        match self.never {}
    }
}
