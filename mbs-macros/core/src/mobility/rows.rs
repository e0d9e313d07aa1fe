//! Rows of a matrix, orthogonalised in their order.

use std::ops::Range;

/// A row whose remainder is below this fraction of its length adds nothing.
pub(super) const DEPENDENT: f64 = 1e-9;
/// A row of which this fraction is left is square to the others up to round-off.
const MOSTLY: f64 = 0.5;

/// Rows of a matrix, orthogonalised in order: a_i = Σ_k l_ik e_k over an orthonormal basis e.
pub(super) struct Rows {
    pub basis: Vec<Direction>,
    /// The row that each basis vector came from.
    pub independent: Vec<usize>,
    /// l of the independent rows.
    lower: Vec<Vec<f64>>,
    /// Rows that add nothing, with their coefficients over the independent rows before them.
    pub dependent: Vec<(usize, Vec<f64>)>,
}

impl Rows {
    pub fn new<'a>(matrix: impl Iterator<Item = (usize, &'a Vec<f64>)>, threshold: f64) -> Rows {
        let mut rows = Rows {
            basis: Vec::new(),
            independent: Vec::new(),
            lower: Vec::new(),
            dependent: Vec::new(),
        };
        for (index, row) in matrix {
            let length = norm(row);
            let mut rest = Direction::new(row.clone());
            let mut parts = vec![0.0; rows.basis.len()];
            let mut remainder = length;
            // Twice is enough, and once if so much is left that round-off is small beside it.
            for _ in 0..2 {
                let before = remainder;
                for (part, e) in parts.iter_mut().zip(&rows.basis) {
                    *part += rest.orthogonalise(e);
                }
                remainder = norm(&rest.entries);
                if remainder > MOSTLY * before {
                    break;
                }
            }
            // Written so that NaN adds nothing.
            if !(remainder > threshold * length) {
                rows.dependent
                    .push((index, rows.coefficients(&parts, length)));
                continue;
            }
            parts.push(remainder);
            rest.entries.iter_mut().for_each(|r| *r /= remainder);
            rows.basis.push(rest);
            rows.independent.push(index);
            rows.lower.push(parts);
        }
        rows
    }

    /// c of Σ c_k a_k = Σ parts_k e_k, relative to the length of the row.
    fn coefficients(&self, parts: &[f64], length: f64) -> Vec<f64> {
        let mut c = parts.to_vec();
        for k in (0..c.len()).rev() {
            c[k] /= self.lower[k][k];
            for j in 0..k {
                c[j] -= c[k] * self.lower[k][j];
            }
        }
        let scale = if length > 0.0 { length } else { 1.0 };
        c.iter()
            .zip(&self.lower)
            .map(|(c, row)| c * norm(row) / scale)
            .collect()
    }

    /// Takes the part along the rows out of a vector.
    pub fn remove_from(&self, vector: &mut [f64]) {
        for e in &self.basis {
            e.remove_from(vector);
        }
    }

    /// An orthonormal basis of what is square to all rows.
    pub fn kernel(&self, size: usize) -> Vec<Vec<f64>> {
        let mut found: Vec<Vec<f64>> = Vec::new();
        for k in 0..size {
            let mut vector = vec![0.0; size];
            vector[k] = 1.0;
            // Twice is enough.
            for _ in 0..2 {
                self.remove_from(&mut vector);
                for known in &found {
                    let along = dot(&vector, known);
                    subtract(&mut vector, along, known);
                }
            }
            let length = norm(&vector);
            if length > 1e-6 {
                vector.iter_mut().for_each(|x| *x /= length);
                found.push(vector);
            }
        }
        found
    }

    /// −A⁺ φ over the independent holonomic rows, in velocities.
    pub fn correction(&self, size: usize, phi: &[f64]) -> Vec<f64> {
        let mut change = vec![0.0; size];
        let mut along: Vec<f64> = Vec::new();
        for (k, &row) in self.independent.iter().enumerate() {
            // Nonholonomic rows come last and have no φ.
            let Some(phi) = phi.get(row) else { break };
            let known: f64 = along.iter().zip(&self.lower[k]).map(|(x, l)| x * l).sum();
            let step = (phi - known) / self.lower[k][k];
            change
                .iter_mut()
                .zip(&self.basis[k].entries)
                .for_each(|(x, e)| *x -= step * e);
            along.push(step);
        }
        change
    }
}

/// A vector, and the range outside which it is zero: most mechanisms are chains, whose rows meet only their neighbours.
pub(super) struct Direction {
    pub entries: Vec<f64>,
    span: Range<usize>,
}

impl Direction {
    fn new(entries: Vec<f64>) -> Direction {
        // Written so that NaN is inside.
        let first = entries.iter().position(|&x| x != 0.0);
        let last = entries.iter().rposition(|&x| x != 0.0);
        let span = match (first, last) {
            (Some(first), Some(last)) => first..last + 1,
            _ => 0..0,
        };
        Direction { entries, span }
    }

    /// Removes the part along this unit vector from another, and returns the length of the part.
    fn remove_from(&self, vector: &mut [f64]) -> f64 {
        let e = &self.entries[self.span.clone()];
        let v = &mut vector[self.span.clone()];
        let along = dot(v, e);
        subtract(v, along, e);
        along
    }

    /// Removes the part along a unit vector from this one, and returns the length of the part.
    fn orthogonalise(&mut self, e: &Direction) -> f64 {
        if self.span.end <= e.span.start || e.span.end <= self.span.start {
            return 0.0;
        }
        self.span = self.span.start.min(e.span.start)..self.span.end.max(e.span.end);
        e.remove_from(&mut self.entries)
    }
}

pub(super) fn norm(x: &[f64]) -> f64 {
    dot(x, x).sqrt()
}

/// The product of vectors of the same length. Compilers run unoptimised: there an iterator takes several calls for each
/// number, an array of eight a few instructions.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let ((a, a_rest), (b, b_rest)) = (a.as_chunks::<8>(), b.as_chunks::<8>());
    let (mut sum, mut at) = (0.0, 0);
    while at < a.len() {
        let (x, y) = (&a[at], &b[at]);
        sum += (x[0] * y[0] + x[1] * y[1] + x[2] * y[2] + x[3] * y[3])
            + (x[4] * y[4] + x[5] * y[5] + x[6] * y[6] + x[7] * y[7]);
        at += 1;
    }
    let rest = a_rest.iter().zip(b_rest);
    rest.fold(sum, |sum, (a, b)| sum + a * b)
}

/// v ← v − factor · e, likewise.
fn subtract(v: &mut [f64], factor: f64, e: &[f64]) {
    let ((v, v_rest), (e, e_rest)) = (v.as_chunks_mut::<8>(), e.as_chunks::<8>());
    let mut at = 0;
    while at < v.len() {
        let (x, y) = (&mut v[at], &e[at]);
        x[0] -= factor * y[0];
        x[1] -= factor * y[1];
        x[2] -= factor * y[2];
        x[3] -= factor * y[3];
        x[4] -= factor * y[4];
        x[5] -= factor * y[5];
        x[6] -= factor * y[6];
        x[7] -= factor * y[7];
        at += 1;
    }
    for (v, e) in v_rest.iter_mut().zip(e_rest) {
        *v -= factor * e;
    }
}
