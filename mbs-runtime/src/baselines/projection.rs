//! The projection of the end of a step: to the nearest positions and velocities, in the metric of M, that satisfy the rows
//! (Eich, SIAM J. Numer. Anal. 30, 1993, 1467–1482).

use super::bench::Bench;
use super::index1::Index1;
use crate::System;
use crate::alf3f::closing::{self, Closing, Limits};
use crate::alf3f::{not_converged, residual_of};
use crate::fault::Fault;
use crate::linear::{accumulate, negative};
use crate::row_scale::RowScale;
use crate::singular::EXACT;
use nalgebra::SVector;

impl<const N: usize, const R: usize> Index1<N, R> {
    /// Moves q onto the position rows, with the factors of where it was first.
    #[inline(always)]
    pub(super) fn close<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &mut Bench<S, Q, N, R>,
        t: f64,
        q: &mut SVector<f64, Q>,
        scale: &RowScale<R>,
    ) -> Result<(), Fault> {
        if let Some(planned) = &mut self.planned
            && let Some(closed) = planned.close(bench, t, q, scale)?
        {
            bench.counters.iterations += closed.iterations as u64;
            return Ok(());
        }
        self.place(bench, t, q)?;
        let limits = Limits {
            most: bench.max_iterations,
            fixed: None,
        };
        let mut rows = Near {
            equations: self,
            bench: &mut *bench,
            scale,
            t,
            q,
            is_evaluated: true,
        };
        let closed = closing::close(&mut rows, limits, true)?;
        bench.counters.iterations += closed.map_or(0, |closed| closed.iterations as u64);
        Ok(())
    }

    /// Moves v onto the velocity rows where q was closed. The factors are those of a nearby pose; the second pass
    /// restores the digits that this and a nearly singular solve lose.
    #[inline(always)]
    pub(super) fn project<S: System<Q, N, R>, const Q: usize>(
        &mut self,
        bench: &Bench<S, Q, N, R>,
        v: &mut SVector<f64, N>,
    ) {
        if let Some(planned) = &mut self.planned
            && planned.is_sound()
        {
            return planned.project(&bench.geometry.b, v);
        }
        for _ in 0..2 {
            let mut multiplier = negative(&bench.geometry.velocity_rows(&bench.system, v));
            self.delassus.solve(&mut multiplier);
            accumulate(v, &bench.geometry.w, &multiplier);
        }
    }
}

/// The position rows about the end of a step.
struct Near<'a, S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> {
    equations: &'a mut Index1<N, R>,
    bench: &'a mut Bench<S, Q, N, R>,
    scale: &'a RowScale<R>,
    t: f64,
    q: &'a mut SVector<f64, Q>,
    is_evaluated: bool,
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> Closing
    for Near<'_, S, Q, N, R>
{
    /// The factors of where q was first are nearly those of where it is closed.
    const PATIENCE: i32 = 3;

    #[inline(always)]
    fn residual(&mut self) -> Result<f64, Fault> {
        let Bench {
            system,
            geometry,
            phi,
            ..
        } = &mut *self.bench;
        if !std::mem::take(&mut self.is_evaluated) {
            system.constraints(
                self.t,
                self.q,
                phi,
                geometry.a.entries_mut(),
                &mut geometry.b,
            );
        }
        Ok(residual_of(phi, &self.scale.weights))
    }

    #[inline(always)]
    fn factor(&mut self) -> Result<bool, Fault> {
        self.equations.place(self.bench, self.t, self.q)?;
        Ok(true)
    }

    #[inline(always)]
    fn solve(&mut self) -> bool {
        let mut change = negative(&self.bench.phi);
        self.equations.delassus.solve(&mut change);
        let mut way = SVector::zeros();
        accumulate(&mut way, &self.bench.geometry.w, &change);
        *self.q = self.bench.system.advance(self.q, &way, 1.0);
        false
    }

    #[inline(always)]
    fn enough(&self) -> f64 {
        if self.equations.delassus.weak {
            EXACT
        } else {
            1.0
        }
    }

    #[inline(always)]
    fn round_off(&self) -> f64 {
        self.scale.lost
    }

    #[inline(always)]
    fn fault(&self, iterations: usize) -> Fault {
        not_converged(&self.bench.phi, &self.scale.weights, iterations)
    }
}
