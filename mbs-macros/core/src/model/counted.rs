//! Angles that are counted over full turns.
//!
//! After the reduction the angle of a joint of the tree is its coordinate, which is not limited to one turn; only the
//! other angles need a stored value. That of a bar which a drive turns is counted from the value of the drive.

use super::elements::JointEntry;
use super::elements::joint::HeldAngle;
use super::geometry::Owner;
use super::joint_variables::UnwrappedAngle;
use super::resolver::Resolver;
use super::tree::Tree;
use crate::symbolic::{Expr, Map, Substitution, Symbol};
use std::f64::consts::TAU;

impl Resolver<'_> {
    /// The angle of a part of the plane against ground.x: its coordinate, or that of its direction, counted over full
    /// turns.
    pub(super) fn part_angle(&mut self, owner: Owner) -> Expr {
        let frame = self.frame(owner);
        let (Some(part), None) = (owner.part(), frame.angle) else {
            return frame.angle.unwrap_or_else(|| self.graph.zero());
        };
        let mut known = self.unwrapped_angles.iter();
        if let Some(known) = known.find(|known| known.bar == Some(part)) {
            return known.angle;
        }
        let angle = self.graph.atan2(frame.axes[0][1], frame.axes[0][0]);
        let name = self.owner_name(owner).to_owned();
        self.counted(&name, Some(part), angle)
    }

    /// `within`, which is the angle within one turn, plus the full turns since the start:
    /// angle = within + 2π round((last − within)/2π).
    pub(super) fn counted(&mut self, of: &str, bar: Option<usize>, within: Expr) -> Expr {
        let index = self.unwrapped_angles.len() as u32;
        let symbol = Symbol::UnwrappedAngle(index);
        self.graph.set_name(symbol, format!("{of}.angle"));
        let last = self.graph.symbol(symbol);
        let behind = self.graph.sub(last, within);
        let turns = self.graph.full_turns(behind);
        let terms = [(within, 1.0), (turns, TAU)];
        let angle = self.graph.linear(0.0, &terms);
        self.unwrapped_angles.push(UnwrappedAngle {
            of: of.to_owned(),
            bar,
            angle,
            within,
        });
        angle
    }
}

/// Replaces the counted angles of the joints of a tree, whose coordinates have their values in `substitution` or stand for
/// themselves, and those of driven bars. Answers the other angles, by their index in [`Resolver::unwrapped_angles`].
pub(super) fn replace(
    resolver: &mut Resolver,
    tree: &Tree,
    joints: &[JointEntry],
    substitution: &mut Substitution,
) -> Vec<usize> {
    let graph = &mut resolver.graph;
    let held = joints.iter().filter_map(|entry| entry.joint.held_angle);
    let driven: Map<usize, Expr> = held
        .filter_map(|held| match held {
            HeldAngle {
                parent: Owner::Ground,
                child: Owner::Part(bar),
                angle,
            } if graph.depends_on(angle, |symbol| !symbol.is_parameter_like()) => {
                Some((bar, angle))
            }
            _ => None,
        })
        .collect();
    let mut others = Vec::new();
    for (index, unwrapped) in resolver.unwrapped_angles.iter().enumerate() {
        if let Some(&angle) = unwrapped.bar.and_then(|bar| driven.get(&bar)) {
            substitution.insert(Symbol::UnwrappedAngle(index as u32), angle);
            continue;
        }
        let mut joints = tree.joints.iter();
        let own = joints.find_map(|joint| {
            if unwrapped.bar.is_some() || joint.joint != unwrapped.of {
                return None;
            }
            let local = *joint.angles().first()?;
            Some(Symbol::LocalPosition(local))
        });
        let Some(local) = own else {
            others.push(index);
            continue;
        };
        let angle = match substitution.get(local) {
            Some(value) => value,
            None => graph.symbol(local),
        };
        // What was counted last is the same, so that no turns are added.
        substitution.insert(Symbol::UnwrappedAngle(index as u32), angle);
        substitution.equate(unwrapped.within, angle);
    }
    others
}

/// Gives the angles that need a memory their places among those that have one.
pub(super) fn renumber(resolver: &mut Resolver, kept: &[usize], substitution: &mut Substitution) {
    for (place, &index) in kept.iter().enumerate() {
        let memory = Symbol::UnwrappedAngle(place as u32);
        let name = format!("{}.angle", resolver.unwrapped_angles[index].of);
        resolver.graph.set_name(memory, name);
        let value = resolver.graph.symbol(memory);
        substitution.insert(Symbol::UnwrappedAngle(index as u32), value);
    }
}
