//! Kernels: the products with M⁻¹ and A of which each step of the integrator consists, with their zeros written out.

use super::factor;
use super::lower::{Hoisted, Lowering};
use super::{Function, Place};
use crate::derivatives::Derived;
use crate::equations::InverseMass;
use crate::symbolic::{Expr, Graph, Symbol};
use std::collections::BTreeSet;

/// Kernels longer than this are left to loops: straight-line code of such length costs more to compile than it gains.
pub(super) const LONGEST: usize = 2500;

/// The kernels that are short enough.
pub(super) fn kernels(
    graph: &mut Graph,
    hoisted: &mut Hoisted,
    derived: &Derived,
) -> Vec<Function> {
    let mut maker = Maker {
        graph,
        hoisted,
        derived,
    };
    let mut list = Vec::new();
    if derived.constant_mass {
        let inverse = InverseMass::new(derived.system.size, &derived.system.mass);
        list.extend(maker.solve_mass(&inverse));
        let (weighted, delassus) = (maker.solve_mass_rows(&inverse), maker.delassus());
        // If these two are long, the function that replaces them is long, too.
        let separate = match (&weighted, &delassus) {
            (Some(weighted), Some(delassus)) => {
                Some(weighted.cost().total() + delassus.cost().total())
            }
            _ => None,
        };
        list.extend(weighted);
        list.extend(delassus);
        if let Some(separate) = separate.filter(|&total| total <= LONGEST) {
            let metric = maker.metric(&inverse);
            list.extend((metric.cost().total() < separate).then_some(metric));
        }
    } else {
        list.extend(maker.delassus());
    }
    list.push(maker.row_rates());
    list.retain(|kernel| kernel.operations.len() <= LONGEST);
    if !derived.constant_mass {
        list.extend(factor::kernels(graph, hoisted, derived));
    }
    list
}

struct Maker<'a> {
    graph: &'a mut Graph,
    hoisted: &'a mut Hoisted,
    derived: &'a Derived,
}

impl Maker<'_> {
    fn start(&mut self) -> Lowering<'_> {
        Lowering::new(self.graph, self.hoisted)
    }

    /// All rows of A.
    fn rows(&self) -> Rows {
        rows(self.derived)
    }

    /// x ← M⁻¹ x; `None` if that is too long.
    fn solve_mass(&mut self, inverse: &InverseMass) -> Option<Function> {
        let size = self.derived.system.size;
        // At least one operation for each entry of M⁻¹ but the first of a row.
        if inverse.entries() - size > LONGEST {
            return None;
        }
        let mut lowering = self.start();
        for i in 0..size {
            let coupled = inverse.coupled(i).iter();
            let terms = coupled.map(|&j| (j, Symbol::VectorEntry(j as u32)));
            let value = inverse_product(lowering.graph(), inverse, i, terms);
            lowering.output("x", Place::Element(i), value);
        }
        Some(lowering.finish("solve_mass"))
    }

    /// w = M⁻¹ a, row by row; `None` if that is too long.
    fn solve_mass_rows(&mut self, inverse: &InverseMass) -> Option<Function> {
        let (size, rows) = (self.derived.system.size, self.rows());
        let mut operations = 0;
        for row in &rows {
            // The k-th entry of a row that meets a block adds one operation to each entry of w there but the first.
            let mut met = BTreeSet::new();
            for &(j, _) in row {
                if !met.insert(inverse.block(j)) {
                    operations += inverse.coupled(j).len();
                }
            }
            if operations > LONGEST {
                return None;
            }
        }
        let mut lowering = self.start();
        for (r, row) in rows.iter().enumerate() {
            for i in 0..size {
                let coupled = row.iter().filter(|&&(j, _)| inverse.couples(i, j));
                let terms: Vec<_> = coupled
                    .map(|&(j, _)| (j, Symbol::RowEntry(r as u32, j as u32)))
                    .collect();
                if !terms.is_empty() {
                    let value = inverse_product(lowering.graph(), inverse, i, terms);
                    lowering.output("w", Place::Entry(r, i), value);
                }
            }
        }
        Some(lowering.finish("solve_mass_rows"))
    }

    /// S = A W, each entry the product of a row of A with a row of W; `None` if that is too long.
    fn delassus(&mut self) -> Option<Function> {
        let rows = self.rows();
        // No two entries share an operation, so that the length is known without making the operations, whose number
        // is quadratic.
        let of_row = |row: &Vec<_>| (2 * row.len()).saturating_sub(1);
        if rows.len() * rows.iter().map(of_row).sum::<usize>() > LONGEST {
            return None;
        }
        let mut lowering = self.start();
        for (r, row) in rows.iter().enumerate() {
            for s in 0..rows.len() {
                let graph = lowering.graph();
                let terms: Vec<Expr> = row
                    .iter()
                    .map(|&(j, _)| {
                        let a = graph.symbol(Symbol::RowEntry(r as u32, j as u32));
                        let w = graph.symbol(Symbol::WeightedEntry(s as u32, j as u32));
                        graph.mul(a, w)
                    })
                    .collect();
                let value = graph.sum(terms);
                lowering.output("delassus", Place::Entry(r, s), value);
            }
        }
        Some(lowering.finish("delassus"))
    }

    /// a · v for each row.
    fn row_rates(&mut self) -> Function {
        let rows = self.rows();
        let mut lowering = self.start();
        for (r, row) in rows.iter().enumerate() {
            let graph = lowering.graph();
            let terms: Vec<Expr> = row
                .iter()
                .map(|&(j, _)| {
                    let a = graph.symbol(Symbol::RowEntry(r as u32, j as u32));
                    let v = graph.symbol(Symbol::Velocity(j as u32));
                    graph.mul(a, v)
                })
                .collect();
            let value = graph.sum(terms);
            lowering.output("rates", Place::Element(r), value);
        }
        lowering.finish("row_rates")
    }

    /// W = M⁻¹Aᵀ and S = A M⁻¹Aᵀ straight from q: factors of the same varying product add up to constants, so that for
    /// bars in natural coordinates an entry of S is little more than the dot product of two bars.
    fn metric(&mut self, inverse: &InverseMass) -> Function {
        let (size, rows) = (self.derived.system.size, self.rows());
        let mut lowering = self.start();
        for (r, row) in rows.iter().enumerate() {
            for i in 0..size {
                let graph = lowering.graph();
                let coupled = row.iter().filter(|&&(j, _)| inverse.couples(i, j));
                let terms: Vec<_> = coupled
                    .map(|&(j, a)| {
                        let m = inverse.entry(graph, i, j);
                        graph.product(&[(m, 1), (a, 1)])
                    })
                    .collect();
                if !terms.is_empty() {
                    let value = graph.sum(terms);
                    lowering.output("w", Place::Entry(r, i), value);
                }
            }
        }
        for ((r, s), value) in delassus(lowering.graph(), inverse, &rows) {
            lowering.output("delassus", Place::Entry(r, s), value);
            if s > r {
                lowering.output("delassus", Place::Entry(s, r), value);
            }
        }
        lowering.finish("metric")
    }
}

/// The rows of A, each as its entries: (column, entry).
pub(super) type Rows = Vec<Vec<(usize, Expr)>>;

/// The rows of A.
pub(super) fn rows(derived: &Derived) -> Rows {
    let entries = |r: usize| derived.jacobian.range((r, 0)..(r + 1, 0));
    (0..derived.system.rows.len())
        .map(|r| entries(r).map(|(&(_, j), &entry)| (j, entry)).collect())
        .collect()
}

/// S = A M⁻¹Aᵀ straight from q, on and above its diagonal.
pub(super) fn delassus(
    graph: &mut Graph,
    inverse: &InverseMass,
    rows: &Rows,
) -> Vec<((usize, usize), Expr)> {
    let mut entries = Vec::new();
    for (r, row) in rows.iter().enumerate() {
        for (s, other) in rows.iter().enumerate().skip(r) {
            let mut terms = Vec::new();
            for &(i, a) in row {
                for &(j, b) in other.iter().filter(|&&(j, _)| inverse.couples(i, j)) {
                    let m = inverse.entry(graph, i, j);
                    terms.push(graph.product(&[(m, 1), (a, 1), (b, 1)]));
                }
            }
            entries.push(((r, s), graph.sum(terms)));
        }
    }
    entries
}

/// Σ (M⁻¹)_ij · symbol over (j, symbol).
fn inverse_product(
    graph: &mut Graph,
    inverse: &InverseMass,
    i: usize,
    terms: impl IntoIterator<Item = (usize, Symbol)>,
) -> Expr {
    let terms: Vec<Expr> = terms
        .into_iter()
        .map(|(j, symbol)| {
            let inverse = inverse.entry(graph, i, j);
            let symbol = graph.symbol(symbol);
            graph.mul(inverse, symbol)
        })
        .collect();
    graph.sum(terms)
}
