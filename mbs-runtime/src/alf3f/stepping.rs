//! The flow of a stepper with its workspace.

use super::implicit_step::ImplicitStep;
use super::large::LargeStep;
use super::sparse_kicks::SparseKicks;
use super::step_context::StepContext;
use crate::flow::{Leapfrog, Midpoint, Trapezoid};
use crate::memory::Box;
use crate::{Flow, Settings, System};

/// The flow and its workspace.
#[derive(Clone)]
pub(super) enum Stepping<const Q: usize, const N: usize, const R: usize> {
    Leapfrog(Leapfrog<Q, N, R>),
    /// The second is for steps near singular poses.
    Sparse(Box<SparseKicks<N, R>>, Leapfrog<Q, N, R>),
    Midpoint(Box<Midpoint<Q, N, R>>),
    Trapezoid(Box<Trapezoid<Q, N, R>>),
    /// The second is for steps near singular poses.
    Implicit(Box<ImplicitStep<Q, N, R>>, Box<Trapezoid<Q, N, R>>),
    /// The implicit step of large mechanisms.
    Large(LargeStep<Q, N, R>),
}

impl<const Q: usize, const N: usize, const R: usize> Stepping<Q, N, R> {
    /// For a mechanism at its state. (Not a part of the constructor of the stepper: its frame is on the stack below that of the
    /// context, and without optimisation each move of a large value takes room in it.)
    #[inline(never)]
    pub(super) fn new<S: System<Q, N, R>>(
        flow: Flow,
        context: &mut StepContext<S, Q, N, R>,
        settings: &Settings,
        large: Option<LargeStep<Q, N, R>>,
    ) -> Self {
        let yardstick = &*context.yardstick.clone();
        match flow {
            // Constants: the flows that this mechanism cannot have are not compiled for it.
            Flow::Leapfrog if const { S::STRUCTURE.allows(Flow::Leapfrog) } => {
                // The bound of the cost is for dense arrays, which steps beside singular poses need.
                let free = settings.fixed_iterations.is_none();
                match free.then(|| SparseKicks::new(context)).flatten() {
                    Some(kicks) => Stepping::Sparse(kicks, Leapfrog::new::<S>()),
                    None => Stepping::Leapfrog(Leapfrog::new::<S>()),
                }
            }
            Flow::Midpoint if const { S::STRUCTURE.allows(Flow::Midpoint) } => {
                Stepping::Midpoint(Midpoint::new(yardstick, settings.order > 2))
            }
            Flow::Trapezoid if const { S::STRUCTURE.allows(Flow::Trapezoid) } => {
                Stepping::Trapezoid(Trapezoid::new(yardstick, None))
            }
            // Every mechanism can have it.
            _ => match large {
                Some(mut large) => {
                    large.refresh(context);
                    Stepping::Large(large)
                }
                None => {
                    let beside = const { S::STRUCTURE.velocity_forces && R > 0 };
                    let factor = beside.then_some(&context.work.delassus);
                    Stepping::Implicit(ImplicitStep::new(), Trapezoid::new(yardstick, factor))
                }
            },
        }
    }
}
