//! The reduction: points that a revolute joins become one, and points joined to the ground become constants.

use super::elements::JointElement;
use super::geometry::{Owner, Point, Vector};
use super::kinematics::Walk;
use super::parts::Part;
use super::resolve::Resolver;
use super::solved::{self, Solved};
use super::tree::{Motion, Tree};
use crate::symbolic::{Expr, Graph, Substitution, Symbol};
use std::collections::BTreeMap;

/// A joint that left no row: its points were merged.
#[derive(Debug, Clone)]
pub struct MergedJoint {
    /// The joint's name.
    pub joint: String,
    /// The force on the child is what these points need from their surroundings: the first local coordinates of the
    /// ends of parts on the child's side. Empty where the child is the ground; then `parent` is taken with the opposite sign.
    pub child: Vec<u32>,
    /// The same for the parent's side.
    pub parent: Vec<u32>,
}

/// The outcome of the reduction.
pub(super) struct Reduction {
    pub substitution: Substitution,
    pub merged: Vec<MergedJoint>,
    pub sentences: Vec<String>,
    /// Velocities of the parts that the tree carries.
    pub motions: Vec<Motion>,
    /// Rows that were solved, and the coordinates that followed from them.
    pub solved: Solved,
    /// Joints of the tree: they left no rows.
    carried: Vec<String>,
    /// Local coordinates that stay, in order: (local, name).
    kept: Vec<(u32, String)>,
}

/// A set of joined points: ends of parts, and at most one place of the ground.
#[derive(Default)]
struct Cluster {
    ends: Vec<u32>,
    ground: Option<Vector>,
    joints: Vec<usize>,
}

/// Merges what revolutes between free points join.
pub(super) fn reduce(
    resolver: &mut Resolver,
    joints: &[JointElement],
    tree: &Tree,
) -> Option<Reduction> {
    let mut clusters = Clusters::default();
    for (index, element) in joints.iter().enumerate() {
        let Some((parent, child)) = element.joint.merges() else {
            continue;
        };
        if !mergeable(parent) || !mergeable(child) {
            continue;
        }
        if parent.owner == Owner::Ground && child.owner == Owner::Ground {
            resolver.fail::<()>(
                element.span,
                "this joint joins the ground with itself; remove it",
            );
            continue;
        }
        if let Err(message) = clusters.join(parent, child, index, joints) {
            resolver.fail::<()>(element.span, message);
        }
    }
    if !resolver.errors.is_empty() {
        return None;
    }
    let mut reduction = Reduction {
        substitution: Substitution::default(),
        merged: Vec::new(),
        sentences: Vec::new(),
        motions: Vec::new(),
        solved: Solved::default(),
        carried: tree
            .joints
            .iter()
            .map(|joint| joint.joint.clone())
            .collect(),
        kept: Vec::new(),
    };
    let mut leaders: BTreeMap<u32, u32> = BTreeMap::new();
    let mut fixed: BTreeMap<u32, Vector> = BTreeMap::new();
    for cluster in &clusters.list {
        // Of joined clusters one is left empty.
        let Some(&leader) = cluster.ends.iter().min() else {
            continue;
        };
        for &end in &cluster.ends {
            match cluster.ground {
                Some(place) => fixed.extend([(end, place)]),
                None => leaders.extend([(end, leader)]),
            }
        }
        describe(resolver, cluster, leader, joints, &mut reduction.sentences);
        for &joint in &cluster.joints {
            reduction.merged.push(sides(cluster, joint, joints));
        }
    }
    let merged = Merged {
        leaders: &leaders,
        fixed: &fixed,
        tree,
    };
    let (by_leaders, free) = merged.by_leaders(resolver);
    reduction.solved = solved::solve(resolver, joints, &mut reduction, by_leaders, free);
    merged.by_coordinates(resolver, &mut reduction);
    Some(reduction)
}

/// A point that is a pair of coordinates, or a place of the ground.
pub(super) fn mergeable(point: &Point) -> bool {
    point.free.is_some() || point.owner == Owner::Ground
}

#[derive(Default)]
struct Clusters {
    list: Vec<Cluster>,
}

impl Clusters {
    fn find(&mut self, point: &Point) -> usize {
        let found = match point.free {
            Some(end) => self
                .list
                .iter()
                .position(|cluster| cluster.ends.contains(&end)),
            None => self
                .list
                .iter()
                .position(|cluster| cluster.ground == Some(point.position)),
        };
        found.unwrap_or_else(|| {
            let mut cluster = Cluster::default();
            match point.free {
                Some(end) => cluster.ends.push(end),
                None => cluster.ground = Some(point.position),
            }
            self.list.push(cluster);
            self.list.len() - 1
        })
    }

    fn join(
        &mut self,
        parent: &Point,
        child: &Point,
        joint: usize,
        joints: &[JointElement],
    ) -> Result<(), String> {
        let (a, b) = (self.find(parent), self.find(child));
        if a == b {
            let others: Vec<_> = self.list[a]
                .joints
                .iter()
                .map(|&index| format!("`{}`", joints[index].name))
                .collect();
            return Err(format!(
                "`{}` and `{}` are joined already by {}; remove this joint",
                parent.label,
                child.label,
                others.join(" and ")
            ));
        }
        if self.list[a].ground.is_some() && self.list[b].ground.is_some() {
            return Err(format!(
                "`{}` and `{}` are both held by the ground, at different places: this joint cannot close",
                parent.label, child.label
            ));
        }
        let moved = std::mem::take(&mut self.list[b]);
        let cluster = &mut self.list[a];
        cluster.ends.extend(moved.ends);
        cluster.joints.extend(moved.joints);
        cluster.joints.push(joint);
        cluster.ground = cluster.ground.or(moved.ground);
        Ok(())
    }
}

fn describe(
    resolver: &Resolver,
    cluster: &Cluster,
    leader: u32,
    joints: &[JointElement],
    sentences: &mut Vec<String>,
) {
    if cluster.joints.is_empty() {
        return;
    }
    let point = |end: u32| {
        let name = &resolver.locals[end as usize].name;
        name.trim_end_matches(".x").to_owned()
    };
    let names: Vec<_> = cluster
        .joints
        .iter()
        .map(|&joint| format!("`{}`", joints[joint].name))
        .collect();
    let ends: Vec<_> = cluster.ends.iter().map(|&end| point(end)).collect();
    sentences.push(match cluster.ground {
        Some(_) => format!(
            "{}: {} held by the ground, {} coordinates and as many rows saved",
            names.join(", "),
            ends.join(", "),
            resolver.world.dimension() * ends.len()
        ),
        None => format!(
            "{}: {} are one point (`{}`), {} coordinates and as many rows saved",
            names.join(", "),
            ends.join(", "),
            point(leader),
            resolver.world.dimension() * (ends.len() - 1)
        ),
    });
}

/// Which ends are on the child's side of a joint: the joints of a cluster form a tree over its members.
fn sides(cluster: &Cluster, joint: usize, joints: &[JointElement]) -> MergedJoint {
    let pair = |index: usize| {
        joints[index]
            .joint
            .merges()
            .map(|(parent, child)| (parent.free, child.free))
    };
    let reach = |start: Option<u32>| -> Vec<u32> {
        let mut members = vec![start];
        let mut grown = true;
        while grown {
            grown = false;
            for &other in cluster.joints.iter().filter(|&&other| other != joint) {
                let Some((a, b)) = pair(other) else { continue };
                for (from, to) in [(a, b), (b, a)] {
                    if members.contains(&from) && !members.contains(&to) {
                        members.push(to);
                        grown = true;
                    }
                }
            }
        }
        if members.contains(&None) {
            Vec::new()
        } else {
            members.into_iter().flatten().collect()
        }
    };
    let (parent, child) = pair(joint).unwrap_or_default();
    MergedJoint {
        joint: joints[joint].name.clone(),
        child: reach(child),
        parent: reach(parent),
    }
}

/// What became of the local coordinates of points that are joined.
struct Merged<'a> {
    /// The first coordinate of each end, and that of the end that stands for it.
    leaders: &'a BTreeMap<u32, u32>,
    /// Ends that the ground holds.
    fixed: &'a BTreeMap<u32, Vector>,
    tree: &'a Tree,
}

/// A local coordinate after points were merged.
enum Place {
    Fixed(Expr),
    /// As this local coordinate.
    As(u32),
}

impl Merged<'_> {
    /// All locals but those that the tree carries, each with its place.
    fn places(&self, resolver: &Resolver) -> Vec<(u32, Place)> {
        let mut places = Vec::new();
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
                let place = match self.fixed.get(&first) {
                    Some(place) => Place::Fixed(place[component]),
                    None => Place::As(leader.map_or(local, |leader| leader + component as u32)),
                };
                places.push((local, place));
            }
        }
        places.extend(self.tree.locals().map(|local| (local, Place::As(local))));
        places
    }

    /// Local coordinates in terms of those that stand for them, and the number of the latter.
    fn by_leaders(&self, resolver: &mut Resolver) -> (Substitution, usize) {
        let mut substitution = Substitution::default();
        let mut free = 0;
        for (local, place) in self.places(resolver) {
            let graph = &mut resolver.graph;
            match place {
                Place::As(leader) if leader == local => free += 1,
                Place::As(leader) => set(
                    &mut substitution,
                    local,
                    solved::local_symbols(leader).map(|symbol| graph.symbol(symbol)),
                ),
                Place::Fixed(place) => {
                    let zero = graph.zero();
                    set(&mut substitution, local, [place, zero, zero]);
                }
            }
        }
        self.walk(resolver, &mut substitution);
        (substitution, free)
    }

    /// Local coordinates in terms of generalized ones.
    fn by_coordinates(&self, resolver: &mut Resolver, reduction: &mut Reduction) {
        let places = self.places(resolver);
        let rotations: Vec<u32> = resolver.parts.iter().filter_map(Part::rotation).collect();
        let graph = &mut resolver.graph;
        let mut index_of: BTreeMap<u32, u32> = BTreeMap::new();
        for (local, place) in &places {
            let Place::As(leader) = *place else { continue };
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
        for (local, place) in places {
            let values = match place {
                Place::Fixed(place) => [place, zero, zero],
                Place::As(leader) => match reduction.solved.value(leader) {
                    Some(value) => solved::combination(graph, value, symbols),
                    None => symbols(leader).map(|symbol| graph.symbol(symbol)),
                },
            };
            set(&mut reduction.substitution, local, values);
        }
        reduction.motions = self.walk(resolver, &mut reduction.substitution);
    }

    fn walk(&self, resolver: &mut Resolver, substitution: &mut Substitution) -> Vec<Motion> {
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

impl Reduction {
    /// Whether a joint left no row.
    pub(super) fn dissolved(&self, joint: &str) -> bool {
        self.merged.iter().any(|merged| merged.joint == joint)
            || self.carried.iter().any(|carried| carried == joint)
    }

    /// The generalized coordinate with which a local one moves; `None` if it is held, or moves with several.
    pub(super) fn coordinate_of(&self, graph: &Graph, local: u32) -> Option<u32> {
        let value = self.substitution.get(Symbol::LocalPosition(local));
        let symbols = graph.symbols(value).into_iter();
        let mut indices = symbols.filter_map(|symbol| match symbol {
            Symbol::Coordinate(index) => Some(index),
            _ => None,
        });
        indices.next().filter(|_| indices.next().is_none())
    }

    /// The local coordinates that stay, with their names.
    pub(super) fn kept(&self) -> &[(u32, String)] {
        &self.kept
    }
}
