//! Leapfrog (velocity Verlet): constant mass, forces of position and time.
//!
//! q₁ = q₀ + h v_a + h²/2 a₀,  v_b = v_a + h/2 (a₀ + a₁): one force evaluation a step, shared by its neighbours. With
//! rotations the drift is the free flight of the bodies: v = v_a + h/2 a₀, (q₁, v) ← flight, v_b = v + h/2 a₁.

use super::KickFlow;
use super::drift::Drift;
use crate::System;
use crate::constraint_geometry::ConstraintGeometry;
use crate::fault::Fault;
use crate::linear::{RowMatrix, added, entries, entries_mut, scaled, vector};
use crate::memory::Box;
use nalgebra::SVector;

#[derive(Clone)]
pub(crate) struct Leapfrog<const Q: usize, const N: usize, const R: usize> {
    h: f64,
    t1: f64,
    /// q₀ + h²/2 a₀, where there are no rotations.
    base: SVector<f64, Q>,
    /// h/2 a₀.
    half_kick: SVector<f64, N>,
    /// `None` without rotations.
    drift: Option<Box<Drift<Q, N, R>>>,
}

impl<const Q: usize, const N: usize, const R: usize> Leapfrog<Q, N, R> {
    pub(crate) fn new<S: System<Q, N, R>>() -> Self {
        Leapfrog {
            h: 0.0,
            t1: 0.0,
            base: crate::linear::zeros(),
            half_kick: crate::linear::zeros(),
            drift: (!S::ROTATIONS.is_empty()).then(Drift::new),
        }
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> KickFlow<S, Q, N, R>
    for Leapfrog<Q, N, R>
{
    #[inline(always)]
    fn begin(
        &mut self,
        system: &S,
        [_, t1]: [f64; 2],
        q: &SVector<f64, Q>,
        [_, va]: [&SVector<f64, N>; 2],
        start: &ConstraintGeometry<S, Q, N, R>,
        h: f64,
    ) {
        self.h = h;
        self.t1 = t1;
        self.half_kick = scaled(0.5 * h, &start.acceleration);
        if Q == N {
            let (q, half_kick) = (entries(q), entries(&self.half_kick));
            self.base = vector(|i| q[i] + h * half_kick[i]);
        } else if S::ROTATIONS.is_empty() {
            self.base = system.advance(q, &self.half_kick, h);
        } else if let Some(drift) = &mut self.drift {
            drift.begin::<S>(q, va, h);
        }
    }

    #[inline(always)]
    fn is_direct(&self) -> bool {
        S::ROTATIONS.is_empty() || self.drift.as_ref().is_some_and(|drift| !drift.swift)
    }

    #[inline(always)]
    fn positions(
        &mut self,
        system: &S,
        va: &SVector<f64, N>,
        q: &mut SVector<f64, Q>,
    ) -> Result<(), Fault> {
        if Q == N {
            let (q, base, va) = (entries_mut(q), entries(&self.base), entries(va));
            for i in 0..N {
                q[i] = base[i] + self.h * va[i];
            }
        } else if S::ROTATIONS.is_empty() {
            // Counted angles are stored beside the coordinates.
            *q = system.advance(&self.base, va, self.h);
        } else if let Some(drift) = &mut self.drift {
            *q = drift.fly(system, added(va, 1.0, &self.half_kick));
        }
        Ok(())
    }

    #[inline(always)]
    fn position_sensitivity<'a>(
        &'a mut self,
        system: &S,
        _: &SVector<f64, N>,
        start: &'a ConstraintGeometry<S, Q, N, R>,
    ) -> Result<&'a RowMatrix<N, R>, Fault> {
        match &mut self.drift {
            Some(drift) if !S::ROTATIONS.is_empty() => {
                Ok(drift.position_sensitivity(system, &start.w))
            }
            _ => Ok(&start.w),
        }
    }

    /// Leaves out h²/2 of the force gradient, which only slows the iteration a little.
    #[inline(always)]
    fn velocity_sensitivity<'a>(&'a self, w0: &'a RowMatrix<N, R>) -> Option<&'a RowMatrix<N, R>> {
        Some(match &self.drift {
            Some(drift) if !S::ROTATIONS.is_empty() => &drift.far,
            _ => w0,
        })
    }

    #[inline(always)]
    fn predict(&mut self, _: &SVector<f64, R>) {}

    #[inline(always)]
    fn velocities(
        &mut self,
        system: &S,
        va: &SVector<f64, N>,
        q1: &SVector<f64, Q>,
        end: &mut ConstraintGeometry<S, Q, N, R>,
    ) -> SVector<f64, N> {
        system.acceleration(self.t1, q1, &mut end.acceleration);
        match &self.drift {
            Some(drift) if !S::ROTATIONS.is_empty() => {
                added(drift.velocities(), 0.5 * self.h, &end.acceleration)
            }
            _ => added(
                va,
                1.0,
                &added(&self.half_kick, 0.5 * self.h, &end.acceleration),
            ),
        }
    }
}
