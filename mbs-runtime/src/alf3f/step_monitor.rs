//! Works of a step, and its clearance from singular poses, computed stage by stage.

use super::step_context::StepContext;
use crate::System;
use crate::singular::RankMargin;

/// Works and clearance of a step, stage by stage.
#[derive(Debug, Clone, Copy)]
pub(crate) struct StepMonitor {
    /// Power of forces without potential at the current stage, W.
    pub(crate) power: f64,
    /// Work of these forces so far, J.
    pub(crate) nonconservative_work: f64,
    /// How far the trapezoidal rule may be from the work of these forces, J: the sum of the differences of the two ends
    /// of each stage.
    pub(crate) work_doubt: f64,
    /// Work of the rheonomic rows so far, J.
    pub(crate) drive_work: f64,
    /// The distance of the ends of stages from a singular pose, as a fraction of the step: σ₁/(σ₀ + σ₁) for a step of
    /// one stage, which is ½ far from any pose; the clearance of its [`StagePlacement`](super::StagePlacement) for a
    /// composed one.
    pub(crate) clearance: f64,
    /// The rank margin at the current stage; `None` if the clearance is not needed.
    pub(crate) rank_margin: Option<RankMargin>,
}

impl StepMonitor {
    /// From an instant with this power and independence of the rows.
    pub(crate) fn new(power: f64, rank_margin: Option<RankMargin>) -> Self {
        StepMonitor {
            power,
            nonconservative_work: 0.0,
            work_doubt: 0.0,
            drive_work: 0.0,
            clearance: f64::INFINITY,
            rank_margin,
        }
    }

    /// Adds a stage of h seconds, after it was taken. The works are those of the trapezoidal rule, symmetric like the
    /// stage: the composition raises their order too.
    #[inline]
    pub(crate) fn add<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
        &mut self,
        context: &StepContext<S, Q, N, R>,
        h: f64,
    ) {
        let state = &context.state;
        let power =
            context
                .system
                .nonconservative_power(state.time, &state.positions, &state.velocities);
        self.nonconservative_work += 0.5 * h * (self.power + power);
        self.work_doubt += (0.5 * h * (power - self.power)).abs();
        self.power = power;
        if const { S::STRUCTURE.rheonomic } {
            // After the commit `end` has the geometry of the beginning of the stage.
            let impulse = &context.work.impulse;
            self.drive_work += (0..R)
                .map(|i| -impulse[0][i] * context.end.b[i] - impulse[1][i] * context.start.b[i])
                .sum::<f64>();
        }
    }

    /// Records the end of a step of one stage. The step before has recorded its beginning.
    #[inline]
    pub(crate) fn land(&mut self, now: RankMargin) {
        if let Some(before) = self.rank_margin.replace(now) {
            self.clearance = self.clearance.min(now.after(&before));
        }
    }
}
