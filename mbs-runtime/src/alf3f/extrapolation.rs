//! High orders for forces that depend on velocities: extrapolation of a symmetric step, whose parts all run forwards.
//!
//! A step of H is taken n times, each time anew from its beginning, in 2k = 2, 4, … 2n equal parts. A symmetric part of
//! second order has an error expansion in even powers of H/2k, of which the weighted mean
//!
//! ```text
//! q = q₁ ⊕ Σ c_k (q_k ⊖ q₁),    v = Σ c_k v_k,    c_k = Π_{j ≠ k} k²/(k² − j²)
//! ```
//!
//! leaves 2n (E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, section II.9, with the
//! harmonic sequence). The differences are taken from the first end, so that the chart is the same for all k, and bodies may turn by half
//! a turn in the step. The mean satisfies the
//! rows to the order of the step; it is put on them by a kick that moves nothing else.
//!
//! Even numbers of parts, because the implicit trapezoid turns the sign of what a stiff damper brakes: over an even number
//! the signs cancel, and the step is stable.
//!
//! | order | parts | factor of a damped velocity | ωH from which a vibration grows by 0.1 % a step |
//! |---|---|---|---|
//! | 4 | 6 | −0.11 … 1 | 1.7 |
//! | 6 | 12 | −0.16 … 1 | 2.8 |
//! | 8 | 20 | −0.20 … 1 | 4.2 |

use super::StepMonitor;
use super::kick_flow_kick::kick_flow_kick;
use super::step_context::StepContext;
use crate::constraint_geometry::ConstraintGeometry;
use crate::fault::Fault;
use crate::flow::{KickFlow, Trapezoid};
use crate::linear::RowMatrix;
use crate::{State, System};
use nalgebra::SVector;

/// Weights c_k, by half the order less two.
const WEIGHTS: [&[f64]; 3] = [
    &[-1.0 / 3.0, 4.0 / 3.0],
    &[1.0 / 24.0, -16.0 / 15.0, 81.0 / 40.0],
    &[-1.0 / 360.0, 16.0 / 45.0, -729.0 / 280.0, 1024.0 / 315.0],
];

/// Columns whose ends are further apart than this part of the way, or whose velocities there than this part of the speed, do
/// not follow the same motion, or are far too coarse for it.
const UNLIKE: f64 = 0.5;

/// The weighted mean of the ends of a step taken in different numbers of parts.
#[derive(Clone)]
pub(super) struct Extrapolation {
    weights: &'static [f64],
}

/// A step that was taken.
pub(super) struct Taken<const R: usize> {
    /// κ₁ + κ₂ over it.
    pub(super) impulse: SVector<f64, R>,
    /// Whether its columns have gone the same way.
    pub(super) alike: bool,
    /// The least σ where a part ends on the way.
    pub(super) nearest: f64,
    /// H times the distance of its velocities from those of the mean without the last column, in sizes of the mechanism and
    /// radians.
    pub(super) apart: f64,
}

/// Sums over the columns, with their weights.
struct Mean<const Q: usize, const N: usize, const R: usize> {
    /// The end of the first column, …
    place: SVector<f64, Q>,
    /// … and the mean of the ends, from there: from the start of a step that turns a body by about half a turn, the ends would lie on
    /// both sides of it.
    moved: SVector<f64, N>,
    velocities: SVector<f64, N>,
    impulse: SVector<f64, R>,
    work: f64,
    drive_work: f64,
}

impl Extrapolation {
    /// Of order 4, 6 or 8.
    pub(super) fn new(order: u8) -> Self {
        let weights = WEIGHTS[usize::from(order / 2).clamp(2, 4) - 2];
        Extrapolation { weights }
    }

    /// The parts of a step: 2 + 4 + … + 2n.
    pub(super) fn parts(&self) -> usize {
        self.weights.len() * (self.weights.len() + 1)
    }

    /// One step of h seconds from the state `before`, which is that of the context. After a fault the state of the context
    /// is one on the way.
    pub(super) fn step<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
        &self,
        context: &mut StepContext<S, Q, N, R>,
        flow: &mut Trapezoid<Q, N, R>,
        before: &State<Q, N, R>,
        h: f64,
        monitor: &mut StepMonitor,
    ) -> Result<Taken<R>, Fault> {
        let mut mean = Mean {
            place: before.positions,
            moved: crate::linear::zeros(),
            velocities: crate::linear::zeros(),
            impulse: crate::linear::zeros(),
            work: 0.0,
            drive_work: 0.0,
        };
        let start = *monitor;
        let mut finest = start;
        let mut stage = 0;
        // Without the last column.
        let coarser = match self.weights.len() {
            2 => &[1.0],
            columns => WEIGHTS[columns - 3],
        };
        let mut apart: SVector<f64, N> = crate::linear::zeros();
        let (mut alike, mut last, mut nearest) = (true, None, f64::INFINITY);
        let speed = context.yardstick.measure(&before.velocities);
        for (column, &weight) in self.weights.iter().enumerate() {
            if column > 0 {
                begin_again(context, before)?;
            }
            let parts = 2 * (column + 1);
            let mut works = start;
            for part in 1..=parts {
                context.state.recall_stage(stage);
                context.end_time = context.state.time + h / parts as f64;
                kick_flow_kick(context, flow, h / parts as f64)?;
                context.state.keep_stage(stage);
                stage += 1;
                works.add(context, h / parts as f64);
                let [first, second] = &context.work.impulse;
                mean.impulse += (first + second) * weight;
                if let Some(start) = &start.rank_margin
                    && part < parts
                {
                    nearest = nearest.min(context.rank_margin().beside(start));
                }
            }
            let State {
                positions: place,
                velocities: now,
                ..
            } = context.state;
            if column == 0 {
                mean.place = place;
            }
            let system = &context.system;
            let moved = system.difference(&mean.place, &place);
            let measure = |way: &SVector<f64, N>| context.yardstick.measure(way);
            let way = measure(&system.difference(&before.positions, &place));
            if let Some((last_moved, last_way, last_now)) = last.replace((moved, way, now)) {
                alike &= measure(&(moved - last_moved)) <= UNLIKE * way.max(last_way);
                // A part that turns into another branch late in the step has moved little there.
                let speed = measure(&now).max(measure(&last_now)).max(speed);
                alike &= measure(&(now - last_now)) <= UNLIKE * speed;
            }
            mean.moved += moved * weight;
            mean.velocities += context.state.velocities * weight;
            let less = coarser.get(column).unwrap_or(&0.0);
            apart += context.state.velocities * (weight - less);
            mean.work += weight * (works.nonconservative_work - start.nonconservative_work);
            mean.drive_work += weight * (works.drive_work - start.drive_work);
            finest = works;
        }
        land(context, before, &mean, h)?;
        let State {
            time,
            positions,
            velocities,
            ..
        } = &context.state;
        let system = &context.system;
        monitor.power = system.nonconservative_power(*time, positions, velocities);
        monitor.nonconservative_work += mean.work;
        monitor.drive_work += mean.drive_work;
        monitor.work_doubt +=
            (finest.nonconservative_work - start.nonconservative_work - mean.work).abs();
        Ok(Taken {
            impulse: mean.impulse,
            alike,
            nearest,
            apart: h.abs() * context.yardstick.measure(&apart),
        })
    }
}

/// Back to the beginning of the step, but with the multipliers that its parts have kept.
fn begin_again<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    context: &mut StepContext<S, Q, N, R>,
    before: &State<Q, N, R>,
) -> Result<(), Fault> {
    let state = &mut context.state;
    state.time = before.time;
    state.positions = before.positions;
    state.velocities = before.velocities;
    context.refresh()
}

/// Puts the mean on the rows, as the end of a step.
fn land<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    context: &mut StepContext<S, Q, N, R>,
    before: &State<Q, N, R>,
    mean: &Mean<Q, N, R>,
    h: f64,
) -> Result<(), Fault> {
    let (system, state) = (&context.system, &mut context.state);
    let place = system.advance(&mean.place, &mean.moved, 1.0);
    state.time = before.time;
    state.positions = place;
    state.velocities = SVector::zeros();
    state.multipliers = SVector::zeros();
    state.multiplier_changes = SVector::zeros();
    context.refresh()?;
    let mut rest = Rest {
        h,
        place,
        velocities: mean.velocities,
    };
    context.end_time = before.end_of(h);
    kick_flow_kick(context, &mut rest, h)?;
    // Stages are counted by parts.
    context.counters.stages -= 1;
    Ok(())
}

/// The flow of a mechanism at rest, which only the kick at the beginning moves: q₁ = q ⊕ h v_a, and a given velocity at
/// the end.
struct Rest<const Q: usize, const N: usize> {
    h: f64,
    place: SVector<f64, Q>,
    velocities: SVector<f64, N>,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> KickFlow<S, Q, N, R>
    for Rest<Q, N>
{
    fn begin(
        &mut self,
        _: &S,
        _: [f64; 2],
        _: &SVector<f64, Q>,
        _: [&SVector<f64, N>; 2],
        _: &ConstraintGeometry<S, Q, N, R>,
        _: f64,
    ) {
    }

    fn is_direct(&self) -> bool {
        true
    }

    fn positions(
        &mut self,
        system: &S,
        va: &SVector<f64, N>,
        q: &mut SVector<f64, Q>,
    ) -> Result<(), Fault> {
        *q = system.advance(&self.place, va, self.h);
        Ok(())
    }

    fn position_sensitivity<'a>(
        &'a mut self,
        _: &S,
        _: &SVector<f64, N>,
        start: &'a ConstraintGeometry<S, Q, N, R>,
    ) -> Result<&'a RowMatrix<N, R>, Fault> {
        Ok(&start.w)
    }

    /// The velocities at the end are given.
    fn velocity_sensitivity<'a>(&'a self, _: &'a RowMatrix<N, R>) -> Option<&'a RowMatrix<N, R>> {
        None
    }

    fn predict(&mut self, _: &SVector<f64, R>) {}

    fn velocities(
        &mut self,
        _: &S,
        _: &SVector<f64, N>,
        _: &SVector<f64, Q>,
        _: &mut ConstraintGeometry<S, Q, N, R>,
    ) -> SVector<f64, N> {
        self.velocities
    }
}
