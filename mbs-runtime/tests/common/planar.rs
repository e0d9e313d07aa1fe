//! Planar mechanisms of bars in natural coordinates: slider-crank and N-four-bar.

use super::{Scene, row, structure};
use mbs_runtime::{Row, RowKind::Holonomic, Structure};

pub const G: f64 = 9.81;

/// Two equal rods of 1 m and 1 kg, massless slider on y = 0: (x2, y2, x3, y3).
#[derive(Clone, Default)]
pub struct SliderCrank;

impl Scene<4, 4, 3> for SliderCrank {
    const STRUCTURE: Structure = Structure {
        position_forces: false,
        ..structure(true, false, 3)
    };
    const ROWS: &'static [Row] = &[
        row("crank.length", Holonomic),
        row("rod.length", Holonomic),
        row("liner", Holonomic),
    ];
    const EVENTS: &'static [&'static str] = &["crank_upright"];
    fn guess(&self) -> ([f64; 4], [f64; 4]) {
        let c = std::f64::consts::FRAC_PI_4.cos();
        let w = 4.0 / (2.0 * c);
        ([c, c, 2.0 * c, 0.0], [-c * w, c * w, -4.0, 0.0])
    }
    fn mass(&self, _: &[f64; 4]) -> [[f64; 4]; 4] {
        let (a, b, c) = (2.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0);
        [
            [a, 0.0, c, 0.0],
            [0.0, a, 0.0, c],
            [c, 0.0, b, 0.0],
            [0.0, c, 0.0, b],
        ]
    }
    fn force(&self, _: f64, _: &[f64; 4], _: &[f64; 4]) -> [f64; 4] {
        [0.0, -G, 0.0, -G / 2.0]
    }
    fn rows(&self, _: f64, q: &[f64; 4]) -> ([f64; 3], [[f64; 4]; 3], [f64; 3]) {
        let [x2, y2, x3, y3] = *q;
        let (dx, dy) = (x3 - x2, y3 - y2);
        (
            [
                (x2 * x2 + y2 * y2 - 1.0) / 2.0,
                (dx * dx + dy * dy - 1.0) / 2.0,
                y3,
            ],
            [[x2, y2, 0.0, 0.0], [-dx, -dy, dx, dy], [0.0, 0.0, 0.0, 1.0]],
            [0.0; 3],
        )
    }
    fn potential(&self, q: &[f64; 4]) -> f64 {
        G * q[1] + 0.5 * G * q[3]
    }
    fn event(&self, _: f64, q: &[f64; 4], _: &[f64; 4]) -> f64 {
        q[0]
    }
}

/// The double four-bar: three cranks of 1 m and 1 kg, two couplers.
#[derive(Clone, Default)]
pub struct FourBar;

impl Scene<6, 6, 5> for FourBar {
    const STRUCTURE: Structure = Structure {
        position_forces: false,
        ..structure(true, false, 5)
    };
    const ROWS: &'static [Row] = &[
        row("crank0", Holonomic),
        row("crank1", Holonomic),
        row("crank2", Holonomic),
        row("coupler1", Holonomic),
        row("coupler2", Holonomic),
    ];
    fn guess(&self) -> ([f64; 6], [f64; 6]) {
        (
            [0.0, 1.0, 1.0, 1.0, 2.0, 1.0],
            [1.0, 0.0, 1.0, 0.0, 1.0, 0.0],
        )
    }
    fn mass(&self, _: &[f64; 6]) -> [[f64; 6]; 6] {
        let mut m = [[0.0; 6]; 6];
        for p in 0..3 {
            for x in 0..2 {
                m[2 * p + x][2 * p + x] = if p == 1 { 1.0 } else { 2.0 / 3.0 };
                if p < 2 {
                    m[2 * p + x][2 * p + 2 + x] = 1.0 / 6.0;
                    m[2 * p + 2 + x][2 * p + x] = 1.0 / 6.0;
                }
            }
        }
        m
    }
    fn force(&self, _: f64, _: &[f64; 6], _: &[f64; 6]) -> [f64; 6] {
        [0.0, -G, 0.0, -1.5 * G, 0.0, -G]
    }
    fn rows(&self, _: f64, q: &[f64; 6]) -> ([f64; 5], [[f64; 6]; 5], [f64; 5]) {
        let (mut phi, mut a) = ([0.0; 5], [[0.0; 6]; 5]);
        for p in 0..3 {
            let (x, y) = (q[2 * p] - p as f64, q[2 * p + 1]);
            phi[p] = (x * x + y * y - 1.0) / 2.0;
            a[p][2 * p] = x;
            a[p][2 * p + 1] = y;
        }
        for p in 0..2 {
            let (x, y) = (q[2 * p + 2] - q[2 * p], q[2 * p + 3] - q[2 * p + 1]);
            phi[3 + p] = (x * x + y * y - 1.0) / 2.0;
            a[3 + p][2 * p] = -x;
            a[3 + p][2 * p + 1] = -y;
            a[3 + p][2 * p + 2] = x;
            a[3 + p][2 * p + 3] = y;
        }
        (phi, a, [0.0; 5])
    }
    fn potential(&self, q: &[f64; 6]) -> f64 {
        G * (q[1] + 1.5 * q[3] + q[5])
    }
}

/// Forty four-bars in a row: 82 coordinates, 81 rows (LIM A02).
#[derive(Clone, Default)]
pub struct FortyFourBars;

impl Scene<82, 82, 81> for FortyFourBars {
    const STRUCTURE: Structure = Structure {
        position_forces: false,
        ..structure(true, false, 81)
    };
    fn guess(&self) -> ([f64; 82], [f64; 82]) {
        let q = std::array::from_fn(|i| if i % 2 == 0 { (i / 2) as f64 } else { 1.0 });
        (
            q,
            std::array::from_fn(|i| if i % 2 == 0 { 1.0 } else { 0.0 }),
        )
    }
    fn mass(&self, _: &[f64; 82]) -> [[f64; 82]; 82] {
        let mut m = [[0.0; 82]; 82];
        for i in 0..82 {
            m[i][i] = if (2..80).contains(&i) { 1.0 } else { 2.0 / 3.0 };
            if i < 80 {
                m[i][i + 2] = 1.0 / 6.0;
                m[i + 2][i] = 1.0 / 6.0;
            }
        }
        m
    }
    fn force(&self, _: f64, _: &[f64; 82], _: &[f64; 82]) -> [f64; 82] {
        std::array::from_fn(|i| match i {
            _ if i % 2 == 0 => 0.0,
            1 | 81 => -G,
            _ => -1.5 * G,
        })
    }
    fn rows(&self, _: f64, q: &[f64; 82]) -> ([f64; 81], [[f64; 82]; 81], [f64; 81]) {
        let (mut phi, mut a) = ([0.0; 81], [[0.0; 82]; 81]);
        for p in 0..41 {
            let (x, y) = (q[2 * p] - p as f64, q[2 * p + 1]);
            phi[p] = (x * x + y * y - 1.0) / 2.0;
            (a[p][2 * p], a[p][2 * p + 1]) = (x, y);
        }
        for p in 0..40 {
            let (x, y) = (q[2 * p + 2] - q[2 * p], q[2 * p + 3] - q[2 * p + 1]);
            phi[41 + p] = (x * x + y * y - 1.0) / 2.0;
            (a[41 + p][2 * p], a[41 + p][2 * p + 1]) = (-x, -y);
            (a[41 + p][2 * p + 2], a[41 + p][2 * p + 3]) = (x, y);
        }
        (phi, a, [0.0; 81])
    }
    fn potential(&self, q: &[f64; 82]) -> f64 {
        let f = self.force(0.0, q, q);
        -(0..82).map(|i| f[i] * q[i]).sum::<f64>()
    }
}

/// The slider-crank with a viscous force on its slider: the implicit step through singular poses.
#[derive(Clone, Default)]
pub struct DampedSliderCrank;

impl Scene<4, 4, 3> for DampedSliderCrank {
    const STRUCTURE: Structure = Structure {
        position_forces: false,
        ..structure(true, true, 3)
    };
    const ROWS: &'static [Row] = SliderCrank::ROWS;
    fn guess(&self) -> ([f64; 4], [f64; 4]) {
        SliderCrank.guess()
    }
    fn mass(&self, q: &[f64; 4]) -> [[f64; 4]; 4] {
        SliderCrank.mass(q)
    }
    fn force(&self, t: f64, q: &[f64; 4], v: &[f64; 4]) -> [f64; 4] {
        let mut f = SliderCrank.force(t, q, v);
        f[2] -= 0.05 * v[2];
        f
    }
    fn rows(&self, t: f64, q: &[f64; 4]) -> ([f64; 3], [[f64; 4]; 3], [f64; 3]) {
        SliderCrank.rows(t, q)
    }
    fn potential(&self, q: &[f64; 4]) -> f64 {
        SliderCrank.potential(q)
    }
    fn power(&self, _: f64, _: &[f64; 4], v: &[f64; 4]) -> f64 {
        -0.05 * v[2] * v[2]
    }
}

/// The double four-bar started where all its bars are horizontal: A has lost a rank.
#[derive(Clone, Default)]
pub struct FlatFourBar;

impl Scene<6, 6, 5> for FlatFourBar {
    const STRUCTURE: Structure = FourBar::STRUCTURE;
    const ROWS: &'static [Row] = FourBar::ROWS;
    fn guess(&self) -> ([f64; 6], [f64; 6]) {
        (
            [1.0, 0.0, 2.0, 0.0, 3.0, 0.0],
            [0.0, 1.0, 0.0, 1.0, 0.0, 1.0],
        )
    }
    fn mass(&self, q: &[f64; 6]) -> [[f64; 6]; 6] {
        FourBar.mass(q)
    }
    fn force(&self, t: f64, q: &[f64; 6], v: &[f64; 6]) -> [f64; 6] {
        FourBar.force(t, q, v)
    }
    fn rows(&self, t: f64, q: &[f64; 6]) -> ([f64; 5], [[f64; 6]; 5], [f64; 5]) {
        FourBar.rows(t, q)
    }
    fn potential(&self, q: &[f64; 6]) -> f64 {
        FourBar.potential(q)
    }
}

/// A pendulum with its row twice.
#[derive(Clone, Default)]
pub struct Doubled;

impl Scene<2, 2, 2> for Doubled {
    const STRUCTURE: Structure = Structure {
        position_forces: false,
        ..structure(true, false, 2)
    };
    const ROWS: &'static [Row] = &[row("rod", Holonomic), row("copy", Holonomic)];
    fn guess(&self) -> ([f64; 2], [f64; 2]) {
        ([1.1, 0.1], [0.3, 0.0])
    }
    fn mass(&self, _: &[f64; 2]) -> [[f64; 2]; 2] {
        [[1.0, 0.0], [0.0, 1.0]]
    }
    fn force(&self, _: f64, _: &[f64; 2], _: &[f64; 2]) -> [f64; 2] {
        [0.0, -G]
    }
    fn rows(&self, _: f64, q: &[f64; 2]) -> ([f64; 2], [[f64; 2]; 2], [f64; 2]) {
        let phi = (q[0] * q[0] + q[1] * q[1] - 1.0) / 2.0;
        (
            [phi, 2.0 * phi],
            [[q[0], q[1]], [2.0 * q[0], 2.0 * q[1]]],
            [0.0; 2],
        )
    }
    fn potential(&self, q: &[f64; 2]) -> f64 {
        G * q[1]
    }
}
