//! Local coordinates in terms of those that stand for a joined point, and in terms of the generalized ones.

use super::counted;
use super::elements::JointEntry;
use super::geometry::Vector;
use super::kinematics::Walk;
use super::parts::Part;
use super::reduction::Reduction;
use super::resolver::Resolver;
use super::solved;
use super::tree::{BodyTwist, Tree};
use crate::symbolic::{Expr, Graph, Substitution, Symbol};
use std::collections::BTreeMap;

/// What became of the local coordinates of points that are joined.
pub(super) struct Merged<'a> {
    /// The first coordinate of each end, and that of the end that stands for it.
    pub leaders: &'a BTreeMap<u32, u32>,
    /// Ends that the ground holds.
    pub fixed: &'a BTreeMap<u32, Vector>,
    pub tree: &'a Tree,
    pub joints: &'a [JointEntry],
}

/// What becomes of a local coordinate when points are merged.
enum Becomes {
    Fixed(Expr),
    /// As this local coordinate.
    As(u32),
}

impl Merged<'_> {
    /// All locals but those that the tree carries, each with what becomes of it.
    fn what_becomes(&self, resolver: &Resolver) -> Vec<(u32, Becomes)> {
        let mut outcome = Vec::new();
        for (part_index, part) in resolver.parts.iter().enumerate() {
            let dropped = self.tree.dropped(part_index, part);
            for (slot, &local) in part.locals.iter().enumerate() {
                if dropped.contains(&local) {
                    continue;
                }
                let component = match part.representation.is_points() {
                    true => slot % resolver.world.dimension(),
                    false => 0,
                };
                let first = local - component as u32;
                let leader = self.leaders.get(&first);
                let becomes = match self.fixed.get(&first) {
                    Some(position) => Becomes::Fixed(position[component]),
                    None => Becomes::As(leader.map_or(local, |leader| leader + component as u32)),
                };
                outcome.push((local, becomes));
            }
        }
        outcome.extend(self.tree.locals().map(|local| (local, Becomes::As(local))));
        outcome
    }

    /// Local coordinates in terms of those that stand for them, and the number of the latter.
    pub(super) fn by_leaders(&self, resolver: &mut Resolver) -> (Substitution, usize) {
        let mut substitution = Substitution::default();
        let mut free = 0;
        for (local, becomes) in self.what_becomes(resolver) {
            let graph = &mut resolver.graph;
            match becomes {
                Becomes::As(leader) if leader == local => free += 1,
                Becomes::As(leader) => set(
                    &mut substitution,
                    local,
                    solved::local_symbols(leader).map(|symbol| graph.symbol(symbol)),
                ),
                Becomes::Fixed(position) => {
                    let zero = graph.zero();
                    set(&mut substitution, local, [position, zero, zero]);
                }
            }
        }
        counted::replace(resolver, self.tree, self.joints, &mut substitution);
        self.walk(resolver, &mut substitution);
        (substitution, free)
    }

    /// Local coordinates in terms of generalized ones.
    pub(super) fn by_coordinates(&self, resolver: &mut Resolver, reduction: &mut Reduction) {
        let outcome = self.what_becomes(resolver);
        let rotations: Vec<u32> = resolver.parts.iter().filter_map(Part::rotation).collect();
        let graph = &mut resolver.graph;
        let mut index_of: BTreeMap<u32, u32> = BTreeMap::new();
        for (local, becomes) in &outcome {
            let Becomes::As(leader) = *becomes else {
                continue;
            };
            if index_of.contains_key(&leader) || reduction.solved.value(leader).is_some() {
                continue;
            }
            let name = &resolver.locals[leader as usize].name;
            let index = keep(graph, leader, name, &mut reduction.kept);
            index_of.insert(leader, index);
            if rotations.contains(local) {
                rotate(graph, *local, index, &mut reduction.substitution);
            }
        }
        let symbols = |local: u32| {
            let index = index_of.get(&local).copied().unwrap_or_default();
            [
                Symbol::Coordinate(index),
                Symbol::Velocity(index),
                Symbol::Acceleration(index),
            ]
        };
        let zero = graph.zero();
        for (local, becomes) in outcome {
            let values = match becomes {
                Becomes::Fixed(position) => [position, zero, zero],
                Becomes::As(leader) => match reduction.solved.value(leader) {
                    Some(value) => solved::combination(graph, value, symbols),
                    None => symbols(leader).map(|symbol| graph.symbol(symbol)),
                },
            };
            set(&mut reduction.substitution, local, values);
        }
        let substitution = &mut reduction.substitution;
        reduction.unwrapped_angles =
            counted::replace(resolver, self.tree, self.joints, substitution);
        counted::renumber(resolver, &reduction.unwrapped_angles, substitution);
        reduction.twists = self.walk(resolver, substitution);
    }

    fn walk(&self, resolver: &mut Resolver, substitution: &mut Substitution) -> Vec<BodyTwist> {
        let walk = Walk {
            graph: &mut resolver.graph,
            world: resolver.world,
            parts: &resolver.parts,
            substitution,
        };
        { walk }.run(self.tree)
    }
}

fn set(substitution: &mut Substitution, local: u32, values: [Expr; 3]) {
    for (symbol, value) in solved::local_symbols(local).into_iter().zip(values) {
        substitution.insert(symbol, value);
    }
}

/// A local that stays becomes the next generalized coordinate.
fn keep(graph: &mut Graph, local: u32, name: &str, kept: &mut Vec<(u32, String)>) -> u32 {
    let index = kept.len() as u32;
    kept.push((local, name.to_owned()));
    graph.set_name(Symbol::Coordinate(index), name);
    graph.set_name(Symbol::Velocity(index), format!("{name}'"));
    graph.set_name(Symbol::Acceleration(index), format!("{name}''"));
    index
}

/// The entries of a part's rotation matrix become those of a generalized rotation.
fn rotate(graph: &mut Graph, local: u32, index: u32, substitution: &mut Substitution) {
    for entry in 0..9u8 {
        let name = graph.name(Symbol::LocalRotation(local, entry));
        let symbol = Symbol::Rotation(index, entry);
        graph.set_name(symbol, name);
        let value = graph.symbol(symbol);
        substitution.insert(Symbol::LocalRotation(local, entry), value);
    }
}
