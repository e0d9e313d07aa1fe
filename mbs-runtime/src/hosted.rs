//! What generated code names and only programs with the standard library have.

use core::marker::PhantomData;

/// The place of `Simulation`, which needs the feature `std`: a mechanism has an alias of it in every build. Without `std`
/// use [`FixedStepSimulation`](crate::FixedStepSimulation).
pub struct Simulation<S, const Q: usize, const N: usize, const R: usize>(PhantomData<S>);
