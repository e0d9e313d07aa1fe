//! Rigid bodies in space: q = (position, unit quaternion), v = (velocity in space axes, ω in body axes), body by body.

use super::space::*;
use super::{Scene, row, structure};
use mbs_runtime::generated::Spin;
use mbs_runtime::{
    Row,
    RowKind::{Holonomic, Nonholonomic},
    Structure,
};

pub const G: f64 = 9.81;

/// `structure` with rotations.
const fn spatial(bodies: usize, velocity_forces: bool, holonomic_rows: usize) -> Structure {
    Structure {
        rotations: bodies,
        ..structure(true, velocity_forces, holonomic_rows)
    }
}

/// Principal moments of a body in its own axes.
fn spin(moments: Vector) -> Spin {
    let [x, y, z] = moments;
    Spin::new(&[[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]], "body").unwrap()
}

fn masses(mass: f64, moments: Vector) -> [[f64; 6]; 6] {
    let [x, y, z] = moments;
    let diagonal = [mass, mass, mass, x, y, z];
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { diagonal[i] } else { 0.0 }))
}

/// (Jω) × ω in the place of the torque.
fn gyroscopic(moments: Vector, v: &[f64]) -> [f64; 6] {
    let w = [v[3], v[4], v[5]];
    let [x, y, z] = cross(std::array::from_fn(|i| moments[i] * w[i]), w);
    [0.0, 0.0, 0.0, x, y, z]
}

fn joined(a: Vector, b: Vector) -> [f64; 6] {
    [a[0], a[1], a[2], b[0], b[1], b[2]]
}

/// A body without forces, principal moments 1, 2 and 2.5 kg m², turned out of its axes.
#[derive(Clone)]
pub struct FreeBody(pub Vector);

impl Default for FreeBody {
    fn default() -> Self {
        FreeBody([1.0, 2.0, 2.5])
    }
}

impl Scene<7, 6, 0> for FreeBody {
    const STRUCTURE: Structure = Structure {
        position_forces: false,
        ..spatial(1, false, 0)
    };
    const ROTATIONS: &'static [usize] = &[3];
    fn guess(&self) -> ([f64; 7], [f64; 6]) {
        (
            [0.0, 0.0, 0.0, 0.8, 0.0, 0.6, 0.0],
            [1.0, 0.5, -0.2, 1.0, -2.0, 0.7],
        )
    }
    fn mass(&self, _: &[f64; 7]) -> [[f64; 6]; 6] {
        masses(2.0, self.0)
    }
    fn force(&self, _: f64, _: &[f64; 7], _: &[f64; 6]) -> [f64; 6] {
        [0.0; 6]
    }
    fn kinetic_gradient(&self, _: &[f64; 7], v: &[f64; 6]) -> [f64; 6] {
        gyroscopic(self.0, v)
    }
    fn spins(&self) -> Vec<Spin> {
        vec![spin(self.0)]
    }
    fn rows(&self, _: f64, _: &[f64; 7]) -> ([f64; 0], [[f64; 6]; 0], [f64; 0]) {
        ([], [], [])
    }
    fn potential(&self, _: &[f64; 7]) -> f64 {
        0.0
    }
}

/// The heavy top of Géradin and Cardona: 15 kg, 1 m from its pivot, 150 rad/s.
#[derive(Clone, Default)]
pub struct HeavyTop;

pub const TOP: Vector = [0.234375, 0.46875, 0.234375];
pub const TOP_MASS: f64 = 15.0;

/// The rows of a point `p` (from the centre of mass, body axes) held at the origin.
fn pivot(q: &[f64; 7], p: Vector) -> ([f64; 3], [[f64; 6]; 3], [f64; 3]) {
    let r = matrix(&q[3..]);
    let phi = sum([q[0], q[1], q[2]], to_space(&r, p));
    let rows = std::array::from_fn(|i| {
        let mut e = [0.0; 3];
        e[i] = 1.0;
        joined(e, cross(p, to_body(&r, e)))
    });
    (phi, rows, [0.0; 3])
}

impl Scene<7, 6, 3> for HeavyTop {
    const STRUCTURE: Structure = Structure {
        position_forces: false,
        ..spatial(1, false, 3)
    };
    const ROTATIONS: &'static [usize] = &[3];
    const ROWS: &'static [Row] = &[
        row("pivot.x", Holonomic),
        row("pivot.y", Holonomic),
        row("pivot.z", Holonomic),
    ];
    fn guess(&self) -> ([f64; 7], [f64; 6]) {
        let spin = 4.61538;
        (
            [0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0],
            [spin, 0.0, 0.0, 0.0, 150.0, -spin],
        )
    }
    fn mass(&self, _: &[f64; 7]) -> [[f64; 6]; 6] {
        masses(TOP_MASS, TOP)
    }
    fn force(&self, _: f64, _: &[f64; 7], _: &[f64; 6]) -> [f64; 6] {
        [0.0, 0.0, -TOP_MASS * G, 0.0, 0.0, 0.0]
    }
    fn kinetic_gradient(&self, _: &[f64; 7], v: &[f64; 6]) -> [f64; 6] {
        gyroscopic(TOP, v)
    }
    fn spins(&self) -> Vec<Spin> {
        vec![spin(TOP)]
    }
    fn rows(&self, _: f64, q: &[f64; 7]) -> ([f64; 3], [[f64; 6]; 3], [f64; 3]) {
        pivot(q, [0.0, -1.0, 0.0])
    }
    fn potential(&self, q: &[f64; 7]) -> f64 {
        TOP_MASS * G * q[2]
    }
}

/// An asymmetric body on a pivot, held by two springs with dampers: `DAMPED` tells whether these may differ from zero.
#[derive(Clone)]
pub struct Sprung<const DAMPED: bool> {
    pub stiffness: f64,
    pub damping: f64,
    /// ω, rad/s.
    pub spin: Vector,
}

impl<const DAMPED: bool> Default for Sprung<DAMPED> {
    fn default() -> Self {
        Sprung {
            stiffness: 1e4,
            damping: if DAMPED { 50.0 } else { 0.0 },
            spin: [0.5, 1.0, -0.4],
        }
    }
}

const MOMENTS: Vector = [0.1, 0.2, 0.25];
const PIVOT: Vector = [0.0, 0.0, -0.5];
/// Points of the body and of the world, and natural lengths.
const SPRINGS: [(Vector, Vector, f64); 2] = [
    ([0.3, 0.1, 0.2], [1.0, 0.2, 0.9], 0.73),
    ([-0.2, 0.3, 0.1], [-0.8, 0.9, 0.4], 0.87),
];

impl<const DAMPED: bool> Sprung<DAMPED> {
    /// Stretch, its rate, unit vector from body to world, and the point of the body (body axes), of each spring.
    fn springs(&self, q: &[f64; 7], v: &[f64; 6]) -> [(f64, f64, Vector, Vector); 2] {
        let r = matrix(&q[3..]);
        SPRINGS.map(|(p, world, natural)| {
            let point = sum([q[0], q[1], q[2]], to_space(&r, p));
            let way = sum(world, scaled(-1.0, point));
            let length = dot(way, way).sqrt();
            let unit = scaled(1.0 / length, way);
            let swing = to_space(&r, cross([v[3], v[4], v[5]], p));
            let rate = -dot(unit, sum([v[0], v[1], v[2]], swing));
            (length - natural, rate, unit, p)
        })
    }
}

impl<const DAMPED: bool> Scene<7, 6, 3> for Sprung<DAMPED> {
    const STRUCTURE: Structure = spatial(1, DAMPED, 3);
    const ROTATIONS: &'static [usize] = &[3];
    const ROWS: &'static [Row] = HeavyTop::ROWS;
    fn guess(&self) -> ([f64; 7], [f64; 6]) {
        let v = scaled(-1.0, cross(self.spin, PIVOT));
        ([0.0, 0.0, 0.5, 1.0, 0.0, 0.0, 0.0], joined(v, self.spin))
    }
    fn mass(&self, _: &[f64; 7]) -> [[f64; 6]; 6] {
        masses(2.0, MOMENTS)
    }
    fn force(&self, _: f64, q: &[f64; 7], v: &[f64; 6]) -> [f64; 6] {
        let r = matrix(&q[3..]);
        let mut f = [0.0, 0.0, -2.0 * G, 0.0, 0.0, 0.0];
        for (stretch, rate, unit, p) in self.springs(q, v) {
            let pull = scaled(self.stiffness * stretch + self.damping * rate, unit);
            let part = joined(pull, cross(p, to_body(&r, pull)));
            f = std::array::from_fn(|i| f[i] + part[i]);
        }
        f
    }
    fn kinetic_gradient(&self, _: &[f64; 7], v: &[f64; 6]) -> [f64; 6] {
        gyroscopic(MOMENTS, v)
    }
    fn spins(&self) -> Vec<Spin> {
        vec![spin(MOMENTS)]
    }
    fn rows(&self, _: f64, q: &[f64; 7]) -> ([f64; 3], [[f64; 6]; 3], [f64; 3]) {
        pivot(q, PIVOT)
    }
    fn potential(&self, q: &[f64; 7]) -> f64 {
        let springs = self.springs(q, &[0.0; 6]);
        let stored = |(stretch, ..): &(f64, f64, Vector, Vector)| stretch * stretch;
        2.0 * G * q[2] + 0.5 * self.stiffness * springs.iter().map(stored).sum::<f64>()
    }
    fn power(&self, _: f64, q: &[f64; 7], v: &[f64; 6]) -> f64 {
        let springs = self.springs(q, v);
        -self.damping * springs.iter().map(|s| s.1 * s.1).sum::<f64>()
    }
}

/// A thin disk that rolls without slip: 2.5 kg, 0.4 m, its axis is y of the body.
#[derive(Clone, Default)]
pub struct RollingDisk;

const RADIUS: f64 = 0.4;
const DISK: Vector = [0.1, 0.2, 0.1];

/// From the centre to the point of contact.
fn contact(q: &[f64; 7]) -> Vector {
    let axis = to_space(&matrix(&q[3..]), [0.0, 1.0, 0.0]);
    let up = sum([0.0, 0.0, 1.0], scaled(-axis[2], axis));
    scaled(-RADIUS / dot(up, up).sqrt(), up)
}

impl Scene<7, 6, 3> for RollingDisk {
    const STRUCTURE: Structure = Structure {
        position_forces: false,
        ..spatial(1, false, 1)
    };
    const ROTATIONS: &'static [usize] = &[3];
    const ROWS: &'static [Row] = &[
        row("ground.z", Holonomic),
        row("ground.x", Nonholonomic),
        row("ground.y", Nonholonomic),
    ];
    fn guess(&self) -> ([f64; 7], [f64; 6]) {
        let (sin, cos) = 0.2_f64.sin_cos();
        let q = [
            0.0,
            0.0,
            RADIUS * cos,
            0.1_f64.cos(),
            0.1_f64.sin(),
            0.0,
            0.0,
        ];
        // ψ' e_z + φ' e_y of the leaning disk.
        let w = to_body(&matrix(&q[3..]), [0.0, -5.0 * cos, 1.2 - 5.0 * sin]);
        let v = cross(to_space(&matrix(&q[3..]), w), scaled(-1.0, contact(&q)));
        (q, joined(v, w))
    }
    fn mass(&self, _: &[f64; 7]) -> [[f64; 6]; 6] {
        masses(2.5, DISK)
    }
    fn force(&self, _: f64, _: &[f64; 7], _: &[f64; 6]) -> [f64; 6] {
        [0.0, 0.0, -2.5 * G, 0.0, 0.0, 0.0]
    }
    fn kinetic_gradient(&self, _: &[f64; 7], v: &[f64; 6]) -> [f64; 6] {
        gyroscopic(DISK, v)
    }
    fn spins(&self) -> Vec<Spin> {
        vec![spin(DISK)]
    }
    fn rows(&self, _: f64, q: &[f64; 7]) -> ([f64; 3], [[f64; 6]; 3], [f64; 3]) {
        let r = matrix(&q[3..]);
        let c = contact(q);
        let along = |e: Vector| joined(e, to_body(&r, cross(c, e)));
        (
            [q[2] + c[2], 0.0, 0.0],
            [
                along([0.0, 0.0, 1.0]),
                along([1.0, 0.0, 0.0]),
                along([0.0, 1.0, 0.0]),
            ],
            [0.0; 3],
        )
    }
    fn potential(&self, q: &[f64; 7]) -> f64 {
        2.5 * G * q[2]
    }
}
