//! Outputs and events.

use super::geometry::Vector;
use super::quantities::{Quantity, quantity};
use super::resolver::Resolver;
use super::value::Value;
use crate::diagnostics::Place;
use crate::dimension::Dimension;
use crate::symbolic::{Expr, Symbol};
use crate::syntax::Entry;
use std::collections::HashMap;
use syn::Expr as Syntax;

impl Resolver<'_> {
    /// Outputs, states among them, and events, each with its expression.
    pub(super) fn outputs(&mut self) -> (Vec<(Quantity, Expr)>, Vec<(String, Expr)>) {
        let (mut outputs, mut events) = (Vec::new(), Vec::new());
        let mut widths: HashMap<&str, usize> = HashMap::new();
        for entry in &self.declaration.entries {
            if entry.kind == "State" {
                outputs.extend(self.state_output(entry));
            }
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
                    if let Some((expr, _)) = self.scalar(syntax)
                        && self.may_change(syntax, expr)
                    {
                        events.push((entry.name.to_string(), expr));
                    }
                }
                _ => {}
            }
            self.errors.leave(before);
        }
        (outputs, events)
    }

    /// Refuses an event that does not change in a run.
    fn may_change(&mut self, syntax: &Syntax, expr: Expr) -> bool {
        let changes = |symbol: Symbol| !symbol.is_parameter_like();
        let may = self.graph.depends_on(expr, changes);
        if !may {
            self.fail::<()>(
                Place::of(syntax),
                "this depends on parameters only, so that the event never occurs: name what changes in a run, such as a position",
            );
        }
        may
    }

    /// A state is an output of its own.
    fn state_output(&mut self, entry: &Entry) -> Option<(Quantity, Expr)> {
        let Some(Value::Scalar(value, _)) = self.value_of(entry) else {
            return None;
        };
        let mut states = self.scalar_states.iter();
        let state = states.find(|state| entry.name == state.quantity.name.as_str())?;
        Some((state.quantity.clone(), value))
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
