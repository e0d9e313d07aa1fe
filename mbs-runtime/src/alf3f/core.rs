//! What every two-level step works on.

use super::{Fault, Node};
use crate::linear::{Dual, SymmetricDual, Thresholds, dot, largest};
use crate::{Settings, State, System};

/// Most passes of the iteration on the velocity rows, and where the cost of a step is fixed.
pub(super) const REFINEMENTS: usize = 10;
pub(crate) const FIXED_REFINEMENTS: usize = 2;

/// A distance, relative to the size of the mechanism, that a row may keep for one step when that step begins or ends so
/// close to a singular pose that its multiplier has no direction; the next step closes it.
const LOST: f64 = 1e-6;

/// System, state, and the workspace of a step.
pub(crate) struct Core<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    pub(crate) system: S,
    pub(crate) state: State<Q, N, R>,
    pub(crate) max_iterations: usize,
    pub(crate) fixed_iterations: Option<usize>,
    pub(crate) start: Box<Node<S, Q, N, R>>,
    pub(crate) end: Box<Node<S, Q, N, R>>,
    pub(crate) work: Box<Work<R>>,
    pub(crate) scale: RowScale<R>,
    pub(crate) counters: Counters,
}

/// Factorisations and multipliers of a step.
pub(crate) struct Work<const R: usize> {
    /// B.
    pub(crate) matrix: crate::linear::Matrix<R, R>,
    pub(crate) dual: Dual<R>,
    pub(crate) symmetric: SymmetricDual<R>,
    /// Impulses of the constraints at the two ends of the last step.
    pub(crate) impulse: [[f64; R]; 2],
    /// φ at the end of the last step.
    pub(crate) phi: [f64; R],
}

impl<const R: usize> Work<R> {
    #[inline(never)]
    fn new() -> Box<Self> {
        Box::new(Work {
            matrix: crate::linear::clear(),
            dual: Dual::new(),
            symmetric: SymmetricDual::new(),
            impulse: [[0.0; R]; 2],
            phi: [0.0; R],
        })
    }
}

/// Work done since the start.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Counters {
    pub(crate) stages: u64,
    pub(crate) iterations: u64,
    pub(crate) regularised: u64,
    pub(crate) rejected: u64,
}

/// Turns φ into a distance: |φ_i| ≤ tolerance · size · |a_i|, with |a_i| at the declared guess.
///
/// It depends on the system alone, so that a resumed run takes the same decisions.
#[derive(Clone, Copy)]
pub(crate) struct RowScale<const R: usize> {
    /// 1/(tolerance · size · |a_i|)².
    pub(crate) weights: [f64; R],
    /// (LOST / tolerance)².
    pub(crate) lost: f64,
}

/// The constraint geometry at the declared guess.
fn at_guess<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
) -> Result<Box<Node<S, Q, N, R>>, Fault> {
    let (q, _) = system.guess();
    let mut node = Node::new(system, &q)?;
    node.evaluate(system, 0.0, &q, &mut [0.0; R])?;
    Ok(node)
}

impl<const R: usize> RowScale<R> {
    pub(crate) fn new<S: System<Q, N, R>, const Q: usize, const N: usize>(
        system: &S,
        tolerance: f64,
    ) -> Result<Self, Fault> {
        let (q, _) = system.guess();
        let size = tolerance * largest(&q).max(1.0);
        let node = at_guess(system)?;
        let lengths = node.lengths_squared();
        let longest = largest(&lengths);
        let weights = std::array::from_fn(|i| {
            // A row that vanishes at the guess has no length to go by there.
            let length = if lengths[i] > 1e-8 * longest {
                dot(&node.a[i], &node.a[i])
            } else {
                1.0
            };
            1.0 / (size * size * length)
        });
        Ok(RowScale {
            weights,
            lost: (LOST / tolerance).powi(2).max(super::kicks::STAGNATED),
        })
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Core<S, Q, N, R> {
    pub(crate) fn new(
        system: S,
        state: State<Q, N, R>,
        settings: &Settings,
        placed: bool,
    ) -> Result<Self, Fault> {
        let node = Node::new(&system, &state.positions)?;
        let mut core = Core {
            scale: RowScale::new(&system, settings.constraint_tolerance)?,
            system,
            state,
            max_iterations: settings.max_iterations,
            fixed_iterations: settings.fixed_iterations,
            end: node.clone(),
            start: node,
            work: Work::new(),
            counters: Counters::default(),
        };
        if settings.order > 2 {
            let usual = SymmetricDual::new().least_pivot(&at_guess(&core.system)?.gram);
            let thresholds = Thresholds::high_order(usual, placed);
            (core.work.symmetric.thresholds, core.work.dual.thresholds) = (thresholds, thresholds);
        }
        core.refresh()?;
        (core.work.symmetric).expect_redundancy(&core.start.gram);
        if S::STRUCTURE.holonomic_rows < R {
            core.refresh()?;
        }
        Ok(core)
    }

    /// Recomputes what is known of the current instant, after the state or an input was changed from outside.
    pub(crate) fn refresh(&mut self) -> Result<(), Fault> {
        let Core {
            system,
            state,
            start,
            work,
            ..
        } = self;
        start.evaluate(system, state.time, &state.positions, &mut work.phi)?;
        if S::STRUCTURE.holonomic_rows == R {
            work.symmetric.factor(&start.gram);
        } else {
            super::mixed_kicks::factor_holonomic(start, work);
        }
        Ok(())
    }

    /// The end of the step becomes the start of the next one. `weak`: rows were redundant, or nearly so.
    #[inline(always)]
    pub(crate) fn commit(
        &mut self,
        time: f64,
        h: f64,
        q: [f64; Q],
        v: [f64; N],
        weak: bool,
    ) -> Result<(), Fault> {
        if !crate::linear::finite(&q) {
            return Err(Fault::NonFinite("positions"));
        }
        if !crate::linear::finite(&v) {
            return Err(Fault::NonFinite("velocities"));
        }
        self.state.time = time;
        self.state.positions = q;
        self.state.velocities = v;
        self.state.keep_impulse(h, &self.work.impulse[0], weak);
        std::mem::swap(&mut self.start, &mut self.end);
        self.counters.stages += 1;
        Ok(())
    }

    /// Projects v onto A v + b = 0 at the end of the step and stores the multiplier κ₂.
    #[inline(always)]
    pub(crate) fn project_velocity(&mut self, v: &mut [f64; N]) {
        let Core {
            system,
            end,
            work,
            counters,
            fixed_iterations,
            ..
        } = self;
        work.symmetric.factor(&end.gram);
        let mut multiplier = end.velocity_rows(system, v).map(|rate| -rate);
        work.symmetric.solve(&mut multiplier);
        crate::linear::accumulate(v, &end.w, &multiplier);
        work.impulse[1] = multiplier;
        counters.regularised += u64::from(work.symmetric.reduced);
        if work.symmetric.weak {
            counters.regularised += u64::from(work.symmetric.regularised);
            let passes = fixed_iterations.map_or(REFINEMENTS, |_| FIXED_REFINEMENTS);
            refine(system, end, work, v, passes);
        }
    }
}

/// Iterates on what a nearly singular solve has left of A v + b: the proximal one leaves a part of all that lies in
/// nearly lost directions, elimination some digits.
#[cold]
#[inline(never)]
fn refine<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    end: &Node<S, Q, N, R>,
    work: &mut Work<R>,
    v: &mut [f64; N],
    passes: usize,
) {
    let tolerance = 1e-14 * largest(&v[..]);
    let mut last = f64::INFINITY;
    for _ in 0..passes {
        let mut multiplier = end.velocity_rows(system, v).map(|rate| -rate);
        let residual = largest(&multiplier);
        if residual <= tolerance || residual > 0.9 * last {
            return;
        }
        last = residual;
        work.symmetric.solve(&mut multiplier);
        crate::linear::accumulate(v, &end.w, &multiplier);
        for i in 0..R {
            work.impulse[1][i] += multiplier[i];
        }
    }
}
