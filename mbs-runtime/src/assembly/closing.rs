//! The solution of rows and held values together, without sizes of the mechanism: compiled once.

use crate::fault::Fault;

/// Newton steps.
const MAX_ITERATIONS: usize = 80;
/// Residuals that cannot become smaller.
const ROUND_OFF: f64 = 1e-16;
/// The least damping, as a fraction of the diagonal.
const LEAST_DAMPING: f64 = 1e-14;

/// Equations linearised at a point: `values` + `rows` · change = 0, in units in which all may be compared.
pub(super) struct Linearised {
    pub(super) values: Vec<f64>,
    pub(super) rows: Vec<Vec<f64>>,
    /// M⁻¹ times the rows.
    pub(super) lifted: Vec<Vec<f64>>,
}

/// Equations for positions or velocities.
pub(super) trait Equations {
    /// At the current point.
    fn linearised(&mut self) -> Result<Linearised, Fault>;
    /// Moves the current point if this reduces the residual.
    fn moves(&mut self, way: &[f64], factor: f64, below: f64) -> bool;
}

/// Damped Newton in the metric of M until no step reduces the residual.
pub(super) fn solve(equations: &mut dyn Equations) -> Result<(), Fault> {
    for _ in 0..MAX_ITERATIONS {
        let linearised = equations.linearised()?;
        let size = norm(&linearised.values);
        if size <= ROUND_OFF || !size.is_finite() {
            return Ok(());
        }
        // Rows that depend on others in the solution are independent beside it, but nearly dependent.
        let mut damping = (size * size).clamp(LEAST_DAMPING, 1e-3);
        let mut factor = 1.0;
        let mut way = linearised.way(damping);
        while !equations.moves(&way, factor, size) {
            factor *= 0.5;
            if factor < 1e-3 && damping < 1e-3 {
                (damping, factor) = (1e-3, 1.0);
                way = linearised.way(damping);
            } else if factor < 1e-6 {
                return Ok(());
            }
        }
    }
    Ok(())
}

pub(super) fn norm(values: &[f64]) -> f64 {
    values.iter().map(|x| x * x).sum::<f64>().sqrt()
}

impl Linearised {
    /// The change that is the shortest in the metric of M, with damping: −Wᵀ (S + damping)⁻¹ values.
    fn way(&self, damping: f64) -> Vec<f64> {
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let count = self.values.len();
        let lengths: Vec<f64> = (0..count)
            .map(|i| dot(&self.rows[i], &self.lifted[i]).max(0.0).sqrt())
            .map(|length| if length > 0.0 { length } else { 1.0 })
            .collect();
        let mut matrix = vec![vec![0.0; count]; count];
        for i in 0..count {
            for j in 0..=i {
                let product = dot(&self.rows[i], &self.lifted[j]);
                matrix[i][j] = product / (lengths[i] * lengths[j]);
            }
            matrix[i][i] += damping;
        }
        let right = self.values.iter().zip(&lengths);
        let mut multipliers: Vec<f64> = right.map(|(value, length)| -value / length).collect();
        cholesky(&mut matrix, damping);
        forth_and_back(&matrix, &mut multipliers);
        let mut way = vec![0.0; self.rows.first().map_or(0, Vec::len)];
        for ((multiplier, length), row) in multipliers.iter().zip(&lengths).zip(&self.lifted) {
            for (way, x) in way.iter_mut().zip(row) {
                *way += multiplier / length * x;
            }
        }
        way
    }
}

/// L with L Lᵀ = matrix, in its lower triangle; pivots that round-off has taken are `least`.
fn cholesky(matrix: &mut [Vec<f64>], least: f64) {
    for i in 0..matrix.len() {
        for j in 0..=i {
            let (above, below) = matrix.split_at_mut(i);
            let row = &mut below[0];
            let known: f64 = match above.get(j) {
                Some(other) => (0..j).map(|k| row[k] * other[k]).sum(),
                None => (0..j).map(|k| row[k] * row[k]).sum(),
            };
            row[j] = match above.get(j) {
                Some(other) => (row[j] - known) / other[j],
                None => (row[j] - known).max(least).sqrt(),
            };
        }
    }
}

fn forth_and_back(factor: &[Vec<f64>], x: &mut [f64]) {
    for i in 0..x.len() {
        let known: f64 = (0..i).map(|k| factor[i][k] * x[k]).sum();
        x[i] = (x[i] - known) / factor[i][i];
    }
    for i in (0..x.len()).rev() {
        let known: f64 = (i + 1..x.len()).map(|k| factor[k][i] * x[k]).sum();
        x[i] = (x[i] - known) / factor[i][i];
    }
}

#[cfg(test)]
mod tests {
    use super::Linearised;

    #[test]
    fn a_row_that_is_there_twice_changes_nothing() {
        let rows = vec![vec![1.0, 2.0], vec![2.0, 4.0], vec![0.0, 1.0]];
        let linearised = Linearised {
            values: vec![3.0, 6.0, 1.0],
            lifted: rows.clone(),
            rows,
        };
        let way = linearised.way(1e-14);
        assert!(
            (way[0] + 1.0).abs() < 1e-6 && (way[1] + 1.0).abs() < 1e-6,
            "{way:?}"
        );
    }
}
