//! Groups → shapes: one piece of code for all groups that compute the same from different values. Groups with the same
//! form are rows of one table.

use super::form::{Form, Forms};
use super::groups::Groups;
use crate::dag::{Function, Operand, Output, Place};
use crate::symbolic::Map;
use std::rc::Rc;

/// A piece of straight-line code, and the places of its values in each use.
#[derive(Debug)]
pub struct Shape {
    /// The code: [`Symbol::Place`](crate::symbolic::Symbol::Place) are the values it reads, elements of its output those
    /// it leaves.
    pub function: Function,
    /// The places of each use: of the values that are read, then of those that are left.
    pub table: Vec<Vec<u32>>,
}

/// A group as a use of a shape.
pub(super) struct Member {
    pub shape: usize,
    /// What it reads.
    pub reads: Vec<Operand>,
    /// Its operations in the order of the shape.
    pub form: Rc<Form>,
}

/// The shapes, with the operations whose values they leave (as outputs), and each group as a use of one.
pub(super) fn of(forms: &mut Forms, groups: &Groups) -> (Vec<Shape>, Vec<Member>) {
    let function = forms.function;
    let left = values_left(function, groups);
    let mut known: Map<usize, usize> = Map::default();
    let mut shapes: Vec<(Rc<Form>, Vec<bool>)> = Vec::new();
    let mut members = Vec::with_capacity(groups.members.len());
    for group in &groups.members {
        let form = forms.of(group);
        let next = shapes.len();
        let shape = *known.entry(form.number).or_insert(next);
        if shape == next {
            shapes.push((form.clone(), vec![false; group.len()]));
        }
        for (is_left, &slot) in shapes[shape].1.iter_mut().zip(&form.order) {
            *is_left |= left[slot];
        }
        members.push(Member {
            shape,
            reads: form.reads.clone(),
            form,
        });
    }
    let mut uses = vec![0; shapes.len()];
    members.iter().for_each(|member| uses[member.shape] += 1);
    let mut names: Vec<Vec<Option<String>>> = vec![Vec::new(); shapes.len()];
    // Names are those of the only use: those of several would not agree.
    for member in members.iter().filter(|member| uses[member.shape] == 1) {
        let order = member.form.order.iter();
        names[member.shape] = order.map(|&slot| function.names[slot].clone()).collect();
    }
    let shapes = shapes
        .into_iter()
        .zip(names)
        .map(|((form, left), mut names)| {
            names.resize(form.order.len(), None);
            let left = left.iter().enumerate().filter(|(_, is_left)| **is_left);
            let outputs = left.enumerate().map(|(k, (local, _))| Output {
                sink: "t",
                place: Place::Element(k),
                value: Operand::Value(local),
            });
            Shape {
                function: Function {
                    name: function.name,
                    outputs: outputs.collect(),
                    operations: form.operations.to_vec(),
                    names,
                },
                table: Vec::new(),
            }
        })
        .collect();
    (shapes, members)
}

/// Whether the value of an operation is used outside its group.
fn values_left(function: &Function, groups: &Groups) -> Vec<bool> {
    let mut left = vec![false; function.operations.len()];
    for (slot, operation) in function.operations.iter().enumerate() {
        operation.for_each_operand(|operand| {
            if let Operand::Value(value) = operand {
                left[value] |= groups.of[value] != groups.of[slot];
            }
        });
    }
    for output in &function.outputs {
        if let Operand::Value(value) = output.value {
            left[value] = true;
        }
    }
    left
}
