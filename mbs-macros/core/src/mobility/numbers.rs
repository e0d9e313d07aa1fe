//! The equations as numbers, and poses that fulfil them.

use super::rows::{Rows, norm};
use crate::derivatives::{Matrix, RowDerivatives};
use crate::equations::System;
use crate::model::Outline;
use crate::symbolic::{Evaluator, Expr, Graph, Symbol};

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

/// The equations as numbers, with default parameters and inputs.
#[derive(Clone, Copy)]
pub(super) struct Numbers<'a> {
    pub outline: &'a Outline,
    pub system: &'a System,
    /// All expressions, with those of the rows' derivatives.
    pub graph: &'a Graph,
    pub rows: &'a RowDerivatives,
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
    ) -> (Self, Vec<f64>) {
        let mut numbers = Numbers {
            outline,
            system,
            graph,
            rows,
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

    /// The rows of A at q, orthogonalised: those of parts first (a bar keeps its length by itself), then those of joints
    /// and conditions as declared, so that the later of two that say the same is the one called redundant.
    pub fn independent_rows(&self, q: &[f64], dependent: f64) -> Rows {
        let list = &self.system.rows;
        let matrix = self.matrix(&self.rows.jacobian, q, &[]);
        let is_part = |row: &usize| {
            self.outline
                .parts
                .iter()
                .any(|part| part.name == list[*row].entry)
        };
        let (mut order, joints): (Vec<usize>, Vec<usize>) = (0..list.len()).partition(is_part);
        order.extend(joints);
        Rows::new(order.into_iter().map(|row| (row, &matrix[row])), dependent)
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
        self.independent_rows(home, NEARLY_DEPENDENT)
            .remove_from(&mut direction);
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
            let change = self
                .independent_rows(&q, NEARLY_DEPENDENT)
                .correction(system.size, &phi);
            q = system.layout.moved(&q, &change, 1.0);
        }
        None
    }

    /// Whether a pose has left the neighbourhood of the mechanism.
    pub fn is_far(&self, q: &[f64]) -> bool {
        q.iter().any(|q| q.abs() > 1e3 * self.size)
    }
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
