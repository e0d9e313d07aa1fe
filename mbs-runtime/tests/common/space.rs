//! Vectors and rotations of space, as plainly as possible.

pub type Vector = [f64; 3];
/// By rows.
pub type Rotation = [Vector; 3];

pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

pub fn sum(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub fn scaled(a: f64, b: Vector) -> Vector {
    [a * b[0], a * b[1], a * b[2]]
}

/// Body axes to space axes.
pub fn matrix(q: &[f64]) -> Rotation {
    let [w, x, y, z] = [q[0], q[1], q[2], q[3]];
    [
        [
            w * w + x * x - y * y - z * z,
            2.0 * (x * y - w * z),
            2.0 * (x * z + w * y),
        ],
        [
            2.0 * (x * y + w * z),
            w * w - x * x + y * y - z * z,
            2.0 * (y * z - w * x),
        ],
        [
            2.0 * (x * z - w * y),
            2.0 * (y * z + w * x),
            w * w - x * x - y * y + z * z,
        ],
    ]
}

pub fn to_space(r: &Rotation, x: Vector) -> Vector {
    [dot(r[0], x), dot(r[1], x), dot(r[2], x)]
}

pub fn to_body(r: &Rotation, x: Vector) -> Vector {
    let along = |i: usize| r[0][i] * x[0] + r[1][i] * x[1] + r[2][i] * x[2];
    [along(0), along(1), along(2)]
}

/// The unit quaternion of a rotation.
pub fn quaternion(r: &Rotation) -> [f64; 4] {
    let (x, y, z) = (r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]);
    let (xy, xz, yz) = (r[1][0] + r[0][1], r[0][2] + r[2][0], r[2][1] + r[1][2]);
    // 4 q qᵀ; the longest row has the most digits.
    let rows = [
        [1.0 + r[0][0] + r[1][1] + r[2][2], x, y, z],
        [x, 1.0 + r[0][0] - r[1][1] - r[2][2], xy, xz],
        [y, xy, 1.0 - r[0][0] + r[1][1] - r[2][2], yz],
        [z, xz, yz, 1.0 - r[0][0] - r[1][1] + r[2][2]],
    ];
    let square = |row: &[f64; 4]| row.iter().map(|x| x * x).sum::<f64>();
    let longest = rows
        .into_iter()
        .max_by(|a, b| square(a).total_cmp(&square(b)));
    let row = longest.unwrap_or_default();
    row.map(|x| x / square(&row).sqrt())
}
