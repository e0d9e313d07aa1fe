//! Outputs and events.

use super::geometry::Vector;
use super::quantities::{Quantity, quantity};
use super::resolver::Resolver;
use super::value::Value;
use crate::diagnostics::Place;
use crate::dimension::Dimension;
use crate::symbolic::Expr;
use std::collections::HashMap;
use syn::Expr as Syntax;

impl Resolver<'_> {
    /// Outputs and events, each with its expression.
    pub(super) fn outputs(&mut self) -> (Vec<(Quantity, Expr)>, Vec<(String, Expr)>) {
        let (mut outputs, mut events) = (Vec::new(), Vec::new());
        let mut widths: HashMap<&str, usize> = HashMap::new();
        for entry in &self.declaration.entries {
            let Some(syntax) = entry.positional.first() else {
                continue;
            };
            let before = self.errors.enter(entry.name.as_str());
            match entry.kind.to_string().as_str() {
                "Output" => {
                    self.at_acceleration_level = true;
                    let found = self.components(syntax).unwrap_or_default();
                    self.at_acceleration_level = false;
                    let width = *widths.entry(entry.name.base()).or_insert(found.len());
                    if width != found.len() && self.errors.is_empty() {
                        self.fail::<()>(
                            Place::of(syntax),
                            "the outputs of a family are an array: all of them are numbers, or all are vectors or points",
                        );
                    }
                    outputs.extend(found.into_iter().map(|(suffix, expr, dimension)| {
                        let mut quantity = quantity(entry, 0.0, dimension);
                        quantity.name.push_str(suffix);
                        (quantity, expr)
                    }));
                }
                "Event" => {
                    if let Some((expr, _)) = self.scalar(syntax) {
                        events.push((entry.name.to_string(), expr));
                    }
                }
                _ => {}
            }
            self.errors.leave(before);
        }
        (outputs, events)
    }

    /// The numbers of an output, each with the end of its name.
    fn components(
        &mut self,
        syntax: &Syntax,
    ) -> Option<Vec<(&'static str, Expr, Option<Dimension>)>> {
        let count = self.world.dimension();
        let vector = |v: Vector, dimension| {
            let names = [".x", ".y", ".z"].into_iter().zip(v).take(count);
            names.map(|(name, x)| (name, x, dimension)).collect()
        };
        match self.evaluate(syntax)? {
            Value::Scalar(x, dimension) => Some(vec![("", x, dimension)]),
            Value::Vector(v, dimension) => Some(vector(v, dimension)),
            Value::Point(point) => Some(vector(point.position, Some(Dimension::LENGTH))),
            Value::Reaction(joint) => self.fail(
                Place::of(syntax),
                format!("an output is a number, vector or point: read one component of the reaction, as in `{joint}.reaction.fx`"),
            ),
            other => {
                let what = other.describe();
                self.fail(
                    Place::of(syntax),
                    format!("an output is a number, vector or point, but this is {what}"),
                )
            }
        }
    }
}
