//! Second derivatives of a scalar by the reverse mode (edge pushing: R. M. Gower and M. P. Mello, *A new framework for the
//! computation of Hessians*, Optimization Methods and Software 27, 2012).
//!
//! Backwards through the scalar, each node passes its second derivatives on to its operands: one by itself twice becomes
//! those by pairs of operands, one by itself and another node those by the operands and the other node. For the kinetic
//! energy of a chain, where the velocities of a body follow from those of the body before, what passes from body to body is
//! the inertia of all that follow, and for each of their velocities their momentum: composite bodies.

use super::{Expr, Function, Graph, Map, Node, Symbol};
use std::collections::BTreeMap;

/// The second derivatives of a scalar, for pairs of symbols in order, where they are not zero.
pub(crate) type Hessian = BTreeMap<(Symbol, Symbol), Expr>;

/// The derivatives by a node and nodes that precede it, as sums, by their places.
type Row = BTreeMap<usize, Vec<Expr>>;

/// The symbols, and the nodes that depend on them, operands first. Symbols precede all nodes, so that each pair is kept with
/// the later of the two.
struct Order {
    symbols: Vec<(Symbol, Expr)>,
    nodes: Vec<Expr>,
    places: Map<Expr, usize>,
}

impl Graph {
    /// Second derivatives by the symbols for which `is_variable` holds. `None` if anything but sums, products, sines and
    /// cosines depends on them, rotations among these.
    pub(crate) fn hessian(
        &mut self,
        scalar: Expr,
        is_variable: impl Fn(Symbol) -> bool,
    ) -> Option<Hessian> {
        let order = self.order(scalar, is_variable)?;
        let known = order.symbols.len();
        let mut rows: Vec<Row> = vec![Row::new(); known + order.nodes.len()];
        let mut slopes: Vec<Vec<Expr>> = vec![Vec::new(); rows.len()];
        slopes[*order.places.get(&scalar)?].push(self.one());
        for (k, &node) in order.nodes.iter().enumerate().rev() {
            let at = known + k;
            let second = self.second_partials(node, &order)?;
            let operands = self.partials_by(node, &order);
            let slope = std::mem::take(&mut slopes[at]);
            let slope = self.sum(slope);
            for &(a, partial) in &operands {
                let passed = self.mul(slope, partial);
                slopes[a].push(passed);
            }
            let row = std::mem::take(&mut rows[at]);
            let mut put = |a: usize, b: usize, term: Expr| {
                rows[a.max(b)].entry(a.min(b)).or_default().push(term);
            };
            for (a, b, second) in second {
                put(a, b, self.mul(slope, second));
            }
            for (other, terms) in row {
                let entry = self.sum(terms);
                for (k, &(a, partial)) in operands.iter().enumerate() {
                    let passed = self.mul(entry, partial);
                    if other == at {
                        for &(b, partial) in &operands[k..] {
                            put(a, b, self.mul(passed, partial));
                        }
                    } else {
                        let times = if a == other { 2.0 } else { 1.0 };
                        put(a, other, self.scale(times, passed));
                    }
                }
            }
        }
        let mut hessian = Hessian::new();
        for (&(symbol, _), row) in order.symbols.iter().zip(rows) {
            for (other, terms) in row {
                let entry = self.sum(terms);
                if !self.is_zero(entry) {
                    hessian.insert((order.symbols[other].0, symbol), entry);
                }
            }
        }
        Some(hessian)
    }

    fn order(&self, scalar: Expr, is_variable: impl Fn(Symbol) -> bool) -> Option<Order> {
        let mut depends: Map<Expr, bool> = Map::default();
        let (mut symbols, mut nodes) = (Vec::new(), Vec::new());
        for expr in self.inside([scalar]) {
            let mut found = false;
            match *self.node(expr) {
                Node::Symbol(symbol) if is_variable(symbol) => {
                    symbols.push((symbol, expr));
                    found = true;
                }
                Node::Symbol(symbol) if symbol.directions().any(&is_variable) => return None,
                _ => {
                    self.for_each_operand(expr, |operand| found |= depends[&operand]);
                    if found {
                        nodes.push(expr);
                    }
                }
            }
            depends.insert(expr, found);
        }
        symbols.sort_unstable();
        let all = symbols.iter().map(|&(_, expr)| expr);
        let places = all.chain(nodes.iter().copied()).zip(0..).collect();
        Some(Order {
            symbols,
            nodes,
            places,
        })
    }

    /// The derivatives of a node by those of its operands that depend on the symbols.
    fn partials_by(&mut self, node: Expr, order: &Order) -> Vec<(usize, Expr)> {
        let partials = self.partials(node).into_iter();
        let by =
            partials.filter_map(|(operand, slope)| Some((*order.places.get(&operand)?, slope)));
        by.collect()
    }

    /// The second derivatives of a node by these operands; `None` if they are not known.
    fn second_partials(&mut self, node: Expr, order: &Order) -> Option<Vec<(usize, usize, Expr)>> {
        let mut found = Vec::new();
        match self.node(node).clone() {
            Node::Sum { .. } | Node::Function(Function::Apart, _) => {}
            Node::Function(Function::Sin | Function::Cos, x) => {
                let place = order.places[&x];
                found.push((place, place, self.neg(node)));
            }
            Node::Product(factors) => {
                for (k, (a, power)) in factors.iter().enumerate() {
                    for (l, (b, other)) in factors.iter().enumerate().skip(k) {
                        let power = f64::from(*power);
                        let other = f64::from(*other);
                        let times = power * if l == k { power - 1.0 } else { other };
                        let (Some(&a), Some(&b), true) =
                            (order.places.get(a), order.places.get(b), times != 0.0)
                        else {
                            continue;
                        };
                        let mut rest = factors.to_vec();
                        rest[k].1 -= 1;
                        rest[l].1 -= 1;
                        let rest = self.product(&rest);
                        found.push((a, b, self.scale(times, rest)));
                    }
                }
            }
            _ => return None,
        }
        Some(found)
    }
}
