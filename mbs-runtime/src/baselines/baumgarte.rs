//! Explicit Runge–Kutta on the index-1 form, with Baumgarte's terms or with projections.
//!
//! ```text
//! M v̇ + Γvv = f + Aᵀλ,    A v̇ + γ + 2α (A v + b) + β² φ = 0        (Baumgarte, CMAME 1, 1972, 1–16)
//! ```
//!
//! The terms reduce a violation within about 1/α seconds. The projected variant has no such terms; it moves the end of
//! each step to the nearest positions and velocities, in the metric of M, that satisfy the rows (Eich, SIAM J. Numer.
//! Anal. 30, 1993, 1467–1482), and evaluates the equations there for the step that follows. Where rows are redundant or
//! a pose is singular, corrections are those of the proximal solve that the two-level step has, and so are multipliers, but for
//! generated accelerations, which leave out a row that has lost its direction in an exactly singular pose.

use super::bench::Bench;
use super::index1::Index1;
use super::rule::{AnyRule, Rule};
use super::runge_kutta::{RungeKutta, classical};
use super::tableau::{CLASSICAL, Tableau};
use crate::estimate::Estimate;
use crate::fault::Fault;
use crate::row_scale::RowScale;
use crate::singular::RankMargin;
use crate::{BaumgarteSettings, Method, Settings, System};
use nalgebra::SVector;

/// The treatment of violations of the rows.
#[derive(Clone)]
enum Remedy<const R: usize> {
    Terms,
    Projection(Box<RowScale<R>>),
}

#[derive(Clone)]
pub(crate) struct Explicit<const Q: usize, const N: usize, const R: usize> {
    equations: Index1<N, R>,
    stages: RungeKutta<Q, N>,
    remedy: Remedy<R>,
    /// Whether the rows are factored at the current state.
    placed: bool,
    /// The length of the last step, s.
    length: f64,
}

impl<const Q: usize, const N: usize, const R: usize> Explicit<Q, N, R> {
    /// For Baumgarte's method with constant steps.
    pub(crate) fn stabilised<S: System<Q, N, R>>(
        bench: &Bench<S, Q, N, R>,
        settings: &Settings,
    ) -> Option<Result<AnyRule<S, Q, N, R>, Fault>> {
        let Method::Baumgarte(BaumgarteSettings {
            gain,
            adaptive: None,
        }) = settings.method
        else {
            return None;
        };
        Some(Ok(Box::new(Explicit {
            equations: Index1::planned(bench, gain),
            stages: RungeKutta::new(tableau(settings.order)),
            remedy: Remedy::Terms,
            placed: false,
            length: 0.0,
        })))
    }

    /// For the projected method.
    pub(crate) fn projected<S: System<Q, N, R>>(
        bench: &Bench<S, Q, N, R>,
        settings: &Settings,
    ) -> Option<Result<AnyRule<S, Q, N, R>, Fault>> {
        if settings.method != Method::Projected {
            return None;
        }
        let make = || -> Result<AnyRule<S, Q, N, R>, Fault> {
            let scale = Box::new(RowScale::new(&bench.system, &bench.yardstick, settings)?);
            Ok(Box::new(Explicit {
                equations: Index1::detecting(bench, scale.final_lengths())?,
                stages: RungeKutta::new(tableau(settings.order)),
                remedy: Remedy::Projection(scale),
                placed: false,
                length: 0.0,
            }))
        };
        Some(make())
    }

    /// Whether it detects singular poses, for which the rows are factored at the current state.
    fn watches(&self) -> bool {
        matches!(self.remedy, Remedy::Projection(_))
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Rule<S, Q, N, R>
    for Explicit<Q, N, R>
{
    /// The rank margin of the rows at the current state; `None` without rows, or if it is not needed.
    fn rank_margin(&mut self, bench: &mut Bench<S, Q, N, R>) -> Option<RankMargin> {
        if !self.watches() {
            return None;
        }
        self.equations.margin_here(bench, &mut self.placed)
    }

    /// How much each row takes part in what is nearest to a loss of independence; after [`Self::rank_margin`].
    fn weakest_rows(&mut self, bench: &Bench<S, Q, N, R>) -> SVector<f64, R> {
        self.equations.weakest_rows(bench)
    }

    fn estimate(&self, bench: &Bench<S, Q, N, R>) -> Option<Estimate> {
        let (h, yardstick) = (self.length.abs(), &bench.yardstick);
        let size = |turn: &SVector<f64, N>, change: &SVector<f64, N>| {
            (yardstick.measure(turn)).max(h * yardstick.measure(change))
        };
        self.stages.estimate(h, size)
    }

    fn is_sparse(&self) -> bool {
        self.equations.planned.is_some()
    }

    /// See [`Index1::clearance`].
    fn clearance(&self) -> f64 {
        self.equations.clearance()
    }

    fn expected_clearance(&self, length: f64) -> f64 {
        self.stages.poses.expected_clearance(length)
    }

    fn pose_within(&self) -> Option<f64> {
        self.stages.poses.within()
    }

    /// After the state or an input was changed.
    fn refresh(&mut self) {
        self.placed = false;
    }

    fn advance(&mut self, bench: &mut Bench<S, Q, N, R>, h: f64) -> Result<(), Fault> {
        self.equations.begin();
        self.placed = false;
        let end = if self.stages.tableau.order == CLASSICAL.order {
            classical(bench, &mut self.equations, h)?
        } else {
            self.stages.step(bench, &mut self.equations, h)?
        };
        let t1 = bench.state.end_of(h);
        let (mut q, mut v) = (end.q, end.v);
        self.length = h;
        if let Remedy::Projection(scale) = &self.remedy
            && R > 0
        {
            self.equations.close(bench, t1, &mut q, scale)?;
            self.equations.project(bench, &mut v);
        }
        // The projection has evaluated the rows where the step ends.
        let settled = self.watches();
        bench.commit(t1, q, v, settled)?;
        self.placed = settled;
        bench.counters.stages += self.stages.tableau.nodes.len() as u64;
        Ok(())
    }
}

/// Order 2, which stands for the method's own, means the classical method.
fn tableau(order: u8) -> &'static Tableau {
    Tableau::of_order(order).unwrap_or(&CLASSICAL)
}
