//! Small scenes, one for each kind of structure.

use super::{Scene, planar::G, row, structure};
use mbs_runtime::nalgebra::SMatrix;
use mbs_runtime::{
    Row,
    RowKind::{Holonomic, Nonholonomic, Rheonomic},
    Structure,
};

/// The slider-crank of `planar` in the two angles of its rods: M(q).
#[derive(Clone, Default)]
pub struct SliderCrankAngles;

impl Scene<2, 2, 1> for SliderCrankAngles {
    const STRUCTURE: Structure = structure(false, false, 1);
    const ROWS: &'static [Row] = &[row("liner", Holonomic)];
    fn guess(&self) -> ([f64; 2], [f64; 2]) {
        let a = std::f64::consts::FRAC_PI_4;
        let w = 2.0 / a.sin();
        ([a, -a], [w, -w])
    }
    fn mass(&self, q: &[f64; 2]) -> [[f64; 2]; 2] {
        let b = (q[0] - q[1]).cos() / 2.0;
        [[4.0 / 3.0, b], [b, 1.0 / 3.0]]
    }
    fn force(&self, _: f64, q: &[f64; 2], _: &[f64; 2]) -> [f64; 2] {
        [-1.5 * G * q[0].cos(), -0.5 * G * q[1].cos()]
    }
    fn kinetic_gradient(&self, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
        let x = (q[0] - q[1]).sin() / 2.0 * v[0] * v[1];
        [-x, x]
    }
    fn rows(&self, _: f64, q: &[f64; 2]) -> ([f64; 1], [[f64; 2]; 1], [f64; 1]) {
        ([q[0].sin() + q[1].sin()], [[q[0].cos(), q[1].cos()]], [0.0])
    }
    fn potential(&self, q: &[f64; 2]) -> f64 {
        G * (1.5 * q[0].sin() + 0.5 * q[1].sin())
    }
}

/// A knife edge at distance `a` behind the centre of mass: (x, y, θ) of the centre.
#[derive(Clone)]
pub struct Sleigh {
    pub mass: f64,
    pub inertia: f64,
    pub a: f64,
    pub guess: ([f64; 3], [f64; 3]),
    /// Coefficient of a viscous torque.
    pub drag: f64,
}

impl Default for Sleigh {
    fn default() -> Self {
        let a = 0.5;
        Sleigh {
            mass: 1.0,
            inertia: 0.3,
            a,
            guess: ([0.0; 3], [0.3, a * 2.0, 2.0]),
            drag: 0.0,
        }
    }
}

impl Scene<3, 3, 1> for Sleigh {
    const STRUCTURE: Structure = Structure {
        position_forces: false,
        ..structure(true, false, 0)
    };
    const ROWS: &'static [Row] = &[row("edge", Nonholonomic)];
    fn guess(&self) -> ([f64; 3], [f64; 3]) {
        self.guess
    }
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        [
            [self.mass, 0.0, 0.0],
            [0.0, self.mass, 0.0],
            [0.0, 0.0, self.inertia],
        ]
    }
    fn force(&self, _: f64, _: &[f64; 3], _: &[f64; 3]) -> [f64; 3] {
        [0.0; 3]
    }
    fn rows(&self, _: f64, q: &[f64; 3]) -> ([f64; 1], [[f64; 3]; 1], [f64; 1]) {
        ([0.0], [[-q[2].sin(), q[2].cos(), -self.a]], [0.0])
    }
    fn potential(&self, _: &[f64; 3]) -> f64 {
        0.0
    }
}

/// The sleigh with a viscous torque: nonholonomic rows in the implicit step.
#[derive(Clone, Default)]
pub struct DampedSleigh(pub Sleigh);

impl Scene<3, 3, 1> for DampedSleigh {
    const STRUCTURE: Structure = Structure {
        position_forces: false,
        smooth: true,
        ..structure(true, true, 0)
    };
    const ROWS: &'static [Row] = Sleigh::ROWS;
    fn guess(&self) -> ([f64; 3], [f64; 3]) {
        self.0.guess()
    }
    fn mass(&self, q: &[f64; 3]) -> [[f64; 3]; 3] {
        Scene::mass(&self.0, q)
    }
    fn force(&self, _: f64, _: &[f64; 3], v: &[f64; 3]) -> [f64; 3] {
        [-0.2 * v[0], -0.2 * v[1], -0.5 * v[2]]
    }
    fn rows(&self, t: f64, q: &[f64; 3]) -> ([f64; 1], [[f64; 3]; 1], [f64; 1]) {
        self.0.rows(t, q)
    }
    fn potential(&self, _: &[f64; 3]) -> f64 {
        0.0
    }
    fn power(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> f64 {
        let f = self.force(t, q, v);
        f[0] * v[0] + f[1] * v[1] + f[2] * v[2]
    }
}

/// A sleigh on a slope with a particle on a rod of 1 m at its centre: one holonomic and one nonholonomic row.
#[derive(Clone, Default)]
pub struct Towing;

impl Scene<5, 5, 2> for Towing {
    const STRUCTURE: Structure = Structure {
        position_forces: false,
        ..structure(true, false, 1)
    };
    const ROWS: &'static [Row] = &[row("rod", Holonomic), row("edge", Nonholonomic)];
    fn guess(&self) -> ([f64; 5], [f64; 5]) {
        ([0.0, 0.0, 0.0, 0.6, -0.8], [0.3, 0.8, 1.6, 0.3, 0.8])
    }
    fn mass(&self, _: &[f64; 5]) -> [[f64; 5]; 5] {
        let mut m = [[0.0; 5]; 5];
        for (i, value) in [1.0, 1.0, 0.3, 0.5, 0.5].into_iter().enumerate() {
            m[i][i] = value;
        }
        m
    }
    fn force(&self, _: f64, _: &[f64; 5], _: &[f64; 5]) -> [f64; 5] {
        [2.0, 0.0, 0.0, 1.0, 0.0]
    }
    fn rows(&self, _: f64, q: &[f64; 5]) -> ([f64; 2], [[f64; 5]; 2], [f64; 2]) {
        let (x, y) = (q[3] - q[0], q[4] - q[1]);
        (
            [(x * x + y * y - 1.0) / 2.0, 0.0],
            [
                [-x, -y, 0.0, x, y],
                [-q[2].sin(), q[2].cos(), -0.5, 0.0, 0.0],
            ],
            [0.0; 2],
        )
    }
    fn potential(&self, q: &[f64; 5]) -> f64 {
        -2.0 * q[0] - q[3]
    }
}

/// A body on a knife edge below its centre of mass, where the ground below the edge moves across it with the speed k t.
#[derive(Clone, Default)]
pub struct Pushed;

impl Pushed {
    const MASS: f64 = 2.0;
    /// k, m/s².
    const PUSH: f64 = 0.7;
    /// Speed along the edge at the start, m/s.
    const SPEED: f64 = 0.4;
    /// ω, rad/s.
    const SPIN: f64 = 1.5;

    /// (x, y, θ): as complex numbers ż = (w + i k t) e^{iωt} with the speed along the edge w = w₀ + ω k t²/2, so that
    /// z = e^{iωt} (α + β t − i k t²/2) − α.
    pub fn positions(t: f64) -> [f64; 3] {
        let (k, w) = (Self::PUSH, Self::SPIN);
        let (sin, cos) = (w * t).sin_cos();
        let beta = 2.0 * k / w;
        let alpha = -(Self::SPEED - beta) / w;
        let [real, imaginary] = [beta * t, alpha - 0.5 * k * t * t];
        [
            cos * real - sin * imaginary,
            sin * real + cos * imaginary - alpha,
            w * t,
        ]
    }

    /// The force across the edge m (u̇ + ω w), u = k t, N.
    pub fn lateral_force(t: f64) -> f64 {
        let (k, w) = (Self::PUSH, Self::SPIN);
        Self::MASS * (k + w * (Self::SPEED + 0.5 * w * k * t * t))
    }
}

impl Scene<3, 3, 1> for Pushed {
    const STRUCTURE: Structure = Structure {
        position_forces: false,
        ..structure(true, false, 0)
    };
    const ROWS: &'static [Row] = &[row("edge", Nonholonomic)];
    fn guess(&self) -> ([f64; 3], [f64; 3]) {
        ([0.0; 3], [Self::SPEED, 0.0, Self::SPIN])
    }
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        [
            [Self::MASS, 0.0, 0.0],
            [0.0, Self::MASS, 0.0],
            [0.0, 0.0, 0.3],
        ]
    }
    fn force(&self, _: f64, _: &[f64; 3], _: &[f64; 3]) -> [f64; 3] {
        [0.0; 3]
    }
    fn rows(&self, t: f64, q: &[f64; 3]) -> ([f64; 1], [[f64; 3]; 1], [f64; 1]) {
        ([0.0], [[-q[2].sin(), q[2].cos(), 0.0]], [-Self::PUSH * t])
    }
    fn potential(&self, _: &[f64; 3]) -> f64 {
        0.0
    }
}

/// First link rigid, second a spring k with a damper c, 1 kg each.
#[derive(Clone)]
pub struct StiffPendulum {
    pub stiffness: f64,
    pub damping: f64,
}

impl Default for StiffPendulum {
    fn default() -> Self {
        StiffPendulum {
            stiffness: 1e6,
            damping: 1e3,
        }
    }
}

impl StiffPendulum {
    fn spring(&self, q: &[f64; 4], v: &[f64; 4]) -> ([f64; 4], f64) {
        let (x, y) = (q[2] - q[0], q[3] - q[1]);
        let length = (x * x + y * y).sqrt();
        let (x, y) = (x / length, y / length);
        let rate = x * (v[2] - v[0]) + y * (v[3] - v[1]);
        let tension = self.stiffness * (length - 1.0) + self.damping * rate;
        let f = [tension * x, tension * y - G, -tension * x, -tension * y - G];
        (f, -self.damping * rate * rate)
    }
}

impl Scene<4, 4, 1> for StiffPendulum {
    const STRUCTURE: Structure = structure(true, true, 1);
    const ROWS: &'static [Row] = &[row("link", Holonomic)];
    fn guess(&self) -> ([f64; 4], [f64; 4]) {
        ([1.0, 0.0, 2.0, 0.0], [0.0; 4])
    }
    fn mass(&self, _: &[f64; 4]) -> [[f64; 4]; 4] {
        SMatrix::<f64, 4, 4>::identity().into()
    }
    fn force(&self, _: f64, q: &[f64; 4], v: &[f64; 4]) -> [f64; 4] {
        self.spring(q, v).0
    }
    fn rows(&self, _: f64, q: &[f64; 4]) -> ([f64; 1], [[f64; 4]; 1], [f64; 1]) {
        (
            [(q[0] * q[0] + q[1] * q[1] - 1.0) / 2.0],
            [[q[0], q[1], 0.0, 0.0]],
            [0.0],
        )
    }
    fn potential(&self, q: &[f64; 4]) -> f64 {
        let stretch = (q[2] - q[0]).hypot(q[3] - q[1]) - 1.0;
        G * (q[1] + q[3]) + 0.5 * self.stiffness * stretch * stretch
    }
    fn power(&self, _: f64, q: &[f64; 4], v: &[f64; 4]) -> f64 {
        self.spring(q, v).1
    }
}

/// The same without damper: a stiff spring that calls for the trapezoid.
#[derive(Clone)]
pub struct StiffSpring(pub f64);

impl Default for StiffSpring {
    fn default() -> Self {
        StiffSpring(1e6)
    }
}

impl StiffSpring {
    fn scene(&self) -> StiffPendulum {
        StiffPendulum {
            stiffness: self.0,
            damping: 0.0,
        }
    }
}

impl Scene<4, 4, 1> for StiffSpring {
    const STRUCTURE: Structure = structure(true, false, 1);
    const ROWS: &'static [Row] = StiffPendulum::ROWS;
    fn guess(&self) -> ([f64; 4], [f64; 4]) {
        self.scene().guess()
    }
    fn mass(&self, q: &[f64; 4]) -> [[f64; 4]; 4] {
        Scene::mass(&self.scene(), q)
    }
    fn force(&self, t: f64, q: &[f64; 4], _: &[f64; 4]) -> [f64; 4] {
        self.scene().force(t, q, &[0.0; 4])
    }
    fn rows(&self, t: f64, q: &[f64; 4]) -> ([f64; 1], [[f64; 4]; 1], [f64; 1]) {
        self.scene().rows(t, q)
    }
    fn potential(&self, q: &[f64; 4]) -> f64 {
        self.scene().potential(q)
    }
}

/// A free oscillator: no row at all.
#[derive(Clone, Default)]
pub struct Oscillator;

impl Scene<2, 2, 0> for Oscillator {
    const STRUCTURE: Structure = structure(true, false, 0);
    fn guess(&self) -> ([f64; 2], [f64; 2]) {
        ([1.0, 0.0], [0.0, 2.0])
    }
    fn mass(&self, _: &[f64; 2]) -> [[f64; 2]; 2] {
        [[1.0, 0.0], [0.0, 1.0]]
    }
    fn force(&self, _: f64, q: &[f64; 2], _: &[f64; 2]) -> [f64; 2] {
        [-4.0 * q[0], -4.0 * q[1]]
    }
    fn rows(&self, _: f64, _: &[f64; 2]) -> ([f64; 0], [[f64; 2]; 0], [f64; 0]) {
        ([], [], [])
    }
    fn potential(&self, q: &[f64; 2]) -> f64 {
        2.0 * (q[0] * q[0] + q[1] * q[1])
    }
}

/// A pendulum whose pivot is shaken along x.
#[derive(Clone, Default)]
pub struct Shaken;

impl Shaken {
    const AMPLITUDE: f64 = 0.3;
    const FREQUENCY: f64 = 5.0;
}

impl Scene<2, 2, 1> for Shaken {
    const STRUCTURE: Structure = Structure {
        position_forces: false,
        ..structure(true, false, 1)
    };
    const ROWS: &'static [Row] = &[row("rod", Rheonomic)];
    fn guess(&self) -> ([f64; 2], [f64; 2]) {
        ([0.6, -0.8], [0.0; 2])
    }
    fn mass(&self, _: &[f64; 2]) -> [[f64; 2]; 2] {
        [[2.0, 0.0], [0.0, 2.0]]
    }
    fn force(&self, _: f64, _: &[f64; 2], _: &[f64; 2]) -> [f64; 2] {
        [0.0, -2.0 * G]
    }
    fn rows(&self, t: f64, q: &[f64; 2]) -> ([f64; 1], [[f64; 2]; 1], [f64; 1]) {
        let (pivot, speed) = (
            Self::AMPLITUDE * (Self::FREQUENCY * t).sin(),
            Self::AMPLITUDE * Self::FREQUENCY * (Self::FREQUENCY * t).cos(),
        );
        let (x, y) = (q[0] - pivot, q[1]);
        ([(x * x + y * y - 1.0) / 2.0], [[x, y]], [-x * speed])
    }
    fn potential(&self, q: &[f64; 2]) -> f64 {
        2.0 * G * q[1]
    }
}

/// Two rows that contradict each other.
#[derive(Clone, Default)]
pub struct Contradiction;

impl Scene<2, 2, 2> for Contradiction {
    const STRUCTURE: Structure = structure(true, false, 2);
    const ROWS: &'static [Row] = &[row("near", Holonomic), row("far", Holonomic)];
    fn guess(&self) -> ([f64; 2], [f64; 2]) {
        ([0.5, 0.3], [0.0; 2])
    }
    fn mass(&self, _: &[f64; 2]) -> [[f64; 2]; 2] {
        [[1.0, 0.0], [0.0, 1.0]]
    }
    fn force(&self, _: f64, _: &[f64; 2], _: &[f64; 2]) -> [f64; 2] {
        [0.0; 2]
    }
    fn rows(&self, _: f64, q: &[f64; 2]) -> ([f64; 2], [[f64; 2]; 2], [f64; 2]) {
        ([q[0] - 1.0, q[0] - 2.0], [[1.0, 0.0], [1.0, 0.0]], [0.0; 2])
    }
    fn potential(&self, _: &[f64; 2]) -> f64 {
        0.0
    }
}
