//! Vectors of the plane that are sums of rotated constant ones, Σ p e(α) + q n(α) with e = (cos α, sin α) and
//! n = (−sin α, cos α): their scalar product depends on differences of angles only.
//!
//! Two bars, the second in an angle θ against the first, have cos β cos(β + θ) + sin β sin(β + θ) in their mass matrix,
//! which is cos θ. The rules for sums and products do not find this.

use super::{Expr, Function, Graph, Node};
use std::collections::BTreeMap;

/// The components p and q for each angle.
type Phasors = BTreeMap<Expr, [Expr; 2]>;

impl Graph {
    /// a·b; of vectors of the plane by differences of angles, where each of them is a single symbol or nothing, and so
    /// simpler than what it replaces.
    pub fn planar_dot(&mut self, a: [Expr; 3], b: [Expr; 3]) -> Expr {
        match (self.phasors(a), self.phasors(b)) {
            (Some(first), Some(second)) => self
                .phasor_dot(&first, &second)
                .unwrap_or_else(|| self.dot(a, b)),
            _ => self.dot(a, b),
        }
    }

    /// Σ (p p' + q q') cos(α − α') + (p q' − q p') sin(α − α').
    fn phasor_dot(&mut self, first: &Phasors, second: &Phasors) -> Option<Expr> {
        let mut terms = Vec::new();
        for (&own, &[p, q]) in first {
            for (&other, &[r, s]) in second {
                let difference = self.sub(own, other);
                let opposite = self.neg(difference);
                let simple = [difference, opposite]
                    .into_iter()
                    .any(|x| matches!(self.node(x), Node::Symbol(_) | Node::Constant(_)));
                if !simple {
                    return None;
                }
                let (pr, qs) = (self.mul(p, r), self.mul(q, s));
                let (ps, qr) = (self.mul(p, s), self.mul(q, r));
                let (along, across) = (self.add(pr, qs), self.sub(ps, qr));
                let cos = self.function(Function::Cos, difference);
                let sin = self.function(Function::Sin, difference);
                terms.push(self.mul(along, cos));
                terms.push(self.mul(across, sin));
            }
        }
        Some(self.sum(terms))
    }

    /// A vector of the plane as phasors, if it is a sum of such.
    fn phasors(&mut self, [x, y, z]: [Expr; 3]) -> Option<Phasors> {
        if !self.is_zero(z) {
            return None;
        }
        let (x, y) = (self.harmonics(x)?, self.harmonics(y)?);
        if !x.keys().eq(y.keys()) {
            return None;
        }
        for (angle, [cos, sin]) in &x {
            let turned = y[angle];
            if turned != [self.neg(*sin), *cos] {
                return None;
            }
        }
        let pairs = x.into_iter();
        let phasors = pairs.map(|(angle, [cos, sin])| (angle, [cos, self.neg(sin)]));
        Some(phasors.collect())
    }

    /// An expression as Σ a cos α + b sin α, with a and b that do not depend on the configuration: (a, b) for each α.
    fn harmonics(&mut self, expr: Expr) -> Option<Phasors> {
        let mut found = Phasors::new();
        let one = self.one();
        self.collect_harmonics(expr, one, &mut found)?;
        found.retain(|_, parts| parts.iter().any(|&part| !self.is_zero(part)));
        Some(found)
    }

    /// Adds those of `amplitude` times an expression.
    fn collect_harmonics(
        &mut self,
        expr: Expr,
        amplitude: Expr,
        found: &mut Phasors,
    ) -> Option<()> {
        match self.node(expr).clone() {
            Node::Constant(value) if value.value() == 0.0 => {}
            Node::Sum { constant, terms } if constant.value() == 0.0 => {
                for &(term, factor) in &terms {
                    let amplitude = self.scale(factor.value(), amplitude);
                    self.collect_harmonics(term, amplitude, found)?;
                }
            }
            Node::Product(factors) => {
                let moves = |graph: &Graph, base| {
                    graph.depends_on(base, |symbol| !symbol.is_parameter_like())
                };
                let (moving, fixed): (Vec<_>, Vec<_>) = factors
                    .iter()
                    .copied()
                    .partition(|&(base, _)| moves(self, base));
                let [(wave, 1)] = moving[..] else {
                    return None;
                };
                let fixed = self.product(&fixed);
                let amplitude = self.mul(fixed, amplitude);
                self.collect_harmonics(wave, amplitude, found)?;
            }
            Node::Function(function @ (Function::Cos | Function::Sin), angle) => {
                let zero = self.zero();
                let parts = found.entry(angle).or_insert([zero, zero]);
                let part = &mut parts[usize::from(function == Function::Sin)];
                *part = self.add(*part, amplitude);
            }
            _ => return None,
        }
        Some(())
    }
}
