//! The rival's steps: explicit Runge–Kutta with a projection.

use super::equations::Equations;
use super::tableau;

/// Passes of a projection at the most.
const PASSES: usize = 4;

/// How the rival returns to the rows.
#[derive(Clone, Copy)]
pub struct Projection {
    /// After every so many steps.
    pub every: u32,
    /// A projection that moves an angle by more, rad, is followed by another one.
    pub limit: f64,
}

/// A run of the rival. The first stage of a step is evaluated at the end of the step before.
pub struct Rival<E, const N: usize> {
    equations: E,
    pub q: [f64; N],
    pub v: [f64; N],
    /// Rates and accelerations of the stages.
    rates: [[f64; N]; 12],
    slopes: [[f64; N]; 12],
    projection: Projection,
    /// Steps until the next projection.
    left: u32,
}

impl<E: Equations<N>, const N: usize> Rival<E, N> {
    pub fn new(projection: Projection) -> Self {
        let [q, v] = E::start();
        let mut rival = Rival {
            equations: E::default(),
            q,
            v,
            rates: [[0.0; N]; 12],
            slopes: [[0.0; N]; 12],
            projection,
            left: projection.every,
        };
        rival.equations.place(&q);
        rival.begin();
        rival
    }

    /// One step of Dormand and Prince's method of order 8.
    pub fn step8(&mut self, h: f64) {
        self.stage(1, h, &tableau::A2);
        self.stage(2, h, &tableau::A3);
        self.stage(3, h, &tableau::A4);
        self.stage(4, h, &tableau::A5);
        self.stage(5, h, &tableau::A6);
        self.stage(6, h, &tableau::A7);
        self.stage(7, h, &tableau::A8);
        self.stage(8, h, &tableau::A9);
        self.stage(9, h, &tableau::A10);
        self.stage(10, h, &tableau::A11);
        self.stage(11, h, &tableau::A12);
        self.end(h, &tableau::END);
    }

    /// One step of the classical method of order 4.
    pub fn step4(&mut self, h: f64) {
        const THIRD: f64 = 1.0 / 3.0;
        const SIXTH: f64 = 1.0 / 6.0;
        self.stage(1, h, &[(0, 0.5)]);
        self.stage(2, h, &[(1, 0.5)]);
        self.stage(3, h, &[(2, 1.0)]);
        self.end(h, &[(0, SIXTH), (1, THIRD), (2, THIRD), (3, SIXTH)]);
    }

    #[inline(always)]
    fn stage<const K: usize>(&mut self, stage: usize, h: f64, terms: &[(usize, f64); K]) {
        let [q, v] = self.combination(h, terms);
        self.equations.evaluate(&q, &v, &mut self.slopes[stage]);
        self.rates[stage] = v;
    }

    #[inline(always)]
    fn combination<const K: usize>(&self, h: f64, terms: &[(usize, f64); K]) -> [[f64; N]; 2] {
        let mut weights = [0.0; K];
        for k in 0..K {
            weights[k] = h * terms[k].1;
        }
        let (mut q, mut v) = (self.q, self.v);
        for i in 0..N {
            for k in 0..K {
                q[i] += weights[k] * self.rates[terms[k].0][i];
                v[i] += weights[k] * self.slopes[terms[k].0][i];
            }
        }
        [q, v]
    }

    /// The end of a step, and the first stage of the next one with the same factor: what a projection moves is as small as
    /// the error of a step, and the stage contributes it once more times h.
    #[inline(always)]
    fn end<const K: usize>(&mut self, h: f64, terms: &[(usize, f64); K]) {
        [self.q, self.v] = self.combination(h, terms);
        self.equations.place(&self.q);
        self.left -= 1;
        if self.left == 0 {
            self.left = self.projection.every;
            self.project();
        }
        self.begin();
    }

    /// The first stage, where the equations are placed.
    #[inline(always)]
    fn begin(&mut self) {
        self.rates[0] = self.v;
        self.equations.accelerations(&self.v, &mut self.slopes[0]);
    }

    #[inline(always)]
    fn project(&mut self) {
        for _ in 1..PASSES {
            if self.move_positions() <= self.projection.limit {
                break;
            }
            self.equations.place(&self.q);
        }
        let missing = self.equations.missing_velocities(&self.v);
        for (v, missing) in self.v.iter_mut().zip(missing) {
            *v += missing;
        }
    }

    /// Moves the angles; the largest change.
    #[inline(always)]
    fn move_positions(&mut self) -> f64 {
        let missing = self.equations.missing_positions();
        let mut largest: f64 = 0.0;
        for (q, missing) in self.q.iter_mut().zip(missing) {
            *q += missing;
            largest = largest.max(missing.abs());
        }
        largest
    }
}
