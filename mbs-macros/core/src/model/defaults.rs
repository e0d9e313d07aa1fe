//! Expressions of parameters as numbers: with the defaults of all parameters, or with others near them.

use super::quantities::Quantity;
use super::resolver::Resolver;
use crate::symbolic::{Evaluator, Expr, Graph, Symbol};
use std::cell::OnceCell;
use std::collections::BTreeMap;

/// A value below this fraction of what it is the difference of is zero except for rounding.
pub(super) const ROUNDING: f64 = 1e-12;

/// A number for the defaults of all parameters, and for two other choices of their values.
pub(crate) type Sampled = [f64; 3];

/// The size of angles and of components of directions.
pub(super) const OF_ANGLES: Sampled = [1.0; 3];

impl Resolver<'_> {
    /// Zero, if an expression of parameters is zero except for rounding, for all of their values; `size` is that of what it
    /// is the difference of.
    pub(super) fn settled(&mut self, expr: Expr, size: Sampled) -> Expr {
        let rounding = size.map(|size| ROUNDING * size);
        match vanishes(&self.graph, &self.parameters, expr, rounding) {
            true => self.graph.zero(),
            false => expr,
        }
    }

    /// The value with the defaults of all parameters; NaN if it depends on anything else.
    pub(super) fn by_default(&self, expr: Expr) -> f64 {
        at_sample(&self.graph, &self.parameters, 0, &[expr])[0]
    }
}

/// Whether an expression of parameters is zero except for rounding, for all of their values.
pub(crate) fn vanishes(
    graph: &Graph,
    parameters: &[Quantity],
    expr: Expr,
    rounding: Sampled,
) -> bool {
    let mut samples = rounding.into_iter().enumerate();
    // Written so that NaN does not vanish.
    samples.all(|(sample, rounding)| {
        at_sample(graph, parameters, sample, &[expr])[0].abs() <= rounding
    })
}

/// The largest of some expressions, without their signs; those of more than parameters do not count.
pub(super) fn largest(graph: &Graph, parameters: &[Quantity], exprs: &[Expr]) -> Sampled {
    std::array::from_fn(|sample| {
        let values = at_sample(graph, parameters, sample, exprs);
        values.into_iter().map(f64::abs).fold(0.0, f64::max)
    })
}

/// Values of quantities near their defaults, which are sample 0.
pub(super) struct Near<'a> {
    quantities: &'a [Quantity],
    /// The largest default of each unit, once it is asked for.
    usual: OnceCell<BTreeMap<&'a str, f64>>,
}

impl<'a> Near<'a> {
    pub(super) fn new(quantities: &'a [Quantity]) -> Self {
        Near {
            quantities,
            usual: OnceCell::new(),
        }
    }

    /// Each quantity changes by a fraction of its own size, which is another one for each, so that two with the same default differ.
    pub(super) fn value(&self, index: usize, sample: usize) -> f64 {
        let default = self.quantities[index].default;
        if sample == 0 {
            return default;
        }
        // The same part in both directions: where one of two quantities becomes the larger one in a sample, it is the smaller one
        // in the next.
        let scattered = 0.754_877_666_246_693 * (index + 1) as f64
            + 0.569_840_290_998 * sample.div_ceil(2) as f64;
        let change = 0.01 * (1.0 + scattered.fract());
        if default == 0.0 {
            return change * self.usual(&self.quantities[index].unit);
        }
        match sample % 2 {
            0 => default * (1.0 - change),
            _ => default * (1.0 + change),
        }
    }

    /// The largest default of this unit; 1 where all are zero.
    fn usual(&self, unit: &str) -> f64 {
        let usual = self.usual.get_or_init(|| {
            let mut usual = BTreeMap::<&str, f64>::new();
            for Quantity { default, unit, .. } in self.quantities {
                let largest = usual.entry(unit).or_default();
                *largest = largest.max(default.abs());
            }
            usual
        });
        match usual.get(unit) {
            Some(&largest) if largest > 0.0 => largest,
            _ => 1.0,
        }
    }
}

fn at_sample(graph: &Graph, parameters: &[Quantity], sample: usize, exprs: &[Expr]) -> Vec<f64> {
    let near = Near::new(parameters);
    let symbols = |symbol| match symbol {
        Symbol::Parameter(index) => near.value(index as usize, sample),
        _ => f64::NAN,
    };
    let laws = |_, arguments: &[f64]| (f64::NAN, vec![f64::NAN; arguments.len()]);
    let mut evaluator = Evaluator::new(graph, &symbols, &laws);
    exprs.iter().map(|&expr| evaluator.value(expr)).collect()
}
