//! Bricard's linkage: five rods, six revolutes, 30 rows of rank 29, one degree of freedom.

use super::space::*;
use super::{Scene, row, structure};
use mbs_runtime::generated::Spin;
use mbs_runtime::{Row, RowKind::Holonomic, Structure};

const G: f64 = 9.81;
/// About the axis of a rod, and across.
const MOMENTS: Vector = [1.67e-3, 1.0 / 12.0, 1.0 / 12.0];
/// Rod i goes from point i to point i + 1.
const POINTS: [Vector; 6] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [1.0, -1.0, 0.0],
    [1.0, -1.0, 1.0],
    [0.0, -1.0, 1.0],
    [0.0, 0.0, 1.0],
];
/// Of the revolute at point j.
const AXES: [Vector; 6] = [
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [1.0, 0.0, 0.0],
];

#[derive(Clone)]
pub struct Bricard {
    home: [(Vector, Rotation); 5],
    moments: Vector,
}

impl Bricard {
    /// Rods of 1 mm: 10⁻⁶ of the inertia across is left about their axes.
    pub fn slender() -> Self {
        Bricard {
            moments: [1.67e-7, 1.0 / 12.0, 1.0 / 12.0],
            ..Bricard::default()
        }
    }
}

impl Default for Bricard {
    fn default() -> Self {
        Bricard {
            moments: MOMENTS,
            home: std::array::from_fn(|i| {
                let x = sum(POINTS[i + 1], scaled(-1.0, POINTS[i]));
                let other = match x[2].abs() < 0.5 {
                    true => [0.0, 0.0, 1.0],
                    false => [1.0, 0.0, 0.0],
                };
                let y = cross(other, x);
                let z = cross(x, y);
                let frame = std::array::from_fn(|i| [x[i], y[i], z[i]]);
                (scaled(0.5, sum(POINTS[i], POINTS[i + 1])), frame)
            }),
        }
    }
}

const NAMES: [&str; 30] = [
    "a.x", "a.y", "a.z", "a.u", "a.v", "b.x", "b.y", "b.z", "b.u", "b.v", "c.x", "c.y", "c.z",
    "c.u", "c.v", "d.x", "d.y", "d.z", "d.u", "d.v", "e.x", "e.y", "e.z", "e.u", "e.v", "f.x",
    "f.y", "f.z", "f.u", "f.v",
];
const ENTRIES: [&str; 6] = ["a", "b", "c", "d", "e", "f"];

const fn rows() -> [Row; 30] {
    let mut rows = [row("", Holonomic); 30];
    let mut i = 0;
    while i < 30 {
        rows[i] = row(NAMES[i], Holonomic);
        rows[i].entry = ENTRIES[i / 5];
        i += 1;
    }
    rows
}

/// A body as the rows see it: where it is now, and its home; the ground where there is none.
#[derive(Clone, Copy)]
struct Partner {
    body: Option<usize>,
    place: Vector,
    turn: Rotation,
    home: (Vector, Rotation),
}

const UNIT: Rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl Bricard {
    fn partner(&self, q: &[f64; 35], body: Option<usize>) -> Partner {
        let (place, turn, home) = match body {
            Some(i) => {
                let q = &q[7 * i..7 * i + 7];
                ([q[0], q[1], q[2]], matrix(&q[3..]), self.home[i])
            }
            None => ([0.0; 3], UNIT, ([0.0; 3], UNIT)),
        };
        Partner {
            body,
            place,
            turn,
            home,
        }
    }
}

impl Partner {
    /// A direction of the home pose in body axes.
    fn direction(&self, x: Vector) -> Vector {
        to_body(&self.home.1, x)
    }
    fn point(&self, x: Vector) -> Vector {
        self.direction(sum(x, scaled(-1.0, self.home.0)))
    }
    /// `force · velocity of the point + torque (space axes) · ω` as entries of a row.
    fn add(&self, row: &mut [f64; 30], force: Vector, point: Vector, torque: Vector) {
        if let Some(i) = self.body {
            let body = cross(point, to_body(&self.turn, force));
            let body = sum(body, to_body(&self.turn, torque));
            for k in 0..3 {
                row[6 * i + k] += force[k];
                row[6 * i + 3 + k] += body[k];
            }
        }
    }
}

impl Scene<35, 30, 30> for Bricard {
    const STRUCTURE: Structure = Structure {
        position_forces: false,
        rotations: 5,
        ..structure(true, false, 30)
    };
    const ROTATIONS: &'static [usize] = &[3, 9, 15, 21, 27];
    const ROWS: &'static [Row] = &rows();
    fn guess(&self) -> ([f64; 35], [f64; 30]) {
        let mut q = [0.0; 35];
        for (q, (place, frame)) in q.chunks_exact_mut(7).zip(&self.home) {
            q[..3].copy_from_slice(place);
            q[3..].copy_from_slice(&quaternion(frame));
        }
        (q, [0.0; 30])
    }
    fn mass(&self, _: &[f64; 35]) -> [[f64; 30]; 30] {
        let diagonal = |i: usize| {
            if i % 6 < 3 {
                1.0
            } else {
                self.moments[i % 6 - 3]
            }
        };
        std::array::from_fn(|i| std::array::from_fn(|j| if i == j { diagonal(i) } else { 0.0 }))
    }
    fn force(&self, _: f64, _: &[f64; 35], _: &[f64; 30]) -> [f64; 30] {
        std::array::from_fn(|i| if i % 6 == 1 { -G } else { 0.0 })
    }
    fn kinetic_gradient(&self, _: &[f64; 35], v: &[f64; 30]) -> [f64; 30] {
        let mut f = [0.0; 30];
        for (f, v) in f.chunks_exact_mut(6).zip(v.chunks_exact(6)) {
            let w = [v[3], v[4], v[5]];
            f[3..].copy_from_slice(&cross(std::array::from_fn(|i| self.moments[i] * w[i]), w));
        }
        f
    }
    fn spins(&self) -> Vec<Spin> {
        let [x, y, z] = self.moments;
        let spin = Spin::new(&[[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]], "rod").unwrap();
        vec![spin; 5]
    }
    fn rows(&self, _: f64, q: &[f64; 35]) -> ([f64; 30], [[f64; 30]; 30], [f64; 30]) {
        let (mut phi, mut rows) = ([0.0; 30], [[0.0; 30]; 30]);
        for j in 0..6_usize {
            let a = self.partner(q, j.checked_sub(1));
            let b = self.partner(q, (j < 5).then_some(j));
            let (pa, pb) = (a.point(POINTS[j]), b.point(POINTS[j]));
            let at_a = sum(a.place, to_space(&a.turn, pa));
            let at_b = sum(b.place, to_space(&b.turn, pb));
            for k in 0..3 {
                let mut e = [0.0; 3];
                e[k] = 1.0;
                phi[5 * j + k] = at_a[k] - at_b[k];
                a.add(&mut rows[5 * j + k], e, pa, [0.0; 3]);
                b.add(&mut rows[5 * j + k], scaled(-1.0, e), pb, [0.0; 3]);
            }
            let other = match AXES[j][0].abs() < 0.9 {
                true => [1.0, 0.0, 0.0],
                false => [0.0, 1.0, 0.0],
            };
            let u = cross(AXES[j], other);
            let s = to_space(&a.turn, a.direction(AXES[j]));
            for (i, across) in [u, cross(AXES[j], u)].into_iter().enumerate() {
                let w = to_space(&b.turn, b.direction(across));
                phi[5 * j + 3 + i] = dot(s, w);
                let torque = cross(s, w);
                a.add(&mut rows[5 * j + 3 + i], [0.0; 3], [0.0; 3], torque);
                b.add(
                    &mut rows[5 * j + 3 + i],
                    [0.0; 3],
                    [0.0; 3],
                    scaled(-1.0, torque),
                );
            }
        }
        (phi, rows, [0.0; 30])
    }
    fn potential(&self, q: &[f64; 35]) -> f64 {
        (0..5).map(|i| G * q[7 * i + 1]).sum()
    }
}
