//! What stands for the sparse step where the feature `sparse` is off.

use crate::alf3f::step_context::StepContext;
use crate::fault::Fault;
use crate::{State, System};
use core::convert::Infallible;
use core::marker::PhantomData;
use nalgebra::SVector;

/// There is none.
#[derive(Clone)]
pub(crate) struct SparseStep<const Q: usize, const N: usize, const R: usize> {
    never: Infallible,
    sizes: PhantomData<(SVector<f64, N>, SVector<f64, R>)>,
}

impl<const Q: usize, const N: usize, const R: usize> SparseStep<Q, N, R> {
    pub(crate) fn new<S: System<Q, N, R>>(_: &S, _: &State<Q, N, R>) -> Option<Self> {
        None
    }

    pub(crate) fn step<S: System<Q, N, R>>(
        &mut self,
        _: &mut StepContext<S, Q, N, R>,
        _: f64,
    ) -> Result<(), Fault> {
        match self.never {}
    }

    pub(crate) fn refresh<S: System<Q, N, R>>(&mut self, _: &mut StepContext<S, Q, N, R>) {
        match self.never {}
    }

    pub(crate) fn rates<S: System<Q, N, R>>(&self, _: &StepContext<S, Q, N, R>) -> SVector<f64, R> {
        match self.never {}
    }
}
