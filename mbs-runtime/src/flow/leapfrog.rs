//! Leapfrog (velocity Verlet): constant mass, forces of position and time.
//!
//! q₁ = q₀ + h v_a + h²/2 a₀,  v_b = v_a + h/2 (a₀ + a₁): one force evaluation a step, shared by its neighbours.

use super::KickFlow;
use crate::System;
use crate::alf3f::{Fault, Node};

pub(crate) struct Leapfrog<const N: usize> {
    h: f64,
    t1: f64,
    /// q₀ + h²/2 a₀.
    base: [f64; N],
    /// h/2 a₀.
    half_kick: [f64; N],
}

impl<const N: usize> Leapfrog<N> {
    pub(crate) fn new() -> Self {
        Leapfrog {
            h: 0.0,
            t1: 0.0,
            base: [0.0; N],
            half_kick: [0.0; N],
        }
    }
}

impl<S: System<N, R>, const N: usize, const R: usize> KickFlow<S, N, R> for Leapfrog<N> {
    const DIRECT: bool = true;

    #[inline(always)]
    fn begin(&mut self, _: &S, t: f64, q: &[f64; N], _: &[f64; N], start: &Node<S, N, R>, h: f64) {
        self.h = h;
        self.t1 = t + h;
        for i in 0..N {
            self.half_kick[i] = 0.5 * h * start.acceleration[i];
            self.base[i] = q[i] + h * self.half_kick[i];
        }
    }

    #[inline(always)]
    fn positions(&mut self, _: &S, va: &[f64; N], q: &mut [f64; N]) -> Result<(), Fault> {
        for i in 0..N {
            q[i] = self.base[i] + self.h * va[i];
        }
        Ok(())
    }

    #[inline(always)]
    fn directions<'a>(
        &'a mut self,
        _: &S,
        _: &[f64; N],
        w0: &'a [[f64; N]; R],
    ) -> Result<&'a [[f64; N]; R], Fault> {
        Ok(w0)
    }

    /// Leaves out h²/2 of the force gradient, which only slows the iteration a little.
    #[inline(always)]
    fn far<'a>(&'a self, w0: &'a [[f64; N]; R]) -> &'a [[f64; N]; R] {
        w0
    }

    #[inline(always)]
    fn predict(&mut self, _: &[f64; R]) {}

    #[inline(always)]
    fn velocities(
        &mut self,
        system: &S,
        va: &[f64; N],
        q1: &[f64; N],
        end: &mut Node<S, N, R>,
    ) -> [f64; N] {
        system.acceleration(self.t1, q1, &mut end.acceleration);
        std::array::from_fn(|i| va[i] + (self.half_kick[i] + 0.5 * self.h * end.acceleration[i]))
    }
}
