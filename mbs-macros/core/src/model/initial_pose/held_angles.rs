//! Angles of parts of the plane that joints and drives hold.
//!
//! In natural coordinates the row of an angle that depends on neither time nor inputs is a sine, which vanishes half a turn off, too: the guess
//! decides which of the two poses assembly finds.

use crate::model::elements::JointEntry;
use crate::model::elements::joint::HeldAngle;
use crate::model::geometry::Owner;
use crate::model::parts::{Part, Representation};
use crate::symbolic::{Expr, Graph, Substitution};
use std::collections::HashSet;

/// The angle of a part at the start.
#[derive(Debug, Clone, Copy)]
pub(super) struct Angle {
    pub(super) angle: Expr,
    /// If it was declared, or follows from what was.
    pub(super) rate: Option<Expr>,
    /// Declared for this part, or held against the ground. One that a joint carries from another part counts only where
    /// two points of the part do not give it.
    pub(super) is_firm: bool,
}

/// The angles that are known so far, and the joints that carry them to other parts.
pub(super) struct HeldAngles {
    held: Vec<HeldAngle>,
    /// The joints that hold an angle of a part.
    held_of: Vec<Vec<usize>>,
    angles: Vec<Option<Angle>>,
}

impl HeldAngles {
    /// `known` are the values of all that held angles may depend on but parameters.
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
        list.hold(graph, parts, known);
        list.declare(graph, parts);
        list
    }

    /// What is held against the ground, or against a part that follows coordinates.
    fn hold(&mut self, graph: &mut Graph, parts: &[Part], known: &mut Substitution) {
        for held in self.held.clone() {
            let (part, angle) = match (held.parent, held.child) {
                (Owner::Ground, Owner::Part(part)) => (part, held.angle),
                (Owner::Part(part), Owner::Ground) => (part, graph.neg(held.angle)),
                _ => continue,
            };
            self.spread(graph, part, angle, None);
        }
        for (index, part) in parts.iter().enumerate() {
            let (Representation::Prescribed, Some(angle)) = (part.representation, part.frame.angle)
            else {
                continue;
            };
            let rate = graph.rate(angle);
            let [angle, rate] = [angle, rate].map(|x| graph.substitute(x, known));
            // Those of a part that follows another one are not known yet.
            if !graph.any_depends_on([angle, rate], |symbol| !symbol.is_parameter_like()) {
                self.spread(graph, index, angle, Some(rate));
            }
        }
    }

    /// What is declared. A part within a quarter turn of what is held keeps its own angle.
    fn declare(&mut self, graph: &mut Graph, parts: &[Part]) {
        for (index, part) in parts.iter().enumerate() {
            let (false, Some(angle)) = (part.representation.is_number(), part.guess.angle) else {
                continue;
            };
            let keeps = self.angles[index].is_none_or(|held| {
                let off = graph.sub(angle, held.angle);
                graph.as_constant(off).is_some_and(|off| off.cos() > 0.0)
            });
            if keeps {
                self.angles[index] = Some(Angle {
                    angle,
                    rate: part.guess.rate,
                    is_firm: true,
                });
            }
            self.hand_on(graph, index, false, |known| known.is_none());
        }
    }

    /// The angle of a part, if it is known.
    pub(super) fn of(&self, part: usize) -> Option<Angle> {
        self.angles[part]
    }

    /// The pose of a part becomes known, and the angles that joints hold against it.
    pub(super) fn found(&mut self, graph: &mut Graph, part: usize, angle: Expr, rate: Expr) {
        self.angles[part] = Some(Angle {
            angle,
            rate: Some(rate),
            is_firm: true,
        });
        self.hand_on(graph, part, false, |known| {
            known.is_none_or(|known| !known.is_firm)
        });
    }

    /// The angle of a part that is held against the ground, or follows coordinates.
    fn spread(&mut self, graph: &mut Graph, part: usize, angle: Expr, rate: Option<Expr>) {
        if self.angles[part].is_none() {
            self.angles[part] = Some(Angle {
                angle,
                rate,
                is_firm: true,
            });
            self.hand_on(graph, part, true, |known| known.is_none());
        }
    }

    /// From a part whose angle is known to those of which `takes` says so, whose angles then are firm or not.
    fn hand_on(
        &mut self,
        graph: &mut Graph,
        part: usize,
        is_firm: bool,
        takes: impl Fn(Option<Angle>) -> bool,
    ) {
        if self.held_of[part].is_empty() {
            return;
        }
        let mut visited = HashSet::from([part]);
        let mut front = vec![part];
        while let Some(part) = front.pop() {
            let Some(Angle { angle, rate, .. }) = self.angles[part] else {
                continue;
            };
            for at in 0..self.held_of[part].len() {
                let held = self.held[self.held_of[part][at]];
                let forwards = held.parent == Owner::Part(part);
                let partner = if forwards { held.child } else { held.parent };
                if let Owner::Part(partner) = partner
                    && takes(self.angles[partner])
                    && visited.insert(partner)
                {
                    let angle = match forwards {
                        true => graph.add(angle, held.angle),
                        false => graph.sub(angle, held.angle),
                    };
                    self.angles[partner] = Some(Angle {
                        angle,
                        rate,
                        is_firm,
                    });
                    front.push(partner);
                }
            }
        }
    }
}
