//! The double four-bar written by hand, as an engineer would write it for this one mechanism: the same two-level step
//! (kick, leapfrog, kick; multipliers extrapolated from the last two steps; chord iteration on A₀M⁻¹A₀ᵀ, replaced by
//! B = A₁M⁻¹A₀ᵀ if it converges slowly), on fixed arrays, without zeros and with precomputed constants.
/// Tips of the three cranks.
const N: usize = 6;
/// Three cranks, two couplers.
const R: usize = 5;

/// Gravity, m/s².
const GRAVITY: f64 = 9.81;
/// Squared tolerance of φ/|a|, m².
const TOLERANCE: f64 = 1e-26;
/// A pivot below this part of its diagonal belongs to a singular pose.
const SMALL_PIVOT: f64 = 1e-7;
const MOST_ITERATIONS: usize = 25;

/// Inverse of the 3 × 3 matrix that couples the tips (the same for x and y), and its products with the couplers.
struct Mass {
    inverse: [[f64; 3]; 3],
    /// M⁻¹(e_{j+1} − e_j) for coupler j.
    coupler: [[f64; 3]; 2],
    /// M⁻¹f: the acceleration of the tips without the rows of the bars (the pivot carries half of a crank's weight).
    fall: [f64; 3],
}

/// The mechanism and its state.
pub struct DoubleFourBar {
    mass: Mass,
    pub q: [f64; N],
    pub v: [f64; N],
    /// κ₁/h of the last step and its change.
    multiplier: [f64; R],
    change: [f64; R],
    rows: [[f64; 2]; R],
    weighted: [[f64; N]; R],
    dual: Symmetric,
}

/// S = Uᵀ D⁻¹ U.
struct Symmetric {
    upper: [[f64; R]; R],
    inverse_pivot: [f64; R],
    regular: bool,
    matrix: [[f64; R]; R],
}

impl DoubleFourBar {
    /// Bars of 1 m and 1 kg, cranks upright, turning at −1 rad/s.
    pub fn new() -> Self {
        let m = [
            [2.0 / 3.0, 1.0 / 6.0, 0.0],
            [1.0 / 6.0, 1.0, 1.0 / 6.0],
            [0.0, 1.0 / 6.0, 2.0 / 3.0],
        ];
        let inverse = invert(m);
        let coupler =
            std::array::from_fn(|j| std::array::from_fn(|i| inverse[i][j + 1] - inverse[i][j]));
        let weight = [1.0, 1.5, 1.0].map(|bars| bars * GRAVITY);
        let fall = std::array::from_fn(|i| (0..3).map(|j| inverse[i][j] * weight[j]).sum());
        let mut mechanism = DoubleFourBar {
            mass: Mass {
                inverse,
                coupler,
                fall,
            },
            q: [0.0, 1.0, 1.0, 1.0, 2.0, 1.0],
            v: [1.0, 0.0, 1.0, 0.0, 1.0, 0.0],
            multiplier: [0.0; R],
            change: [0.0; R],
            rows: [[0.0; 2]; R],
            weighted: [[0.0; N]; R],
            dual: Symmetric {
                upper: [[0.0; R]; R],
                inverse_pivot: [0.0; R],
                regular: true,
                matrix: [[0.0; R]; R],
            },
        };
        mechanism.rows = directions(&mechanism.q);
        mechanism.weighted = mechanism.mass.weigh(&mechanism.rows);
        mechanism.dual.factor(&mechanism.rows, &mechanism.weighted);
        mechanism
    }

    /// T + V.
    pub fn energy(&self) -> f64 {
        let q = &self.q;
        let bar = |ax: f64, ay: f64, bx: f64, by: f64| {
            (ax * ax + ay * ay + bx * bx + by * by + ax * bx + ay * by) / 6.0
        };
        let v = &self.v;
        let kinetic = bar(0.0, 0.0, v[0], v[1])
            + bar(0.0, 0.0, v[2], v[3])
            + bar(0.0, 0.0, v[4], v[5])
            + bar(v[0], v[1], v[2], v[3])
            + bar(v[2], v[3], v[4], v[5]);
        kinetic + GRAVITY * (q[1] + 1.5 * q[3] + q[5])
    }

    /// One step of h seconds.
    pub fn step(&mut self, h: f64) {
        let lengths: [f64; R] = std::array::from_fn(|i| self.dual.matrix[i][i]);
        let mut kappa: [f64; R] =
            std::array::from_fn(|i| h * (self.multiplier[i] + self.change[i]));
        let mut va = self.v;
        accumulate(&mut va, &self.weighted, &kappa);
        let fall = self.mass.fall.map(|fall| 0.5 * h * fall);
        let mut q = self.q;
        let mut renewed: Option<General> = None;
        let mut last = f64::INFINITY;
        let mut rows = self.rows;
        for iteration in 0..MOST_ITERATIONS {
            for p in 0..3 {
                q[2 * p] = self.q[2 * p] + h * va[2 * p];
                q[2 * p + 1] = self.q[2 * p + 1] + h * (va[2 * p + 1] - fall[p]);
            }
            rows = directions(&q);
            let phi: [f64; R] = std::array::from_fn(|i| {
                0.5 * (rows[i][0] * rows[i][0] + rows[i][1] * rows[i][1] - 1.0)
            });
            let residual = (0..R).fold(0.0, |worst: f64, i| worst.max(phi[i] * phi[i]));
            if residual <= TOLERANCE {
                break;
            }
            let slow = iteration > 0 && residual * residual > last * TOLERANCE;
            if slow || !self.dual.regular {
                renewed = Some(General::new(&rows, &self.weighted, &lengths));
            }
            let mut change = phi;
            match &renewed {
                Some(general) => general.solve(&mut change),
                None => self.dual.solve(&mut change),
            }
            for i in 0..R {
                change[i] /= -h;
                kappa[i] += change[i];
            }
            accumulate(&mut va, &self.weighted, &change);
            last = residual;
        }
        let mut v = va;
        for p in 0..3 {
            v[2 * p + 1] -= 2.0 * fall[p];
        }
        self.rows = rows;
        self.weighted = self.mass.weigh(&rows);
        self.dual.factor(&rows, &self.weighted);
        let mut rate: [f64; R] = std::array::from_fn(|i| {
            if i < 3 {
                -(rows[i][0] * v[2 * i] + rows[i][1] * v[2 * i + 1])
            } else {
                let j = 2 * (i - 3);
                -(rows[i][0] * (v[j + 2] - v[j]) + rows[i][1] * (v[j + 3] - v[j + 1]))
            }
        });
        self.dual.solve(&mut rate);
        accumulate(&mut v, &self.weighted, &rate);
        self.q = q;
        self.v = v;
        for i in 0..R {
            let force = kappa[i] / h;
            self.change[i] = force - self.multiplier[i];
            self.multiplier[i] = force;
        }
    }
}

/// Directions of the bars: row i of A is d_i at its tip (cranks), or −d_i and d_i at the two tips (couplers).
fn directions(q: &[f64; N]) -> [[f64; 2]; R] {
    [
        [q[0], q[1]],
        [q[2] - 1.0, q[3]],
        [q[4] - 2.0, q[5]],
        [q[2] - q[0], q[3] - q[1]],
        [q[4] - q[2], q[5] - q[3]],
    ]
}

impl Mass {
    /// M⁻¹Aᵀ.
    fn weigh(&self, rows: &[[f64; 2]; R]) -> [[f64; N]; R] {
        std::array::from_fn(|i| {
            let column = if i < 3 {
                &self.inverse[i]
            } else {
                &self.coupler[i - 3]
            };
            std::array::from_fn(|c| column[c / 2] * rows[i][c % 2])
        })
    }
}

/// a_i · w
fn row_times(rows: &[[f64; 2]; R], i: usize, w: &[f64; N]) -> f64 {
    let d = &rows[i];
    if i < 3 {
        d[0] * w[2 * i] + d[1] * w[2 * i + 1]
    } else {
        let j = 2 * (i - 3);
        d[0] * (w[j + 2] - w[j]) + d[1] * (w[j + 3] - w[j + 1])
    }
}

fn accumulate(x: &mut [f64; N], rows: &[[f64; N]; R], factors: &[f64; R]) {
    for i in 0..R {
        for c in 0..N {
            x[c] += factors[i] * rows[i][c];
        }
    }
}

impl Symmetric {
    fn factor(&mut self, rows: &[[f64; 2]; R], weighted: &[[f64; N]; R]) {
        for i in 0..R {
            for j in i..R {
                self.matrix[i][j] = row_times(rows, i, &weighted[j]);
            }
        }
        self.upper = self.matrix;
        self.regular = true;
        let upper = &mut self.upper;
        for k in 0..R {
            let pivot = upper[k][k];
            if pivot <= SMALL_PIVOT * self.matrix[k][k] {
                self.regular = false;
                return;
            }
            let inverse = 1.0 / pivot;
            self.inverse_pivot[k] = inverse;
            for i in k + 1..R {
                let factor = upper[k][i] * inverse;
                for j in i..R {
                    upper[i][j] -= factor * upper[k][j];
                }
            }
        }
    }

    fn solve(&self, x: &mut [f64; R]) {
        if !self.regular {
            let full =
                std::array::from_fn(|i| std::array::from_fn(|j| self.matrix[i.min(j)][i.max(j)]));
            return least_squares(&full, x);
        }
        for k in 0..R {
            let factor = x[k] * self.inverse_pivot[k];
            for j in k + 1..R {
                x[j] -= factor * self.upper[k][j];
            }
        }
        for k in (0..R).rev() {
            for j in k + 1..R {
                x[k] -= self.upper[k][j] * x[j];
            }
            x[k] *= self.inverse_pivot[k];
        }
    }
}

/// B = L U, or B itself where a pivot is small.
struct General {
    lu: [[f64; R]; R],
    matrix: Option<[[f64; R]; R]>,
}

impl General {
    #[cold]
    fn new(rows: &[[f64; 2]; R], weighted: &[[f64; N]; R], lengths: &[f64; R]) -> Self {
        let matrix: [[f64; R]; R] =
            std::array::from_fn(|i| std::array::from_fn(|j| row_times(rows, i, &weighted[j])));
        let mut lu = matrix;
        for k in 0..R {
            if lu[k][k].abs() <= SMALL_PIVOT * lengths[k] {
                return General {
                    lu,
                    matrix: Some(matrix),
                };
            }
            for i in k + 1..R {
                lu[i][k] /= lu[k][k];
                for j in k + 1..R {
                    lu[i][j] -= lu[i][k] * lu[k][j];
                }
            }
        }
        General { lu, matrix: None }
    }

    fn solve(&self, x: &mut [f64; R]) {
        if let Some(matrix) = &self.matrix {
            return least_squares(matrix, x);
        }
        for i in 1..R {
            for j in 0..i {
                x[i] -= self.lu[i][j] * x[j];
            }
        }
        for i in (0..R).rev() {
            for j in i + 1..R {
                x[i] -= self.lu[i][j] * x[j];
            }
            x[i] /= self.lu[i][i];
        }
    }
}

/// x ← Bᵀ(BBᵀ + εI)⁻¹x by Cholesky.
#[cold]
fn least_squares(b: &[[f64; R]; R], x: &mut [f64; R]) {
    let mut s = [[0.0; R]; R];
    for i in 0..R {
        for j in 0..R {
            s[i][j] = (0..R).map(|k| b[i][k] * b[j][k]).sum();
        }
        s[i][i] += 1e-14;
    }
    for k in 0..R {
        s[k][k] = s[k][k].sqrt();
        for i in k + 1..R {
            s[i][k] /= s[k][k];
        }
        for i in k + 1..R {
            for j in k + 1..=i {
                s[i][j] -= s[i][k] * s[j][k];
            }
        }
    }
    for i in 0..R {
        for j in 0..i {
            x[i] -= s[i][j] * x[j];
        }
        x[i] /= s[i][i];
    }
    for i in (0..R).rev() {
        for j in i + 1..R {
            x[i] -= s[j][i] * x[j];
        }
        x[i] /= s[i][i];
    }
    let y = *x;
    for (j, value) in x.iter_mut().enumerate() {
        *value = (0..R).map(|i| b[i][j] * y[i]).sum();
    }
}

fn invert(m: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let minor = |i: usize, j: usize| {
        let (r, s) = ((i + 1) % 3, (i + 2) % 3);
        let (c, d) = ((j + 1) % 3, (j + 2) % 3);
        m[r][c] * m[s][d] - m[r][d] * m[s][c]
    };
    let determinant: f64 = (0..3).map(|j| m[0][j] * minor(0, j)).sum();
    std::array::from_fn(|i| std::array::from_fn(|j| minor(j, i) / determinant))
}
