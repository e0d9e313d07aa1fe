//! Data of every two-level step.

use super::closing::residual_of;
use super::closing::{Refining, refine};
use crate::constraint_geometry::ConstraintGeometry;
use crate::fault::Fault;
use crate::linear::{DelassusFactor, ProjectionLu, RowMatrix, negative, vector};
use crate::memory::Box;
use crate::row_scale::RowScale;
use crate::singular::{RankMargin, Thresholds};
use crate::yardstick::Yardstick;
use crate::{Settings, State, System};
use nalgebra::SVector;

/// Most passes of the iteration on the velocity rows: in general, and with `fixed_iterations`.
pub(super) const REFINEMENTS: usize = 10;
pub(crate) const FIXED_REFINEMENTS: usize = 2;
/// After more corrections of κ₁ than this the rows may hold in another pose than that of the motion: a few lead to the
/// near one.
pub(super) const PROMPT: usize = 4;
/// The way of a stage, in lengths of the mechanism or radians, that its velocities do not account for, from which the
/// pose at its end has nothing to do with that at its beginning.
const ASTRAY: f64 = 1.0;

/// When the dense arrays of a step are filled.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Dense {
    AtOnce,
    /// Before the first step that needs them: the others are sparse. With the smallest relative pivot at the declared guess.
    WhenNeeded(f64),
    Never,
}

/// System, state, and the workspace of a step.
#[derive(Clone)]
pub(crate) struct StepContext<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    pub(crate) system: S,
    pub(crate) state: State<Q, N, R>,
    /// The time at the end of the stage under way, s: that of the state from which the next one begins, to the last bit.
    pub(super) end_time: f64,
    pub(crate) max_iterations: usize,
    pub(crate) fixed_iterations: Option<usize>,
    pub(crate) start: Box<ConstraintGeometry<S, Q, N, R>>,
    pub(crate) end: Box<ConstraintGeometry<S, Q, N, R>>,
    pub(crate) work: Box<Workspace<R>>,
    pub(crate) scale: RowScale<R>,
    pub(crate) yardstick: Box<Yardstick<Q, N>>,
    pub(crate) counters: Counters,
    /// Where the run began, until the dense arrays have been filled, if that is done when they are needed.
    #[cfg(feature = "std")]
    begun: Option<Box<(f64, SVector<f64, Q>)>>,
}

/// Factorisations and multipliers of a step.
#[derive(Clone)]
pub(crate) struct Workspace<const R: usize> {
    /// B.
    pub(crate) matrix: RowMatrix<R, R>,
    pub(crate) projection: ProjectionLu<R>,
    pub(crate) delassus: DelassusFactor<R>,
    /// Impulses of the constraints at the two ends of the last step.
    pub(crate) impulse: [SVector<f64, R>; 2],
    /// φ at the end of the last step.
    pub(crate) phi: SVector<f64, R>,
}

impl<const R: usize> Workspace<R> {
    #[inline(never)]
    fn new() -> Box<Self> {
        Box::new(Workspace {
            matrix: RowMatrix::zeros(),
            projection: ProjectionLu::new(),
            delassus: DelassusFactor::new(),
            impulse: [SVector::zeros(); 2],
            phi: SVector::zeros(),
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

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> StepContext<S, Q, N, R> {
    pub(crate) fn new(
        system: S,
        state: State<Q, N, R>,
        settings: &Settings,
        placed: bool,
        dense: Dense,
    ) -> Result<Self, Fault> {
        let geometry = ConstraintGeometry::new(&system, &state.positions)?;
        let yardstick = Box::new(Yardstick::new(&system, settings.step));
        let mut context = StepContext {
            scale: RowScale::new(&system, &yardstick, settings)?,
            yardstick,
            system,
            end_time: state.time,
            state,
            max_iterations: settings.max_iterations,
            fixed_iterations: settings.fixed_iterations,
            end: geometry.clone(),
            start: geometry,
            work: Workspace::new(),
            counters: Counters::default(),
            #[cfg(feature = "std")]
            begun: None,
        };
        let guess = match dense {
            Dense::Never => return Ok(context),
            Dense::WhenNeeded(_) => None,
            Dense::AtOnce => Some(ConstraintGeometry::at_guess(&context.system)?),
        };
        let thresholds = match (settings.order, placed) {
            (2, false) => Thresholds::SECOND_ORDER,
            (2, true) => Thresholds::SECOND_ORDER_PLACED,
            _ => {
                let usual = match (&guess, dense) {
                    (Some(guess), _) => DelassusFactor::new().least_pivot(&guess.delassus),
                    (None, Dense::WhenNeeded(usual)) => usual,
                    (None, _) => 1.0,
                };
                Thresholds::high_order(usual, placed)
            }
        };
        let work = &mut context.work;
        (work.delassus.thresholds, work.projection.thresholds) = (thresholds, thresholds);
        context.work.delassus.usual = context.scale.usual;
        let Some(guess) = guess else {
            #[cfg(feature = "std")]
            {
                let State {
                    time, positions, ..
                } = &context.state;
                context.begun = Some(Box::new((*time, *positions)));
            }
            return Ok(context);
        };
        context.refresh()?;
        (context.work.delassus).expect_redundancy(&context.start.delassus);
        (context.work.delassus).expect_pivots(&guess.delassus);
        context.refresh()?;
        Ok(context)
    }

    /// Fills the dense arrays for the current instant; for the first time after [`Dense::WhenNeeded`] it also learns which
    /// rows are redundant, at the beginning of the run.
    #[cfg(feature = "std")]
    #[cold]
    #[inline(never)]
    pub(super) fn fill_dense(&mut self) -> Result<(), Fault> {
        if let Some((time, positions)) = self.begun.as_deref() {
            let guess = ConstraintGeometry::at_guess(&self.system)?;
            let (start, work) = (&mut self.start, &mut self.work);
            start.evaluate(&self.system, *time, positions, &mut work.phi)?;
            work.delassus.expect_redundancy(&start.delassus);
            work.delassus.expect_pivots(&guess.delassus);
            self.begun = None;
        }
        self.refresh()
    }

    /// Recomputes what is known of the current instant, after the state or an input was changed from outside.
    pub(crate) fn refresh(&mut self) -> Result<(), Fault> {
        let StepContext {
            system,
            state,
            start,
            work,
            ..
        } = self;
        start.evaluate(system, state.time, &state.positions, &mut work.phi)?;
        if const { S::STRUCTURE.holonomic_rows == R } {
            work.delassus.factor(&start.delassus);
        } else {
            factor_holonomic(start, work);
        }
        Ok(())
    }

    /// The end of the step becomes the start of the next one. `weak`: rows were redundant, or nearly so.
    #[inline(always)]
    pub(crate) fn commit(
        &mut self,
        time: f64,
        h: f64,
        q: SVector<f64, Q>,
        v: SVector<f64, N>,
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
        self.state
            .keep_impulse(h, &self.work.impulse[0], weak, &self.scale);
        core::mem::swap(&mut self.start, &mut self.end);
        self.counters.stages += 1;
        Ok(())
    }

    /// Of a step whose multipliers κ act on both ends alike, by ½(A₀ + A₁)ᵀκ, half of them belongs to each end.
    pub(super) fn share_impulse(&mut self) {
        let [first, second] = &mut self.work.impulse;
        let half = 0.5 * *first;
        *first = half;
        *second += half;
    }

    /// Refuses the end of a kick, flow, kick of h seconds in another assembly of the mechanism, to which the rows do not
    /// object: axes of a hinge are parallel in either direction. There the two kicks, which are halves of one force, are
    /// large and cancel.
    #[cold]
    #[inline(never)]
    pub(super) fn check_kicks(&mut self, h: f64) -> Result<(), Fault> {
        let mut apart = SVector::zeros();
        let [first, second] = &self.work.impulse;
        crate::linear::accumulate(&mut apart, &self.start.w, first);
        crate::linear::accumulate(&mut apart, &self.end.w, &negative(second));
        let checked = self.check_way(0.5 * h, &apart);
        if checked.is_err() {
            // The factor is that of the velocity rows at the end.
            self.refresh()?;
        }
        checked
    }

    /// The same for a velocity of which the way of a stage differs from the mean of its ends.
    #[cold]
    #[inline(never)]
    pub(super) fn check_way(&self, h: f64, apart: &SVector<f64, N>) -> Result<(), Fault> {
        let by = (self.yardstick.measure(apart) * h).abs();
        if by < ASTRAY {
            Ok(())
        } else {
            Err(Fault::Astray(by))
        }
    }

    /// The residual of the rows that is accepted if a new factor does not reduce it, `is_lost` where a row has lost its direction.
    #[cold]
    #[inline(never)]
    pub(super) fn round_off_of_rows(&self, is_lost: bool, q: &SVector<f64, Q>) -> f64 {
        let of_positions = self.yardstick.round_off_of_positions(q);
        self.scale.round_off_at(of_positions, is_lost)
    }

    /// Rows that vanish at the declared guess have their usual lengths once they have been longer: for runs without rank margins.
    #[cold]
    #[inline(never)]
    pub(super) fn settle_short_rows(&mut self) {
        let StepContext {
            scale, start, work, ..
        } = self;
        scale.settle(&start.delassus);
        work.delassus.usual = scale.usual;
    }

    /// The rank margin of the holonomic rows, of which S is factored, at the current instant.
    #[inline]
    pub(crate) fn rank_margin(&mut self) -> RankMargin {
        if self.scale.is_waiting() {
            return self.margin_of_short_rows();
        }
        let rows = S::STRUCTURE.holonomic_rows;
        let StepContext { start, work, .. } = self;
        work.delassus.rank_margin(&start.delassus, rows)
    }

    /// The same where rows that vanish at the declared guess have not been longer yet.
    #[cold]
    #[inline(never)]
    fn margin_of_short_rows(&mut self) -> RankMargin {
        self.settle_short_rows();
        let StepContext {
            scale, start, work, ..
        } = self;
        let rows = S::STRUCTURE.holonomic_rows;
        let margin = work.delassus.rank_margin(&start.delassus, rows);
        match scale.is_waiting() {
            // The factor measures the rows by their own lengths.
            true => RankMargin {
                least: margin.least * scale.shortness(&start.delassus),
                ..margin
            },
            false => margin,
        }
    }

    /// Chooses the redundant rows that are left out where a step begins, if there are any, and moves what they carry to the
    /// others: for steps that do not factor the rows at their end.
    #[inline]
    pub(crate) fn settle_redundant(&mut self) {
        if self.work.delassus.has_redundant() {
            self.work.delassus.factor(&self.start.delassus);
            self.relieve_redundant();
        }
    }

    /// Moves what redundant rows carry at the beginning of a step to the rows that they follow from: the same force
    /// Aᵀκ. A step beside a singular pose leaves multipliers on them; as no row answers to a combination without force,
    /// the extrapolation of multipliers would let it grow, a thousand times the forces in some hundred short steps.
    #[inline]
    pub(crate) fn relieve_redundant(&mut self) {
        let StepContext {
            state, start, work, ..
        } = self;
        let Some(skipped) = work.delassus.skipped() else {
            return;
        };
        let carried = &state.multipliers;
        if (0..R).all(|i| !skipped[i] || carried[i] == 0.0) {
            return;
        }
        let mut relieved: SVector<f64, R> =
            vector(|i| (0..R).map(|j| start.delassus[i][j] * carried[j]).sum());
        work.delassus.solve(&mut relieved);
        for i in 0..R {
            state.multiplier_changes[i] += relieved[i] - state.multipliers[i];
        }
        state.multipliers = relieved;
    }

    /// Projects v onto A v + b = 0 at the end of the step and stores the multiplier κ₂.
    #[inline(always)]
    pub(crate) fn project_velocity(&mut self, v: &mut SVector<f64, N>) {
        let StepContext {
            system,
            end,
            work,
            counters,
            fixed_iterations,
            scale,
            yardstick,
            ..
        } = self;
        work.delassus.factor(&end.delassus);
        let mut multiplier = negative(&end.velocity_rows(system, v));
        work.delassus.solve(&mut multiplier);
        crate::linear::accumulate(v, &end.w, &multiplier);
        work.impulse[1] = multiplier;
        counters.regularised += u64::from(work.delassus.reduced);
        if work.delassus.weak {
            counters.regularised += u64::from(work.delassus.regularised);
            let passes = fixed_iterations.map_or(REFINEMENTS, |_| FIXED_REFINEMENTS);
            let enough = scale.round_off(yardstick.measure(v));
            refine_rates(system, end, work, v, (passes, &scale.weights, enough));
        }
    }
}

#[cold]
#[inline(never)]
fn refine_rates<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    end: &ConstraintGeometry<S, Q, N, R>,
    work: &mut Workspace<R>,
    v: &mut SVector<f64, N>,
    (passes, weights, enough): (usize, &SVector<f64, R>, f64),
) {
    let mut rows = Rates {
        system,
        end,
        work,
        v,
        weights,
        rates: SVector::zeros(),
    };
    refine(&mut rows, passes, enough);
}

/// A v + b at the end of a step.
struct Rates<'a, S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    system: &'a S,
    end: &'a ConstraintGeometry<S, Q, N, R>,
    work: &'a mut Workspace<R>,
    v: &'a mut SVector<f64, N>,
    weights: &'a SVector<f64, R>,
    rates: SVector<f64, R>,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Refining
    for Rates<'_, S, Q, N, R>
{
    fn residual(&mut self) -> f64 {
        self.rates = self.end.velocity_rows(self.system, self.v);
        residual_of(&self.rates, self.weights)
    }

    fn correct(&mut self) {
        let mut multiplier = negative(&self.rates);
        self.work.delassus.solve(&mut multiplier);
        crate::linear::accumulate(self.v, &self.end.w, &multiplier);
        self.work.impulse[1] += multiplier;
    }
}

/// Factors S of the holonomic rows, with unit rows in place of the others.
pub(super) fn factor_holonomic<
    S: System<Q, N, R>,
    const Q: usize,
    const N: usize,
    const R: usize,
>(
    end: &ConstraintGeometry<S, Q, N, R>,
    work: &mut Workspace<R>,
) {
    let holonomic = S::STRUCTURE.holonomic_rows;
    if holonomic > 0 {
        // On the stack: a step allocates nothing.
        let mut delassus = *end.delassus;
        let rows = &mut delassus.data.0;
        for i in holonomic..R {
            rows[i] = [0.0; R];
            for row in rows.iter_mut() {
                row[i] = 0.0;
            }
            rows[i][i] = 1.0;
        }
        work.delassus.factor(&delassus);
    }
}
