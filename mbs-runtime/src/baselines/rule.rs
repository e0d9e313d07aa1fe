//! What the baselines have in common: steps from the state of the bench.

use super::bench::Bench;
use crate::estimate::Estimate;
use crate::fault::Fault;
use crate::singular::RankMargin;
use crate::{Settings, System};
use nalgebra::SVector;

/// A method and its workspace.
pub(crate) trait Rule<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>:
    BoxedRule<S, Q, N, R> + Send + Sync
{
    /// Advances by h seconds.
    fn advance(&mut self, bench: &mut Bench<S, Q, N, R>, h: f64) -> Result<(), Fault>;

    /// Forgets what is known of the current instant, after the state or an input was changed.
    fn refresh(&mut self) {}

    /// The rank margin of the rows at the current state; `None` if there are no rows, or if the method does not compute
    /// it.
    fn rank_margin(&mut self, _: &mut Bench<S, Q, N, R>) -> Option<RankMargin> {
        None
    }

    /// The weight of each row in the combination that is nearest to dependence.
    fn weakest_rows(&mut self, _: &Bench<S, Q, N, R>) -> SVector<f64, R> {
        SVector::zeros()
    }

    /// The error of the last step by an embedded method; `None` without one.
    fn estimate(&self, _: &Bench<S, Q, N, R>) -> Option<Estimate> {
        None
    }

    /// Whether its elimination is planned.
    fn is_sparse(&self) -> bool {
        false
    }

    /// How far the evaluations of the last step stayed from singular poses, as a fraction of the way.
    fn clearance(&self) -> f64 {
        f64::INFINITY
    }

    /// The clearance of a step of this length, as a fraction of the last one; NaN if it is not known.
    fn expected_clearance(&self, _length: f64) -> f64 {
        f64::NAN
    }

    /// The singular pose, or one that is nearly singular, that the stages of the last step have seen within it, as a fraction of
    /// the step.
    fn pose_within(&self) -> Option<f64> {
        None
    }
}

/// A copy of a rule behind a box; every rule that can be cloned has it.
pub(crate) trait BoxedRule<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    /// The rule and its workspace again.
    fn boxed_clone(&self) -> AnyRule<S, Q, N, R>;
}

impl<T, S, const Q: usize, const N: usize, const R: usize> BoxedRule<S, Q, N, R> for T
where
    T: Rule<S, Q, N, R> + Clone + 'static,
    S: System<Q, N, R>,
{
    fn boxed_clone(&self) -> AnyRule<S, Q, N, R> {
        Box::new(self.clone())
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Clone
    for AnyRule<S, Q, N, R>
{
    fn clone(&self) -> Self {
        self.as_ref().boxed_clone()
    }
}

/// A rule that a program has compiled.
pub(crate) type AnyRule<S, const Q: usize, const N: usize, const R: usize> =
    Box<dyn Rule<S, Q, N, R>>;

/// Makes the rule of the settings for a bench at its start; `None` if they have another method.
pub(crate) type MakeRule<S, const Q: usize, const N: usize, const R: usize> =
    fn(&Bench<S, Q, N, R>, &Settings) -> Option<Result<AnyRule<S, Q, N, R>, Fault>>;
