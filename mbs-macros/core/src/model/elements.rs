//! Entries that are not values: outputs, events, joints and forces.

use super::geometry::Vector;
use super::parts::Representation;
use super::resolve::{Resolver, quantity};
use super::value::Value;
use super::{Arguments, Dimension, Quantity};
use crate::diagnostics::Place;
use crate::equations::{forces, joints};
use crate::schema::Group;
use crate::symbolic::Expr;
use proc_macro2::Span;

/// A joint or constraint with what later checks need.
pub(super) struct JointElement {
    pub name: String,
    pub span: Span,
    pub joint: Box<dyn joints::Joint>,
}

/// A force element with what later checks need.
pub(super) struct ForceElement {
    pub name: String,
    pub force: Box<dyn forces::Force>,
}

impl Resolver<'_> {
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

    pub(super) fn elements(&mut self) -> (Vec<JointElement>, Vec<ForceElement>) {
        let (mut found_joints, mut found_forces) = (Vec::new(), Vec::new());
        for entry in &self.declaration.entries {
            let Some(kind) = crate::schema::kind(self.world, &entry.kind.to_string()) else {
                continue;
            };
            let name = entry.name.to_string();
            if self.misplaced.contains(&name) {
                continue;
            }
            let element = matches!(kind.group, Group::Joint | Group::Constraint | Group::Force);
            let (known, count) = (
                self.errors.is_empty(),
                found_joints.len() + found_forces.len(),
            );
            match kind.group {
                Group::Joint | Group::Constraint => {
                    if let Some(joint) = joints::read(kind.name, &mut Arguments::new(self, entry)) {
                        found_joints.push(JointElement {
                            name,
                            span: entry.span(),
                            joint,
                        });
                    }
                }
                Group::Force => {
                    if let Some(force) = forces::read(kind.name, &mut Arguments::new(self, entry)) {
                        found_forces.push(ForceElement { name, force });
                    }
                }
                Group::Value | Group::Part => {}
            }
            let read = found_joints.len() + found_forces.len() > count;
            if element && known && !read && self.errors.is_empty() {
                self.fail::<()>(
                    entry.kind.span(),
                    "the compiler dropped this without saying why; please report this declaration",
                );
            }
        }
        // The length of a bar in natural coordinates is a row of its own.
        for part in &self.parts {
            if let (Representation::Natural, Some(length)) = (&part.representation, part.length) {
                let joint = joints::bar_length(part, length, &self.graph);
                found_joints.push(JointElement {
                    name: part.name.clone(),
                    span: part.span,
                    joint,
                });
            }
        }
        (found_joints, found_forces)
    }
}
