//! Components of reactions that outputs read.

use super::system::Reaction;
use crate::model::{Model, Reading};
use crate::symbolic::{Graph, Node, Substitution, Symbol};

/// A component that its joint does not have.
#[derive(Debug)]
pub struct UnknownReading {
    /// What is read.
    pub reading: Reading,
    /// The components of this joint.
    pub known: Vec<String>,
}

/// Puts the reactions in place of the symbols that outputs have for them; answers what there is no reaction for.
pub(super) fn resolve(
    readings: &[Reading],
    reactions: &[Reaction],
    reduction: &mut Substitution,
) -> Vec<UnknownReading> {
    let mut unknown = Vec::new();
    for (index, reading) in readings.iter().enumerate() {
        match find(reading, reactions) {
            Some(reaction) => reduction.insert(Symbol::Reaction(index as u32), reaction.expr),
            None => {
                let of_joint = reactions.iter().filter(|own| own.joint == reading.joint);
                unknown.push(UnknownReading {
                    reading: reading.clone(),
                    known: of_joint.map(|own| own.component.clone()).collect(),
                });
            }
        }
    }
    unknown
}

fn find<'a>(reading: &Reading, reactions: &'a [Reaction]) -> Option<&'a Reaction> {
    let mut reactions = reactions.iter();
    reactions.find(|own| own.joint == reading.joint && own.component == reading.component)
}

/// An output that is such a component has its unit: that of a multiplier is known here only.
pub(super) fn give_units(graph: &Graph, model: &mut Model, reactions: &[Reaction]) {
    for (output, quantity) in model.outputs.iter().zip(&mut model.outline.outputs) {
        let Node::Symbol(Symbol::Reaction(index)) = graph.node(*output) else {
            continue;
        };
        let reading = &model.readings[*index as usize];
        if let Some(reaction) = find(reading, reactions) {
            quantity.unit.clone_from(&reaction.unit);
        }
    }
}
