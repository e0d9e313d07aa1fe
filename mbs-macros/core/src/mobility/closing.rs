//! A guess that could not be assembled: is there a pose at all?
//!
//! The squared residual ½|φ|² is minimised (Levenberg–Marquardt) from the guess and from poses all around it. If every
//! descent ends where the gradient vanishes and the residual does not, and the lowest of these minima is found more
//! than once, the rows contradict each other, and the largest residuals show which rows. Otherwise the decision is left
//! to assembly at run time.

use super::numbers::{AREA, ASSEMBLED, Numbers, Random, largest};
use super::rows::norm;

/// Descents besides the one from the guess.
const STARTS: u64 = 8;
/// Steps of one descent.
const STEPS: usize = 150;
/// Multiplications of all descents, at most: with more of them the compiler would seem to hang. (A mechanism of a hundred coordinates
/// takes less with all its descents; one of a thousand takes a step.)
const WORK: f64 = 3e8;
/// A gradient below this fraction of |A| |φ| vanishes.
const STATIONARY: f64 = 1e-7;
/// A residual above this, in units of what is large for its rows, is clearly not zero.
const CLEARLY_OPEN: f64 = 1e-4;
/// Rows are named if they are open by more than this fraction of the worst.
const NAMED: f64 = 0.1;
/// Names in a message.
const NAMES: usize = 4;

/// Rows that cannot be fulfilled together.
#[derive(Debug, Clone, PartialEq)]
pub struct Open {
    /// The entry at which the error is reported.
    pub entry: String,
    /// By how much they are open where they are closest to being fulfilled, in words, the worst first.
    pub gaps: Vec<String>,
}

/// Where a descent has ended.
enum End {
    Closed(Vec<f64>),
    Stationary(Vec<f64>),
    Underway,
}

/// A pose that fulfils all rows, next to the guess; `None` if it stays uncertain whether there is one.
pub(super) fn close(numbers: &Numbers, guess: Vec<f64>) -> Result<Option<Vec<f64>>, Open> {
    let mut ends: Vec<(f64, Vec<f64>)> = Vec::new();
    let mut start = guess.clone();
    let mut work = 0.0;
    for seed in 0..=STARTS {
        match descend(numbers, start, &mut work) {
            End::Closed(pose) if seed == 0 => return Ok(Some(pose)),
            End::Closed(_) | End::Underway => return Ok(None),
            End::Stationary(pose) => {
                let size = norm(&numbers.relative(&numbers.residual(&pose)));
                if !(size > CLEARLY_OPEN) {
                    return Ok(None);
                }
                ends.push((size, pose));
            }
        }
        start = anywhere(numbers, &guess, seed);
    }
    ends.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    match ends.as_slice() {
        [(lowest, pose), (second, _), ..] if *second < 1.01 * lowest => {
            Err(describe(numbers, pose))
        }
        _ => Ok(None),
    }
}

/// A random pose of the size of the guess.
fn anywhere(numbers: &Numbers, guess: &[f64], seed: u64) -> Vec<f64> {
    let layout = &numbers.system.layout;
    let mut random = Random(seed + 101);
    let mut change = vec![0.0; layout.velocities.len()];
    for (change, velocity) in change.iter_mut().zip(&layout.velocities) {
        let scale = match velocity.unit.as_str() {
            "rad/s" => 3.0,
            _ => 1.5 * numbers.size,
        };
        *change = scale * random.next();
    }
    layout.moved(guess, &change, 1.0)
}

/// `work`: the multiplications so far.
fn descend(numbers: &Numbers, mut q: Vec<f64>, work: &mut f64) -> End {
    let system = numbers.system;
    let mut phi = numbers.residual(&q);
    let mut damping = 1e-3;
    for _ in 0..STEPS {
        if numbers.assembled(&phi) {
            return End::Closed(q);
        }
        let mut a = numbers.matrix(&numbers.rows.jacobian, &q, &[]);
        a.truncate(phi.len());
        let gradient = transposed(&a, &phi, system.size);
        let scale = norm(&a.concat()) * norm(&phi);
        if norm(&gradient) <= STATIONARY * scale {
            // Near a solution the gradient is small, too.
            return match largest(&numbers.relative(&phi)) > 1e3 * ASSEMBLED {
                true => End::Stationary(q),
                false => End::Underway,
            };
        }
        let weight = norm(&a.concat()).powi(2) / phi.len().max(1) as f64;
        loop {
            *work += (system.size as f64).powi(3) / 6.0;
            if *work > WORK {
                return End::Underway;
            }
            let step = damped_step(&a, &gradient, damping * weight);
            let next = step.map(|step| system.layout.moved(&q, &step, -1.0));
            let better = next.and_then(|next| {
                let residual = numbers.residual(&next);
                (norm(&residual) < norm(&phi)).then_some((next, residual))
            });
            if let Some((next, residual)) = better {
                (q, phi) = (next, residual);
                damping = (0.2 * damping).max(1e-12);
                break;
            }
            damping *= 10.0;
            if !(damping < 1e6) {
                return End::Underway;
            }
        }
        if numbers.is_far(&q) {
            return End::Underway;
        }
    }
    End::Underway
}

/// Aᵀ φ.
fn transposed(a: &[Vec<f64>], phi: &[f64], size: usize) -> Vec<f64> {
    let mut sum = vec![0.0; size];
    for (row, phi) in a.iter().zip(phi) {
        sum.iter_mut().zip(row).for_each(|(s, x)| *s += x * phi);
    }
    sum
}

/// (AᵀA + μ 1)⁻¹ g, by Cholesky.
fn damped_step(a: &[Vec<f64>], gradient: &[f64], damping: f64) -> Option<Vec<f64>> {
    let size = gradient.len();
    let mut lower = vec![vec![0.0; size]; size];
    for row in a {
        for (i, x) in row.iter().enumerate().filter(|(_, x)| **x != 0.0) {
            for (sum, y) in lower[i].iter_mut().zip(&row[..=i]) {
                *sum += x * y;
            }
        }
    }
    for i in 0..size {
        lower[i][i] += damping;
        for j in 0..=i {
            let known: f64 = (0..j).map(|k| lower[i][k] * lower[j][k]).sum();
            let rest = lower[i][j] - known;
            lower[i][j] = match i == j {
                true if rest > 0.0 => rest.sqrt(),
                true => return None,
                false => rest / lower[j][j],
            };
        }
    }
    let mut x = gradient.to_vec();
    for i in 0..size {
        let known: f64 = (0..i).map(|k| lower[i][k] * x[k]).sum();
        x[i] = (x[i] - known) / lower[i][i];
    }
    for i in (0..size).rev() {
        let known: f64 = (i + 1..size).map(|k| lower[k][i] * x[k]).sum();
        x[i] = (x[i] - known) / lower[i][i];
    }
    Some(x)
}

fn describe(numbers: &Numbers, pose: &[f64]) -> Open {
    let rows = &numbers.system.rows;
    let a = numbers.matrix(&numbers.rows.jacobian, pose, &[]);
    let phi = numbers.residual(pose);
    let mut gaps: Vec<(f64, usize, &str)> = phi
        .iter()
        .enumerate()
        .map(|(row, &phi)| match rows[row].unit.as_str() {
            AREA => (length_gap(numbers, row, phi, norm(&a[row])), row, "m"),
            unit => (phi.abs(), row, unit),
        })
        .collect();
    gaps.sort_by(|(a, ..), (b, ..)| b.total_cmp(a));
    let worst = gaps.first().map_or(0.0, |(gap, ..)| *gap);
    gaps.retain(|(gap, ..)| *gap > NAMED * worst);
    gaps.truncate(NAMES);
    // Of two rows that contradict each other the later one is reported, and a joint rather than a bar.
    let parts = &numbers.outline.parts;
    let is_joint = |row: usize| parts.iter().all(|part| part.name != rows[row].entry);
    let named = gaps.iter().map(|&(_, row, _)| row);
    let blamed = named.clone().filter(|&row| is_joint(row)).max();
    let blamed = blamed.or_else(|| named.clone().next());
    let entry = blamed.map(|row| rows[row].entry.clone());
    let gaps = gaps.into_iter().map(|(gap, row, unit)| {
        let text = format!("`{}` by {gap:.3} {unit}", rows[row].name);
        text.trim_end().to_owned()
    });
    Open {
        entry: entry.unwrap_or_default(),
        gaps: gaps.collect(),
    }
}

/// What a length lacks whose row is half the difference of squares, φ = ½ (d² − L²): d − L for a bar, else φ over its slope.
fn length_gap(numbers: &Numbers, row: usize, phi: f64, slope: f64) -> f64 {
    let entry = &numbers.system.rows[row].entry;
    let parts = &numbers.outline.parts;
    let bar = parts.iter().find(|part| part.name == *entry);
    let length = bar.and_then(|part| numbers.values(&[], part.length.into_iter()).pop());
    match length {
        Some(length) => ((length * length + 2.0 * phi).max(0.0).sqrt() - length).abs(),
        None if slope > 0.0 => (phi / slope).abs(),
        None => phi.abs().sqrt(),
    }
}
