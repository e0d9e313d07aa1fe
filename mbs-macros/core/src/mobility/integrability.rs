//! Integrable nonholonomic rows: Frobenius' test.
//!
//! A row N v + n = 0 is a differential form θ = N_k σ^k + n dt, where σ^k are the forms of the velocities: dq for
//! translations, and for a rotation those of the angular velocity in body axes, whose fields have the brackets of so(3),
//! [E_x, E_y] = E_z. Along the motions that all rows of a set leave free, D = {u : θ^r(u) = 0}, the row is integrable if
//!
//! dθ(u, w) = ∂_u N · w + ∂_u n w_t − ∂_w N · u − ∂_w n u_t − N · [u, w] = 0 for all u, w in D.
//!
//! The derivatives along u are the rate of A with the velocities u. dθ = 0 holds by itself for holonomic rows. So the
//! largest set is built from them: rows that are integrable with those found so far are added until there is none, and
//! finally the rest is tested as a whole. Tested at several poses, on the branch of the guess, at different times where
//! time appears.

use super::numbers::Numbers;
use super::rows::{DEPENDENT, Rows, norm};

/// dθ below this fraction of its terms is zero.
const CLOSED: f64 = 1e-9;

/// The nonholonomic rows that are integrable together with the holonomic ones.
pub(super) fn integrable(numbers: &Numbers, poses: &[Vec<f64>]) -> Vec<usize> {
    let system = numbers.system;
    let (holonomic, count) = (system.holonomic_rows(), system.rows.len());
    if holonomic == count {
        return Vec::new();
    }
    let points: Vec<Forms> = poses
        .iter()
        .enumerate()
        .filter_map(|(index, pose)| {
            let timed = Numbers {
                time: 0.17 * (index + 1) as f64,
                ..*numbers
            };
            // At another time drives have moved, and the pose is assembled again.
            Some(Forms::new(&timed, timed.assemble(pose.clone())?))
        })
        .collect();
    if points.is_empty() {
        return Vec::new();
    }
    let closed =
        |set: &[usize], added: &[usize]| points.iter().all(|forms| forms.are_closed(set, added));
    let mut set: Vec<usize> = (0..holonomic).collect();
    let mut waiting: Vec<usize> = (holonomic..count).collect();
    loop {
        let next = waiting.iter().position(|&row| {
            let mut with = set.clone();
            with.push(row);
            closed(&with, &[row])
        });
        match next {
            Some(next) => set.push(waiting.remove(next)),
            None => break,
        }
    }
    if !waiting.is_empty() {
        let all: Vec<usize> = set.iter().chain(&waiting).copied().collect();
        if closed(&all, &waiting) {
            set = all;
        }
    }
    set.split_off(holonomic)
}

/// The rows at one pose as forms over (v, dt).
struct Forms<'a> {
    numbers: Numbers<'a>,
    pose: Vec<f64>,
    /// (N, n) of each row.
    rows: Vec<Vec<f64>>,
}

impl<'a> Forms<'a> {
    fn new(numbers: &Numbers<'a>, pose: Vec<f64>) -> Self {
        let derived = numbers.rows;
        let mut rows = numbers.matrix(&derived.jacobian, &pose, &[]);
        let rheonomic = numbers.values(&pose, derived.rheonomic.iter().copied());
        for (row, n) in rows.iter_mut().zip(rheonomic) {
            row.push(n);
        }
        Forms {
            numbers: *numbers,
            pose,
            rows,
        }
    }

    /// Whether dθ of the rows `added` vanishes along all that the rows `set` leave free.
    fn are_closed(&self, set: &[usize], added: &[usize]) -> bool {
        let rows = set.iter().map(|&row| (row, &self.rows[row]));
        let size = self.numbers.system.size;
        let free = Rows::new(rows, DEPENDENT).kernel(size + 1);
        // The derivatives of (N, n) along each free motion.
        let slopes: Vec<Vec<Vec<f64>>> = free.iter().map(|u| self.slopes(u)).collect();
        (0..free.len()).all(|i| {
            (0..i).all(|j| {
                let bracket = self.bracket(&free[i], &free[j]);
                added.iter().all(|&row| {
                    let terms = [
                        dot(&slopes[i][row], &free[j]),
                        -dot(&slopes[j][row], &free[i]),
                        -dot(&self.rows[row], &bracket),
                    ];
                    let size = norm(&slopes[i][row])
                        + norm(&slopes[j][row])
                        + norm(&self.rows[row]) * norm(&bracket);
                    // Written so that NaN is not closed.
                    terms.iter().sum::<f64>().abs() <= CLOSED * size.max(1e-12)
                })
            })
        })
    }

    /// ∂_u (N, n) of all rows, from rates, of which the part that time alone causes counts as much as u_t says.
    fn slopes(&self, u: &[f64]) -> Vec<Vec<f64>> {
        let size = self.numbers.system.size;
        let (moving, resting) = (self.rates(&u[..size]), self.rates(&vec![0.0; size]));
        let by_time = u[size] - 1.0;
        let mut slopes = moving;
        for (row, rest) in slopes.iter_mut().zip(&resting) {
            row.iter_mut()
                .zip(rest)
                .for_each(|(x, rest)| *x += by_time * rest);
        }
        slopes
    }

    /// d/dt of (N, n) with velocities v; ṅ is γ without Ȧ v.
    fn rates(&self, v: &[f64]) -> Vec<Vec<f64>> {
        let derived = self.numbers.rows;
        let mut rates = self.numbers.matrix(&derived.jacobian_rate, &self.pose, v);
        let convective = derived.convective.iter().copied();
        let convective = self.numbers.values_moving(&self.pose, v, convective);
        for (row, gamma) in rates.iter_mut().zip(convective) {
            row.push(gamma - dot(row, v));
        }
        rates
    }

    /// [u, w] of fields with these constant components: the structure constants of rotations.
    fn bracket(&self, u: &[f64], w: &[f64]) -> Vec<f64> {
        let mut bracket = vec![0.0; u.len()];
        for rotation in &self.numbers.system.layout.rotations {
            let first = rotation.velocity;
            for k in 0..3 {
                let (i, j) = (first + (k + 1) % 3, first + (k + 2) % 3);
                bracket[first + k] = u[i] * w[j] - u[j] * w[i];
            }
        }
        bracket
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
