//! The equations as numbers, and poses that fulfil them.

use super::normal::{Normal, SparseRow};
use super::rows::{DEPENDENT, Rows, norm};
use crate::derivatives::{Matrix, RowDerivatives};
use crate::equations::System;
use crate::model::Outline;
use crate::symbolic::{Evaluator, Expr, Graph, Symbol};
use std::collections::HashSet;

/// Distances by which poses are moved, in units of the largest coordinate, in decreasing order: the first that can be
/// assembled counts.
const MOVES: [f64; 3] = [0.1, 0.02, 0.002];
/// In mechanisms of more velocities a long move is tried only where no coordinate moves further than the largest part is
/// long: a chain of a thousand links is as many times longer than its links, and from there assembly seldom arrives.
const MANY: usize = 200;
/// A row whose remainder is below this fraction of its length adds nothing while a pose is assembled: away from the
/// solution, redundant rows are not exactly dependent, and must be left out.
const NEARLY_DEPENDENT: f64 = 1e-3;
/// Assembly of a pose: residual to reach, and iterations to reach it in.
pub(super) const ASSEMBLED: f64 = 1e-11;
/// The unit of rows that are half the difference of two squares of lengths.
pub(super) const AREA: &str = "m^2";
const ITERATIONS: usize = 40;
/// More rows are taken by their normal equations where these serve: to orthogonalise rows of a chain takes the cube of
/// their number.
const MANY_ROWS: usize = 100;

/// The equations as numbers, with default parameters and inputs.
#[derive(Clone, Copy)]
pub(super) struct Numbers<'a> {
    pub outline: &'a Outline,
    pub system: &'a System,
    /// All expressions, with those of the rows' derivatives.
    pub graph: &'a Graph,
    pub rows: &'a RowDerivatives,
    /// The order in which rows are taken: see [`order`].
    pub order: &'a [usize],
    pub time: f64,
    /// The largest coordinate of the guess, or 1.
    pub size: f64,
    /// The largest length of the mechanism; `size` where there is none.
    pub length: f64,
}

impl<'a> Numbers<'a> {
    /// Those at t = 0, and the guess.
    pub fn new(
        outline: &'a Outline,
        system: &'a System,
        graph: &'a Graph,
        rows: &'a RowDerivatives,
        order: &'a [usize],
    ) -> (Self, Vec<f64>) {
        let mut numbers = Numbers {
            outline,
            system,
            graph,
            rows,
            order,
            time: 0.0,
            size: 1.0,
            length: 1.0,
        };
        let coordinates = &system.layout.coordinates;
        let guess = numbers.values(&[], coordinates.iter().map(|stored| stored.guess));
        let size = guess.iter().fold(0.0f64, |size, q| size.max(q.abs()));
        if size > 0.0 {
            numbers.size = size;
        }
        let places = coordinates.iter().zip(&guess);
        let places = places.filter(|(stored, _)| stored.unit == "m");
        let declared = outline.parts.iter().flat_map(|part| {
            let lengths = part.center.into_iter().chain(part.length);
            numbers.values(&[], lengths)
        });
        let lengths = places.map(|(_, &place)| place).chain(declared);
        let length = lengths.fold(0.0f64, |length, x| length.max(x.abs()));
        numbers.length = if length > 0.0 { length } else { numbers.size };
        (numbers, guess)
    }

    /// At a pose, at rest.
    pub fn values(&self, q: &[f64], exprs: impl Iterator<Item = Expr>) -> Vec<f64> {
        self.values_moving(q, &[], exprs)
    }

    /// At a pose, at rest, with a multiplier of this value on one row.
    pub fn values_loaded(
        &self,
        q: &[f64],
        load: Option<(usize, f64)>,
        exprs: impl Iterator<Item = Expr>,
    ) -> Vec<f64> {
        self.evaluated(q, &[], load, exprs)
    }

    /// At a pose with velocities.
    pub fn values_moving(
        &self,
        q: &[f64],
        v: &[f64],
        exprs: impl Iterator<Item = Expr>,
    ) -> Vec<f64> {
        self.evaluated(q, v, None, exprs)
    }

    fn evaluated(
        &self,
        q: &[f64],
        v: &[f64],
        load: Option<(usize, f64)>,
        exprs: impl Iterator<Item = Expr>,
    ) -> Vec<f64> {
        let layout = &self.system.layout;
        let symbols = |symbol: Symbol| match symbol {
            Symbol::Parameter(i) => self.outline.parameters[i as usize].default,
            Symbol::Input(i) => self.outline.inputs[i as usize].default,
            Symbol::Time => self.time,
            Symbol::Velocity(i) => v.get(i as usize).copied().unwrap_or(0.0),
            Symbol::Multiplier(i) => match load {
                Some((row, value)) if row == i as usize => value,
                _ => 0.0,
            },
            other => layout.value(other, q).unwrap_or(0.0),
        };
        // Laws are refused in rows.
        let laws = |_: u32, _: &[f64]| (0.0, Vec::new());
        let mut evaluator = Evaluator::new(self.graph, &symbols, &laws);
        exprs.map(|expr| evaluator.value(expr)).collect()
    }

    /// The rows of A at q, orthogonalised in their order.
    pub fn independent_rows(&self, q: &[f64], dependent: f64) -> Rows {
        let matrix = self.matrix(&self.rows.jacobian, q, &[]);
        let order = self.order.iter();
        Rows::new(order.map(|&row| (row, &matrix[row])), dependent)
    }

    /// The normal equations of the first rows of A, in the same order; `None` where rows are few or not sparse.
    fn normal(&self, q: &[f64], count: usize) -> Option<Normal> {
        if count <= MANY_ROWS {
            return None;
        }
        let mut rows: Vec<SparseRow> = vec![Vec::new(); count];
        let entries = self.rows.jacobian.iter();
        let entries = entries.filter(|((row, _), _)| *row < count);
        let (places, entries): (Vec<_>, Vec<_>) = entries.unzip();
        let values = self.values(q, entries.into_iter().copied());
        for (&(row, column), value) in places.into_iter().zip(values) {
            rows[row].push((column, value));
        }
        let order = self.order.iter().copied().filter(|&row| row < count);
        let rows = order.map(|row| (row, std::mem::take(&mut rows[row])));
        Normal::new(rows.collect(), NEARLY_DEPENDENT)
    }

    /// Which rows are independent at q.
    pub fn dependencies(&self, q: &[f64]) -> Dependencies {
        let count = self.system.rows.len();
        if self
            .normal(q, count)
            .is_some_and(|normal| normal.is_regular())
        {
            return Dependencies {
                independent: (0..count).collect(),
                dependent: Vec::new(),
            };
        }
        let rows = self.independent_rows(q, DEPENDENT);
        Dependencies {
            independent: rows.independent,
            dependent: rows.dependent,
        }
    }

    /// Takes what the rows forbid out of velocities.
    fn free(&self, q: &[f64], direction: &mut [f64]) {
        match self.normal(q, self.system.rows.len()) {
            Some(normal) => normal.remove_from(direction),
            None => {
                let rows = self.independent_rows(q, NEARLY_DEPENDENT);
                rows.remove_from(direction);
            }
        }
    }

    /// The least change of q, in velocities, that takes a residual away.
    fn correction(&self, q: &[f64], phi: &[f64]) -> Vec<f64> {
        let size = self.system.size;
        match self.normal(q, phi.len()) {
            Some(normal) => normal.correction(size, phi),
            None => {
                let rows = self.independent_rows(q, NEARLY_DEPENDENT);
                rows.correction(size, phi)
            }
        }
    }

    /// A matrix of as many rows as A.
    pub fn matrix(&self, matrix: &Matrix, q: &[f64], v: &[f64]) -> Vec<Vec<f64>> {
        let system = self.system;
        let mut dense = vec![vec![0.0; system.size]; system.rows.len()];
        let values = self.values_moving(q, v, matrix.values().copied());
        for (&(i, j), value) in matrix.keys().zip(values) {
            dense[i][j] = value;
        }
        dense
    }

    /// φ of the holonomic rows.
    pub fn residual(&self, q: &[f64]) -> Vec<f64> {
        let rows = &self.system.rows[..self.system.holonomic_rows()];
        self.values(q, rows.iter().map(|row| row.expr))
    }

    /// The residual, each row in units of what is large for it.
    pub fn relative(&self, phi: &[f64]) -> Vec<f64> {
        let rows = phi.iter().zip(&self.system.rows);
        let relative = rows.map(|(phi, row)| match row.unit.as_str() {
            "m" => phi / self.length,
            AREA => phi / (self.length * self.length),
            // An angle is of order 1 in mechanisms of any size, and its rounding, too.
            _ => phi / self.size.max(1.0),
        });
        relative.collect()
    }

    /// Whether a residual counts as zero.
    pub fn assembled(&self, phi: &[f64]) -> bool {
        largest(&self.relative(phi)) <= ASSEMBLED
    }

    /// A pose on the branch of `home`: moved at random along what the rows leave free, and assembled again.
    pub fn generic_pose(&self, home: &[f64], seed: u64) -> Option<Vec<f64>> {
        let mut random = Random(seed + 1);
        let count = self.system.size;
        let mut direction: Vec<f64> = (0..count).map(|_| random.next()).collect();
        self.free(home, &mut direction);
        let length = norm(&direction);
        if length < 1e-6 {
            return None;
        }
        let furthest = largest(&direction) / length;
        let reach = self.longest_part();
        MOVES.iter().enumerate().find_map(|(nth, distance)| {
            let is_last = nth + 1 == MOVES.len();
            if count > MANY && !is_last && furthest * distance * self.size > reach {
                return None;
            }
            let step = distance * self.size / length;
            let layout = &self.system.layout;
            let moved = layout.moved(home, &direction, step);
            let arrived = self.assemble(moved.clone())?;
            let strayed: Vec<f64> = arrived.iter().zip(&moved).map(|(a, b)| a - b).collect();
            (norm(&strayed) < 0.5 * distance * self.size).then_some(arrived)
        })
    }

    /// The largest length that a part has.
    fn longest_part(&self) -> f64 {
        let lengths = self.outline.parts.iter().filter_map(|part| part.length);
        largest(&self.values(&[], lengths))
    }

    /// Gauss–Newton steps of least change onto φ = 0.
    pub fn assemble(&self, mut q: Vec<f64>) -> Option<Vec<f64>> {
        let system = self.system;
        for _ in 0..ITERATIONS {
            let phi = self.residual(&q);
            if !largest(&phi).is_finite() || self.is_far(&q) {
                return None;
            }
            if self.assembled(&phi) {
                return Some(q);
            }
            let change = self.correction(&q, &phi);
            q = system.layout.moved(&q, &change, 1.0);
        }
        None
    }

    /// Whether a pose has left the neighbourhood of the mechanism.
    pub fn is_far(&self, q: &[f64]) -> bool {
        q.iter().any(|q| q.abs() > 1e3 * self.size)
    }
}

/// The rows of parts first (a bar keeps its length by itself), then those of joints and conditions as declared, so that
/// the later of two that say the same is the one called redundant.
pub(super) fn order(outline: &Outline, system: &System) -> Vec<usize> {
    let parts = outline.parts.iter().map(|part| part.name.as_str());
    let parts: HashSet<&str> = parts.collect();
    let list = &system.rows;
    let is_part = |row: &usize| parts.contains(list[*row].entry.as_str());
    let (mut order, joints): (Vec<usize>, Vec<usize>) = (0..list.len()).partition(is_part);
    order.extend(joints);
    order
}

/// Which rows depend on those before them.
pub(super) struct Dependencies {
    /// The others, in the order in which they were looked at.
    pub independent: Vec<usize>,
    /// Rows that depend, with their coefficients over the independent rows before them.
    pub dependent: Vec<(usize, Vec<f64>)>,
}

/// max |x|; NaN if one of them is.
pub(super) fn largest(x: &[f64]) -> f64 {
    match x.iter().any(|x| x.is_nan()) {
        true => f64::NAN,
        false => x.iter().fold(0.0, |worst, x| worst.max(x.abs())),
    }
}

/// Numbers between −1 and 1, the same at every compilation (SplitMix64).
pub(super) struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}
