//! Outputs and events.

use super::geometry::Vector;
use super::quantities::{Quantity, quantity};
use super::resolver::Resolver;
use super::value::Value;
use crate::diagnostics::Place;
use crate::dimension::Dimension;
use crate::symbolic::Expr;

impl Resolver<'_> {
    /// Outputs and events, each with its expression.
    pub(super) fn outputs(&mut self) -> (Vec<(Quantity, Expr)>, Vec<(String, Expr)>) {
        let (mut outputs, mut events) = (Vec::new(), Vec::new());
        for entry in &self.declaration.entries {
            let Some(syntax) = entry.positional.first() else {
                continue;
            };
            match entry.kind.to_string().as_str() {
                "Output" => {
                    let Some(value) = self.evaluate(syntax) else {
                        continue;
                    };
                    let count = self.world.dimension();
                    let vector = |v: Vector, dimension| {
                        let names = [".x", ".y", ".z"].into_iter().zip(v).take(count);
                        names.map(|(name, x)| (name, x, dimension)).collect()
                    };
                    let components = match value {
                        Value::Scalar(x, dimension) => vec![("", x, dimension)],
                        Value::Vector(v, dimension) => vector(v, dimension),
                        Value::Point(point) => vector(point.position, Some(Dimension::LENGTH)),
                        other => {
                            let what = other.describe();
                            self.fail::<()>(
                                Place::of(syntax),
                                format!(
                                    "an output is a number, vector or point, but this is {what}"
                                ),
                            );
                            continue;
                        }
                    };
                    for (suffix, expr, dimension) in components {
                        let mut quantity = quantity(entry, 0.0, dimension);
                        quantity.name.push_str(suffix);
                        outputs.push((quantity, expr));
                    }
                }
                "Event" => {
                    if let Some((expr, _)) = self.scalar(syntax) {
                        events.push((entry.name.to_string(), expr));
                    }
                }
                _ => {}
            }
        }
        (outputs, events)
    }
}
