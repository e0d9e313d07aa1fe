//! Reads joints, conditions and force elements.

use super::element::{ForceEntry, JointEntry};
use super::{forces, joints};
use crate::model::arguments::Arguments;
use crate::model::parts::Representation;
use crate::model::resolver::Resolver;
use crate::schema::Group;

impl Resolver<'_> {
    /// All joints, conditions and force elements, in the order of the declaration, and then the lengths of bars.
    pub(in crate::model) fn elements(&mut self) -> (Vec<JointEntry>, Vec<ForceEntry>) {
        let (mut found_joints, mut found_forces) = (Vec::new(), Vec::new());
        for entry in &self.declaration.entries {
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
                    if let Some(force) = forces::read(kind.name, &mut Arguments::new(self, entry)) {
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
}
