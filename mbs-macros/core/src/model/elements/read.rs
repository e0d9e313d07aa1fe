//! Reads joints, conditions and force elements.

use super::element::{ForceEntry, JointEntry};
use super::joints;
use crate::model::arguments::Arguments;
use crate::model::parts::Representation;
use crate::model::resolver::Resolver;
use crate::schema::Group;
use crate::symbolic::Symbol;
use crate::syntax::Entry;
use syn::Expr as Syntax;

impl Resolver<'_> {
    /// All joints, conditions and force elements, in the order of the declaration, and then the lengths of bars.
    pub(in crate::model) fn elements(&mut self) -> (Vec<JointEntry>, Vec<ForceEntry>) {
        let (mut found_joints, mut found_forces) = (Vec::new(), Vec::new());
        for (index, entry) in self.declaration.entries.iter().enumerate() {
            let Some(kind) = self.kinds.kind(self.world, &entry.kind.to_string()) else {
                continue;
            };
            let name = entry.name.to_string();
            if self.misplaced.contains(&name) || self.is_wrong_joint(entry) {
                continue;
            }
            let before = self.errors.enter(&name);
            let element = matches!(kind.group, Group::Joint | Group::Constraint | Group::Force);
            let (known, count) = (
                self.errors.is_empty(),
                found_joints.len() + found_forces.len(),
            );
            match kind.group {
                Group::Joint | Group::Constraint if self.has_state_in_row(entry) => {}
                Group::Joint | Group::Constraint => {
                    if let Some(joint) = joints::read(kind.name, &mut Arguments::new(self, entry)) {
                        found_joints.push(JointEntry {
                            name,
                            span: entry.span(),
                            joint,
                        });
                    }
                }
                Group::Force => {
                    if let Some(force) = self.force_element(index) {
                        found_forces.push(ForceEntry { name, force });
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
            self.errors.leave(before);
        }
        // The length of a bar in natural coordinates is a separate row.
        for part in &self.parts {
            if let (Representation::Natural, Some(length)) = (&part.representation, part.length) {
                let joint = joints::bar_length(part, length, &mut self.graph);
                found_joints.push(JointEntry {
                    name: part.name.clone(),
                    span: part.span,
                    joint,
                });
            }
        }
        (found_joints, found_forces)
    }

    /// Refuses a state in a joint or condition: a row holds accelerations, and its force would push the state.
    fn has_state_in_row(&mut self, entry: &Entry) -> bool {
        let named = entry.named.iter().map(|argument| &argument.value);
        let given: Vec<&Syntax> = entry.positional.iter().chain(named).collect();
        given.into_iter().any(|syntax| {
            self.has_state(syntax, "no row may depend on a state: the force of the row would act on the state, too; let a force or torque follow it")
        })
    }

    /// Refuses a state in the speed of a friction, which would brake it.
    pub(in crate::model) fn has_state_in_speed(&mut self, entry: &Entry) -> bool {
        let named = entry.named("speed").map(|argument| &argument.value);
        let speed = named.or(entry.positional.first());
        speed.is_some_and(|syntax| {
            self.has_state(
                syntax,
                "friction brakes what moves: name the speed of a part or joint",
            )
        })
    }

    fn has_state(&mut self, syntax: &Syntax, why: &str) -> bool {
        if self.scalar_states.is_empty() {
            return false;
        }
        if let Syntax::Array(array) = syntax {
            return array.elems.iter().any(|item| self.has_state(item, why));
        }
        let value = self.silently(|resolver| resolver.evaluate(syntax));
        let Some(state) = value.and_then(|value| self.state_in(&value)) else {
            return false;
        };
        let (name, own) = (
            state.quantity.name.clone(),
            Symbol::LocalVelocity(state.local),
        );
        let place = self.blame(syntax, &|symbol| symbol == own);
        self.fail::<()>(place, format!("`{name}` is a state, and {why}"));
        true
    }
}
