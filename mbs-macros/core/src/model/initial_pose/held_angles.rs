//! Angles of parts of the plane that joints and drives hold.
//!
//! In natural coordinates such a row is a sine, which vanishes half a turn off, too: the guess decides which of the two
//! poses assembly finds.

use crate::model::elements::JointEntry;
use crate::model::elements::joint::HeldAngle;
use crate::model::geometry::Owner;
use crate::model::parts::{Part, Representation};
use crate::symbolic::{Expr, Graph, Substitution};

/// The angle of a part, and its rate if that was declared.
pub(super) type Angle = (Expr, Option<Expr>);

/// The angles that are known so far, and the joints that carry them to other parts.
pub(super) struct HeldAngles {
    held: Vec<HeldAngle>,
    /// The joints that hold an angle of a part.
    held_of: Vec<Vec<usize>>,
    angles: Vec<Option<Angle>>,
}

impl HeldAngles {
    /// What joints hold against the ground comes first, then what is declared. `known` are the values of all that held
    /// angles may depend on but parameters.
    pub(super) fn new(
        graph: &mut Graph,
        parts: &[Part],
        joints: &[JointEntry],
        known: &mut Substitution,
    ) -> Self {
        let held = joints.iter().filter_map(|entry| entry.joint.held_angle);
        let held: Vec<HeldAngle> = held
            .map(|held| HeldAngle {
                angle: graph.substitute(held.angle, known),
                ..held
            })
            .collect();
        let mut held_of = vec![Vec::new(); parts.len()];
        for (index, held) in held.iter().enumerate() {
            for part in [held.parent, held.child]
                .into_iter()
                .filter_map(Owner::part)
            {
                held_of[part].push(index);
            }
        }
        let mut list = HeldAngles {
            held,
            held_of,
            angles: vec![None; parts.len()],
        };
        for held in list.held.clone() {
            let (part, angle) = match (held.parent, held.child) {
                (Owner::Ground, Owner::Part(part)) => (part, held.angle),
                (Owner::Part(part), Owner::Ground) => (part, graph.neg(held.angle)),
                _ => continue,
            };
            list.set(graph, part, (angle, None));
        }
        for (index, part) in parts.iter().enumerate() {
            if let (Representation::Prescribed, Some(angle)) =
                (part.representation, part.frame.angle)
            {
                let angle = graph.substitute(angle, known);
                list.set(graph, index, (angle, None));
            }
        }
        for (index, part) in parts.iter().enumerate() {
            if let (false, Some(angle)) = (part.representation.is_number(), part.guess.angle) {
                list.set(graph, index, (angle, part.guess.rate));
            }
        }
        list
    }

    /// The angle of a part, if it is known.
    pub(super) fn of(&self, part: usize) -> Option<Angle> {
        self.angles[part]
    }

    /// The angle of a part becomes known, and those that joints hold against it.
    pub(super) fn set(&mut self, graph: &mut Graph, part: usize, angle: Angle) {
        let mut front = vec![(part, angle)];
        while let Some((part, (angle, rate))) = front.pop() {
            if self.angles[part].is_some() {
                continue;
            }
            self.angles[part] = Some((angle, rate));
            for held in self.held_of[part].iter().map(|&held| self.held[held]) {
                let (partner, angle) = match held.parent {
                    Owner::Part(parent) if parent == part => {
                        (held.child, graph.add(angle, held.angle))
                    }
                    parent => (parent, graph.sub(angle, held.angle)),
                };
                front.extend(partner.part().map(|partner| (partner, (angle, rate))));
            }
        }
    }
}
