//! The mechanics of an instant from the derived expressions of a declaration, without compiling it: accelerations,
//! reactions, and what does not depend on the description.

use mbs_macros_core::Analysis;
use mbs_macros_core::derivatives::Matrix;
use mbs_macros_core::symbolic::{Evaluator, Expr, Symbol};
use mbs_runtime::nalgebra::{DMatrix, DVector};
use std::collections::BTreeMap;

/// Eigenvalues of the scaled rows below this belong to rows that follow from others.
const DEPENDENT: f64 = 1e-10;
/// The time by which points are moved to differentiate their velocities, s.
const APART: f64 = 1e-4;

/// A state of a description.
pub struct Instant<'a> {
    analysis: &'a Analysis,
    q: Vec<f64>,
    v: DVector<f64>,
    acceleration: DVector<f64>,
    multipliers: DVector<f64>,
    /// The rank of A.
    pub rank: usize,
    /// The smallest eigenvalue of the scaled rows that counts: near 0 beside a singular pose.
    pub margin: f64,
}

impl<'a> Instant<'a> {
    /// At the guess, with the velocity that the forces give from rest in `time` seconds.
    pub fn after_rest(analysis: &'a Analysis, time: f64) -> Self {
        let layout = &analysis.derived.system.layout;
        let size = analysis.derived.system.size;
        let mut instant = Instant {
            analysis,
            q: vec![0.0; layout.coordinates.len()],
            v: DVector::zeros(size),
            acceleration: DVector::zeros(size),
            multipliers: DVector::zeros(analysis.derived.system.rows.len()),
            rank: 0,
            margin: 1.0,
        };
        let guess: Vec<Expr> = layout.coordinates.iter().map(|q| q.guess).collect();
        instant.q = instant.values(&guess);
        instant.solve();
        instant.v = time * &instant.acceleration;
        instant.solve();
        instant
    }

    /// v̇ and the λ of least norm.
    fn solve(&mut self) {
        let derived = &self.analysis.derived;
        let system = &derived.system;
        let (size, rows) = (system.size, system.rows.len());
        let mut mass = DMatrix::zeros(size, size);
        for (&(i, j), &entry) in &system.mass {
            (mass[(i, j)], mass[(j, i)]) = (self.value(entry), self.value(entry));
        }
        let a = self.matrix(&derived.jacobian, rows);
        let momentum_rate = self.matrix(&derived.momentum_by_position, size) * &self.v;
        let driving = DVector::from(self.values(&derived.total_forces)) - momentum_rate;
        let mass = mass.cholesky().expect("M is positive definite");
        let free = mass.solve(&driving);
        if rows == 0 {
            self.acceleration = free;
            return;
        }
        let w = mass.solve(&a.transpose());
        let missing = -DVector::from(self.values(&derived.convective)) - &a * &free;
        let delassus = &a * &w;
        let scale: Vec<f64> = (0..rows).map(|i| delassus[(i, i)].sqrt()).collect();
        let scaled = DMatrix::from_fn(rows, rows, |i, j| delassus[(i, j)] / (scale[i] * scale[j]));
        let eigen = scaled.symmetric_eigen();
        let wanted = DVector::from_fn(rows, |i, _| missing[i] / scale[i]);
        let mut parts = eigen.eigenvectors.tr_mul(&wanted);
        self.rank = 0;
        for (part, &value) in parts.iter_mut().zip(&eigen.eigenvalues) {
            let counts = value > DEPENDENT;
            self.rank += usize::from(counts);
            if counts {
                self.margin = self.margin.min(value);
            }
            *part = if counts { *part / value } else { 0.0 };
        }
        let solved = &eigen.eigenvectors * parts;
        self.multipliers = DVector::from_fn(rows, |i, _| solved[i] / scale[i]);
        self.acceleration = free + w * &self.multipliers;
    }

    /// The largest residual of the position rows.
    pub fn open(&self) -> f64 {
        let rows = self.analysis.derived.system.rows.iter();
        let rows: Vec<Expr> = rows.map(|row| row.expr).collect();
        self.values(&rows)
            .iter()
            .fold(0.0, |most, x| x.abs().max(most))
    }

    /// T, V, the power of the forces without potential, and the outputs with their rates.
    pub fn quantities(&self) -> Vec<f64> {
        let derived = &self.analysis.derived;
        let system = &derived.system;
        let mut values = self.values(&[derived.kinetic, system.potential, system.power]);
        values.extend(self.values(&system.outputs));
        let at = |s: f64| {
            let layout = &system.layout;
            let moved = Instant {
                q: layout.moved(&self.q, self.v.as_slice(), s),
                v: &self.v + s * &self.acceleration,
                acceleration: self.acceleration.clone(),
                multipliers: self.multipliers.clone(),
                ..*self
            };
            DVector::from(moved.values(&system.outputs))
        };
        let difference = |s: f64| (at(s) - at(-s)) / (2.0 * s);
        let rates = (4.0 * difference(APART) - difference(2.0 * APART)) / 3.0;
        values.extend(rates.iter());
        values
    }

    /// The reactions that are determined, by joint and component.
    pub fn reactions(&self) -> BTreeMap<String, f64> {
        let undetermined = match &self.analysis.mobility {
            Some(mobility) => &mobility.undetermined[..],
            None => &[],
        };
        let reactions = self.analysis.derived.system.reactions.iter();
        let known = reactions.filter(|reaction| !undetermined.contains(&reaction.joint));
        let named = known.map(|reaction| {
            let name = format!("{}.{}", reaction.joint, reaction.component);
            (name, self.value(reaction.expr))
        });
        named.collect()
    }

    fn matrix(&self, entries: &Matrix, rows: usize) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(rows, self.analysis.derived.system.size);
        for (&(i, j), &entry) in entries {
            matrix[(i, j)] = self.value(entry);
        }
        matrix
    }

    fn value(&self, expr: Expr) -> f64 {
        self.values(&[expr])[0]
    }

    fn values(&self, list: &[Expr]) -> Vec<f64> {
        let system = &self.analysis.derived.system;
        let symbols = |symbol: Symbol| match symbol {
            Symbol::Time => 0.0,
            Symbol::Parameter(i) => self.analysis.outline.parameters[i as usize].default,
            Symbol::Velocity(i) => self.v[i as usize],
            Symbol::Acceleration(i) => self.acceleration[i as usize],
            Symbol::Multiplier(i) => self.multipliers[i as usize],
            other => {
                let value = system.layout.value(other, &self.q);
                value.unwrap_or_else(|| panic!("{other:?} of a random mechanism"))
            }
        };
        let laws = |_: u32, _: &[f64]| unreachable!("random mechanisms have no laws");
        let mut evaluator = Evaluator::new(&system.graph, &symbols, &laws);
        list.iter().map(|&expr| evaluator.value(expr)).collect()
    }
}
