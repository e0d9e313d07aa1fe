//! Symmetric positive definite matrices of known pattern, factored in straight-line code.
//!
//! S = L D Lᵀ in an order chosen at compile time: the row with the fewest neighbours goes first, so that little is
//! filled in. Rows that depend on those before them are left out. (For the mass matrix of a tree this goes from the
//! leaves to the root and fills in nothing.)

use super::lower::Lowering;
use super::{Operand, Operation};
use crate::symbolic::Symbol;
use std::collections::{BTreeMap, BTreeSet};

/// The entries of a symmetric matrix on and above its diagonal; what is absent is zero.
pub(super) type Upper = BTreeMap<(usize, usize), Operand>;

/// A vector without its zeros.
pub(super) type Sparse = BTreeMap<usize, Operand>;

/// What is known of a matrix.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Rank {
    /// It is positive definite.
    Full,
    /// Rows can depend on those before them: they are passed over, and their unknowns are 0.
    MayBeLost,
}

/// L and D.
pub(super) struct Factor {
    /// Rows in the order of their elimination.
    order: Vec<usize>,
    /// D⁻¹, by row.
    inverse: Vec<Operand>,
    /// The diagonal before the elimination.
    diagonal: Vec<Operand>,
    /// Whether the pivot is still that.
    untouched: Vec<bool>,
    /// Column k of L below its unit diagonal: (row, entry).
    columns: Vec<Vec<(usize, Operand)>>,
}

fn key(i: usize, j: usize) -> (usize, usize) {
    (i.min(j), i.max(j))
}

impl Factor {
    /// Factors a matrix; `name` is what its pivots are called.
    pub(super) fn new(
        code: &mut Lowering,
        size: usize,
        mut entries: Upper,
        rank: Rank,
        name: &str,
    ) -> Factor {
        let mut left: Vec<usize> = (0..size).collect();
        let zero = Operand::number(0.0);
        let diagonal: Vec<Operand> = (0..size)
            .map(|k| entries.get(&(k, k)).copied().unwrap_or(zero))
            .collect();
        let mut factor = Factor {
            order: Vec::new(),
            inverse: vec![zero; size],
            untouched: vec![false; size],
            diagonal,
            columns: vec![Vec::new(); size],
        };
        // Of each row that is left the others that are left and have an entry in it.
        let mut neighbours = vec![BTreeSet::new(); size];
        for &(i, j) in entries.keys().filter(|(i, j)| i != j) {
            neighbours[i].insert(j);
            neighbours[j].insert(i);
        }
        while !left.is_empty() {
            // The first of those with the fewest neighbours.
            let place = (0..left.len())
                .min_by_key(|&place| neighbours[left[place]].len())
                .unwrap_or(0);
            let k = left.remove(place);
            let others: Vec<usize> = std::mem::take(&mut neighbours[k]).into_iter().collect();
            for &i in &others {
                neighbours[i].remove(&k);
                neighbours[i].extend(others.iter().filter(|&&j| j != i));
            }
            factor.order.push(k);
            let pivot = entries.get(&(k, k)).copied().unwrap_or(zero);
            code.name(pivot, || format!("{name}_{k}"));
            factor.untouched[k] = pivot == factor.diagonal[k];
            factor.inverse[k] = match rank {
                Rank::Full => code.reciprocal(pivot),
                Rank::MayBeLost => code.pivot_inverse(pivot, factor.diagonal[k]),
            };
            for (place, &i) in others.iter().enumerate() {
                let across = entries[&key(i, k)];
                let scaled = code.times(across, factor.inverse[k]);
                factor.columns[k].push((i, scaled));
                for &j in &others[place..] {
                    let change = code.times(scaled, entries[&key(j, k)]);
                    let entry = entries.entry(key(i, j)).or_insert(zero);
                    *entry = code.less(*entry, change);
                }
            }
        }
        factor
    }

    /// What a pivot began with, divided by it: 1 where a row is orthogonal to those before it.
    pub(super) fn pivot_loss(&self, code: &mut Lowering, k: usize) -> Operand {
        if self.untouched[k] {
            return Operand::number(1.0);
        }
        code.times(self.diagonal[k], self.inverse[k])
    }

    /// The entry of D⁻¹ of a row; 0 where it was passed over.
    pub(super) fn inverse_pivot(&self, k: usize) -> Operand {
        self.inverse[k]
    }

    /// D⁻¹, then L column by column.
    pub(super) fn entries(&self) -> Vec<Operand> {
        let columns = self.order.iter().flat_map(|&k| &self.columns[k]);
        let below = columns.map(|&(_, entry)| entry);
        self.inverse.iter().copied().chain(below).collect()
    }

    /// The same factor, with its entries at hand as arguments of another function.
    pub(super) fn stored(mut self) -> Factor {
        let argument = |place: usize| Operand::Symbol(Symbol::FactorEntry(place as u32));
        let mut next = self.inverse.len();
        for (k, inverse) in self.inverse.iter_mut().enumerate() {
            *inverse = argument(k);
        }
        for &k in &self.order {
            for (_, entry) in &mut self.columns[k] {
                *entry = argument(next);
                next += 1;
            }
        }
        self
    }

    /// y = L⁻¹ a and D⁻¹ y of a row a: two of these make an entry of A M⁻¹Aᵀ.
    pub(super) fn halves(&self, code: &mut Lowering, row: Sparse) -> [Sparse; 2] {
        let mut half = row;
        self.forward(code, &mut half);
        let mut scaled = half.clone();
        self.scale(code, &mut scaled);
        [half, scaled]
    }

    /// x ← L⁻¹ x.
    pub(super) fn forward(&self, code: &mut Lowering, x: &mut Sparse) {
        for &k in &self.order {
            let Some(&known) = x.get(&k) else { continue };
            for &(i, entry) in &self.columns[k] {
                let change = code.times(entry, known);
                let place = x.entry(i).or_insert(Operand::number(0.0));
                *place = code.less(*place, change);
            }
        }
    }

    /// x ← D⁻¹ x.
    pub(super) fn scale(&self, code: &mut Lowering, x: &mut Sparse) {
        for (&k, place) in x.iter_mut() {
            *place = code.times(*place, self.inverse[k]);
        }
    }

    /// x ← L⁻ᵀ x.
    pub(super) fn backward(&self, code: &mut Lowering, x: &mut Sparse) {
        for &k in self.order.iter().rev() {
            for &(i, entry) in &self.columns[k] {
                let Some(&known) = x.get(&i) else { continue };
                let change = code.times(entry, known);
                let place = x.entry(k).or_insert(Operand::number(0.0));
                *place = code.less(*place, change);
            }
        }
    }

    /// x ← S⁻¹ x.
    pub(super) fn solve(&self, code: &mut Lowering, x: &mut Sparse) {
        self.forward(code, x);
        self.scale(code, x);
        self.backward(code, x);
    }
}

/// Operations on operands, with zeros and ones left out.
impl Lowering<'_> {
    pub(super) fn times(&mut self, a: Operand, b: Operand) -> Operand {
        let (zero, one) = (Operand::number(0.0), Operand::number(1.0));
        match (a, b) {
            _ if a == zero || b == zero => zero,
            _ if a == one => b,
            _ if b == one => a,
            _ => self.push(Operation::Multiply(a, b)),
        }
    }

    pub(super) fn plus(&mut self, a: Operand, b: Operand) -> Operand {
        let zero = Operand::number(0.0);
        match (a, b) {
            _ if a == zero => b,
            _ if b == zero => a,
            _ => self.push(Operation::Add(a, b)),
        }
    }

    pub(super) fn less(&mut self, a: Operand, b: Operand) -> Operand {
        let zero = Operand::number(0.0);
        match (a, b) {
            _ if b == zero => a,
            _ if a == zero => self.push(Operation::Negate(b)),
            _ => self.push(Operation::Subtract(a, b)),
        }
    }

    /// Σ x y; `None` where it is zero by structure.
    pub(super) fn dot(&mut self, x: &Sparse, y: &Sparse) -> Option<Operand> {
        let mut total = None;
        for (k, &a) in x {
            let Some(&b) = y.get(k) else { continue };
            let product = self.times(a, b);
            total = Some(match total {
                Some(sum) => self.plus(sum, product),
                None => product,
            });
        }
        total
    }

    fn pivot_inverse(&mut self, pivot: Operand, whole: Operand) -> Operand {
        match pivot {
            // A pivot that the elimination did not change is not round-off, unless the row is zero.
            Operand::Number(number) if number.value() == 0.0 => pivot,
            _ => self.push(Operation::PivotInverse(pivot, whole)),
        }
    }

    fn reciprocal(&mut self, a: Operand) -> Operand {
        match a {
            _ if a == Operand::number(1.0) => a,
            _ => self.push(Operation::Divide(Operand::number(1.0), a)),
        }
    }
}
