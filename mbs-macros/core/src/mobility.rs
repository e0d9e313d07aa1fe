//! Rank, mobility, and the redundant rows by name: what only numbers can tell, told at compile time.
//!
//! Between stages 4 and 5 the constraint Jacobian A is evaluated by the interpreter at a few poses near the declared
//! guess, with default parameters. The guess is assembled, then moved at random along what its rows leave free, and
//! assembled again: so the poses stay on the branch of the guess, and a guess that happens to be singular does not count
//! for the mechanism. Rows are orthogonalised in their order: one that adds nothing to those
//! before it is redundant, and the coefficients say on which of them it depends. (A parameter that tilts an axis can change
//! the rank; assembly at run time repeats the check.)

use crate::derivatives::Derived;
use crate::model::Model;
use crate::symbolic::{Evaluator, Expr, Symbol};
use std::ops::Range;

/// How far poses are moved, in units of the largest coordinate, from bold to timid: the first that arrives counts.
const MOVES: [f64; 3] = [0.1, 0.02, 0.002];
/// Poses to look at.
const POSES: u64 = 3;
/// A row whose remainder is below this fraction of its length adds nothing.
const DEPENDENT: f64 = 1e-9;
/// The same while a pose is assembled: off the solution, redundant rows differ a little from those they follow from, and
/// must not be forced.
const NEARLY_DEPENDENT: f64 = 1e-3;
/// A row depends on those before it whose coefficient exceeds this.
const INVOLVED: f64 = 1e-7;
/// Assembly of a pose: residual to reach, and iterations to reach it in.
const ASSEMBLED: f64 = 1e-11;
const ITERATIONS: usize = 40;

/// What the rows leave free.
#[derive(Debug, Clone, PartialEq)]
pub struct Mobility {
    /// Rank of A at generic poses.
    pub rank: usize,
    /// Degrees of freedom: coordinates less rank.
    pub mobility: usize,
    /// Rows that follow from others.
    pub redundant: Vec<Redundancy>,
}

/// A row that follows from others.
#[derive(Debug, Clone, PartialEq)]
pub struct Redundancy {
    /// The row.
    pub row: usize,
    /// Entries of the declaration whose rows it follows from.
    pub follows_from: Vec<String>,
}

/// The mobility of a mechanism; `None` if no pose near the guess could be assembled.
pub fn analyse(model: &Model, derived: &Derived) -> Option<Mobility> {
    let system = &derived.system;
    if system.rows.is_empty() {
        return Some(Mobility {
            rank: 0,
            mobility: system.size,
            redundant: Vec::new(),
        });
    }
    let numbers = Numbers { model, derived };
    let guess: Vec<f64> = numbers.values(
        &[],
        system.layout.coordinates.iter().map(|stored| stored.guess),
    );
    let size = guess.iter().fold(0.0f64, |size, q| size.max(q.abs()));
    let size = if size > 0.0 { size } else { 1.0 };
    let home = numbers.assemble(guess, size)?;
    let moved = (0..POSES).filter_map(|seed| numbers.generic_pose(&home, size, seed));
    // Along a branch rank is lost by accident only: the pose of the highest rank is the generic one. (A mechanism that
    // cannot move has no other pose than its home.)
    let poses = moved.chain([home.clone()]);
    let rows = poses
        .map(|pose| numbers.rows(&pose, DEPENDENT))
        .max_by_key(|rows| rows.basis.len())?;
    let rank = rows.basis.len();
    let redundant = rows
        .dependent
        .iter()
        .map(|(row, coefficients)| {
            let mut follows_from: Vec<String> = Vec::new();
            for (&other, _) in rows
                .independent
                .iter()
                .zip(coefficients)
                .filter(|(_, c)| c.abs() > INVOLVED)
            {
                let entry = &system.rows[other].entry;
                if !follows_from.contains(entry) {
                    follows_from.push(entry.clone());
                }
            }
            Redundancy {
                row: *row,
                follows_from,
            }
        })
        .collect();
    Some(Mobility {
        rank,
        mobility: system.size.saturating_sub(rank),
        redundant,
    })
}

/// The equations as numbers, with default parameters and inputs, at t = 0.
struct Numbers<'a> {
    model: &'a Model,
    derived: &'a Derived,
}

impl Numbers<'_> {
    fn values(&self, q: &[f64], exprs: impl Iterator<Item = Expr>) -> Vec<f64> {
        let layout = &self.derived.system.layout;
        let symbols = |symbol: Symbol| match symbol {
            Symbol::Parameter(i) => self.model.parameters[i as usize].default,
            Symbol::Input(i) => self.model.inputs[i as usize].default,
            other => layout.value(other, q).unwrap_or(0.0),
        };
        // Laws are refused in rows.
        let laws = |_: u32, _: &[f64]| (0.0, Vec::new());
        let mut evaluator = Evaluator::new(&self.derived.system.graph, &symbols, &laws);
        exprs.map(|expr| evaluator.value(expr)).collect()
    }

    /// The rows of A at q, orthogonalised: those of parts first (a bar keeps its length by itself), then those of joints
    /// and conditions as declared, so that the later of two that say the same is the one called redundant.
    fn rows(&self, q: &[f64], dependent: f64) -> Rows {
        let jacobian = &self.derived.jacobian;
        let list = &self.derived.system.rows;
        let mut matrix = vec![vec![0.0; self.derived.system.size]; list.len()];
        for (&(i, j), value) in jacobian
            .keys()
            .zip(self.values(q, jacobian.values().copied()))
        {
            matrix[i][j] = value;
        }
        let is_part = |row: &usize| {
            self.model
                .parts
                .iter()
                .any(|part| part.name == list[*row].entry)
        };
        let (mut order, joints): (Vec<usize>, Vec<usize>) = (0..list.len()).partition(is_part);
        order.extend(joints);
        Rows::new(order.into_iter().map(|row| (row, &matrix[row])), dependent)
    }

    /// A pose on the branch of `home`: moved at random along what the rows leave free, and assembled again.
    fn generic_pose(&self, home: &[f64], size: f64, seed: u64) -> Option<Vec<f64>> {
        let mut random = Random(seed + 1);
        let count = self.derived.system.size;
        let mut direction: Vec<f64> = (0..count).map(|_| random.next()).collect();
        self.rows(home, NEARLY_DEPENDENT)
            .remove_from(&mut direction);
        let length = norm(&direction);
        if length < 1e-6 {
            return None;
        }
        MOVES.iter().find_map(|distance| {
            let step = distance * size / length;
            let layout = &self.derived.system.layout;
            let moved = layout.moved(home, &direction, step);
            let arrived = self.assemble(moved.clone(), size)?;
            let strayed: Vec<f64> = arrived.iter().zip(&moved).map(|(a, b)| a - b).collect();
            (norm(&strayed) < 0.5 * distance * size).then_some(arrived)
        })
    }

    /// Gauss–Newton steps of least change onto φ = 0.
    fn assemble(&self, mut q: Vec<f64>, size: f64) -> Option<Vec<f64>> {
        let system = &self.derived.system;
        let holonomic = system.holonomic_rows();
        for _ in 0..ITERATIONS {
            let phi = self.values(&q, system.rows[..holonomic].iter().map(|row| row.expr));
            let residual = phi.iter().fold(0.0f64, |worst, phi| worst.max(phi.abs()));
            if !residual.is_finite() || q.iter().any(|q| q.abs() > 1e3 * size) {
                return None;
            }
            if residual <= ASSEMBLED * size.max(1e-3) {
                return Some(q);
            }
            let change = self
                .rows(&q, NEARLY_DEPENDENT)
                .correction(system.size, &phi);
            q = system.layout.moved(&q, &change, 1.0);
        }
        None
    }
}

/// Rows of a matrix, orthogonalised in order: a_i = Σ_k l_ik e_k over an orthonormal basis e.
struct Rows {
    basis: Vec<Direction>,
    /// The row that each basis vector came from.
    independent: Vec<usize>,
    /// l of the independent rows.
    lower: Vec<Vec<f64>>,
    /// Rows that add nothing, with their coefficients over the independent rows before them.
    dependent: Vec<(usize, Vec<f64>)>,
}

impl Rows {
    fn new<'a>(matrix: impl Iterator<Item = (usize, &'a Vec<f64>)>, threshold: f64) -> Rows {
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
            // Twice is enough.
            for _ in 0..2 {
                for (part, e) in parts.iter_mut().zip(&rows.basis) {
                    *part += rest.orthogonalise(e);
                }
            }
            let remainder = norm(&rest.entries);
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
    fn remove_from(&self, vector: &mut [f64]) {
        for e in &self.basis {
            e.remove_from(vector);
        }
    }

    /// −A⁺ φ over the independent holonomic rows, in velocities.
    fn correction(&self, size: usize, phi: &[f64]) -> Vec<f64> {
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
struct Direction {
    entries: Vec<f64>,
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

    /// Takes the part along this unit vector out of another, and tells how long it was.
    fn remove_from(&self, vector: &mut [f64]) -> f64 {
        let e = &self.entries[self.span.clone()];
        let v = &mut vector[self.span.clone()];
        let along: f64 = v.iter().zip(e).map(|(v, e)| v * e).sum();
        v.iter_mut().zip(e).for_each(|(v, e)| *v -= along * e);
        along
    }

    /// Takes the part along a unit vector out of this one, and tells how long it was.
    fn orthogonalise(&mut self, e: &Direction) -> f64 {
        if self.span.end <= e.span.start || e.span.end <= self.span.start {
            return 0.0;
        }
        self.span = self.span.start.min(e.span.start)..self.span.end.max(e.span.end);
        e.remove_from(&mut self.entries)
    }
}

fn norm(x: &[f64]) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Numbers between −1 and 1, the same at every compilation (SplitMix64).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}
