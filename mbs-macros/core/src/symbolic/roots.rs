//! Square roots among the factors of a product, and slopes of roots.

use super::collected::put_factor;
use super::{Expr, Function, Graph, Node};

impl Graph {
    /// x^(exponent − 1), where `value` = x^exponent is differentiated. With an exponent below 1 it is infinite at x = 0, and its product
    /// with a factor that vanishes there is not a number; x^exponent divided by [`Function::Nonzero`] of x is 0 there, as the slope of
    /// |x|^exponent x is.
    pub(super) fn lowered_power(&mut self, value: Expr, x: Expr, exponent: f64) -> Expr {
        if exponent > 0.0 && exponent < 1.0 {
            let divisor = self.function(Function::Nonzero, x);
            self.div(value, divisor)
        } else {
            self.power(x, exponent - 1.0)
        }
    }

    /// √x / √x = 1, where the divisor is one of a derivative ([`Function::Nonzero`]). Beside other divisors √x or x this is √x.
    pub(super) fn cancel_roots(&self, factors: &mut Vec<(Expr, i32)>) {
        let mut slot = 0;
        while slot < factors.len() {
            let (divisor, power) = factors[slot];
            slot += 1;
            if power > 0 {
                continue;
            }
            let Node::Function(Function::Nonzero, root) = *self.node(divisor) else {
                continue;
            };
            let Node::Function(Function::Sqrt, inside) = *self.node(root) else {
                continue;
            };
            let mut others = factors.iter();
            let is_divided = others.any(|&(x, power)| power < 0 && (x == root || x == inside));
            let mut others = factors.iter();
            let common = match others.find(|(factor, _)| *factor == root) {
                _ if is_divided => -power,
                Some(&(_, multiplied)) => multiplied.min(-power).max(0),
                None => 0,
            };
            if common != 0 {
                put_factor(factors, divisor, common);
                put_factor(factors, root, -common);
                slot = 0;
            }
        }
    }

    /// Where a square root has a power that is one of what is inside.
    pub(super) fn double_root(&self, factors: &[(Expr, i32)]) -> Option<usize> {
        let mut slot = 0;
        while slot < factors.len() {
            let (factor, power) = factors[slot];
            if power.abs() >= 2 && matches!(self.node(factor), Node::Function(Function::Sqrt, _)) {
                return Some(slot);
            }
            slot += 1;
        }
        None
    }
}
