//! The slider-crank in the angles of its two rods: one row, the height of the slider. Straight-line code with common
//! subexpressions named, as computer algebra writes it.

use super::equations::{Equations, GRAVITY};

/// 1/M₁₁: a rod about its end, and the other one as a point mass at its tip.
const INVERSE_FIRST: f64 = 0.75;
const SECOND: f64 = 1.0 / 3.0;

/// The last factor.
#[derive(Default)]
pub struct SliderCrank {
    sine: [f64; 2],
    cosine: [f64; 2],
    /// sin(θ₁ − θ₂)/2.
    coriolis: f64,
    /// Column of θ₁ below the diagonal, then that of θ₂, then the inverse pivots.
    rod: f64,
    row: [f64; 2],
    inverse_rod: f64,
    inverse_row: f64,
}

impl SliderCrank {
    /// The part of a solution that a right-hand side of the row makes.
    #[inline(always)]
    fn by_row(&self, right: f64) -> [f64; 2] {
        let multiplier = right * self.inverse_row;
        let second = -self.row[1] * multiplier;
        [-self.rod * second - self.row[0] * multiplier, second]
    }
}

impl Equations<2> for SliderCrank {
    fn start() -> [[f64; 2]; 2] {
        let angle = std::f64::consts::FRAC_PI_4;
        // The slider moves at 4 m/s towards the bearing of the crank.
        let rate = 4.0 / (2.0 * angle.sin());
        [[angle, -angle], [rate, -rate]]
    }

    #[inline(always)]
    fn place(&mut self, q: &[f64; 2]) {
        let [(s1, c1), (s2, c2)] = q.map(f64::sin_cos);
        (self.sine, self.cosine) = ([s1, s2], [c1, c2]);
        self.coriolis = 0.5 * (s1 * c2 - c1 * s2);
        let coupling = 0.5 * (c1 * c2 + s1 * s2);
        self.rod = INVERSE_FIRST * coupling;
        let pivot = SECOND - coupling * self.rod;
        let across = c2 - c1 * self.rod;
        self.row[0] = INVERSE_FIRST * c1;
        // The pivot of the row is −(c₁²/M₁₁ + across²/pivot); so written the two divisions are independent.
        self.inverse_rod = 1.0 / pivot;
        self.inverse_row = -pivot / (c1 * self.row[0] * pivot + across * across);
        self.row[1] = across * self.inverse_rod;
    }

    #[inline(always)]
    fn accelerations(&self, v: &[f64; 2], into: &mut [f64; 2]) {
        let ([s1, s2], [c1, c2]) = (self.sine, self.cosine);
        let (w1, w2) = (v[0] * v[0], v[1] * v[1]);
        let first = -1.5 * GRAVITY * c1 - self.coriolis * w2;
        let second = -0.5 * GRAVITY * c2 + self.coriolis * w1 - self.rod * first;
        let right = s1 * w1 + s2 * w2 - self.row[0] * first - self.row[1] * second;
        let multiplier = right * self.inverse_row;
        let along = second * self.inverse_rod - self.row[1] * multiplier;
        let across = INVERSE_FIRST * first - self.rod * along - self.row[0] * multiplier;
        *into = [across, along];
    }

    #[inline(always)]
    fn missing_positions(&self) -> [f64; 2] {
        self.by_row(-(self.sine[0] + self.sine[1]))
    }

    #[inline(always)]
    fn missing_velocities(&self, v: &[f64; 2]) -> [f64; 2] {
        self.by_row(-(self.cosine[0] * v[0] + self.cosine[1] * v[1]))
    }

    fn energy(q: &[f64; 2], v: &[f64; 2]) -> f64 {
        let coupling = 0.5 * (q[0] - q[1]).cos();
        let kinetic = (0.5 / INVERSE_FIRST) * v[0] * v[0]
            + 0.5 * SECOND * v[1] * v[1]
            + coupling * v[0] * v[1];
        kinetic + GRAVITY * (1.5 * q[0].sin() + 0.5 * q[1].sin())
    }
}
